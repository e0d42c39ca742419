// The handles of shapes and of a world.
#pragma once
#include "c/asked.hpp"
#include "tamis/world.hpp"

struct tamis_shape {
  tamis::c::Outcome outcome;
  std::optional<tamis::Shape> shape;  ///< none if it could not be made
};

struct tamis_world
    : tamis::c::AskedHandle<tamis::World, tamis::BodyContact, tamis::BodyNearPair, tamis::BodyIntersection> {};
