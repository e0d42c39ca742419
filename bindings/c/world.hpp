// The handles of shapes and of a world.
#pragma once
#include <span>

#include "c/asked.hpp"
#include "c/poses.hpp"
#include "tamis/world.hpp"

struct tamis_shape : tamis::c::Handle<std::optional<tamis::Shape>> {};

struct tamis_world
    : tamis::c::AskedHandle<tamis::World, tamis::BodyContact, tamis::BodyNearPair, tamis::BodyIntersection> {};

namespace tamis::c {

inline std::span<const BodyId> bodies_of(const int32_t* bodies, std::size_t count, const char* name) {
  check_count(count, name);
  return {array(bodies, count, "bodies"), count};
}

}  // namespace tamis::c
