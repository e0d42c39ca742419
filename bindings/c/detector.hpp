// The handle of a detector, and how it is asked about a step.
#pragma once
#include "c/asked.hpp"
#include "c/step.hpp"
#include "tamis/detector.hpp"

struct tamis_detector : tamis::c::AskedHandle<tamis::Detector, tamis::Contact, tamis::NearPair, tamis::Intersection> {};

namespace tamis::c {

/// Runs `work(handle, step, options)`.
template <class Work>
tamis_status ask(tamis_detector* handle, const tamis_step* step, const Work& work) noexcept {
  return with(handle, [&](tamis_detector& h) {
    h.contacts.clear();
    const tamis_step given = read_sized(step, "step");
    work(h, step_of(given), QueryOptions{separation(given.min_separation), at_start(given.at_start)});
  });
}

}  // namespace tamis::c
