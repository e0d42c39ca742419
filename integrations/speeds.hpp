// The speeds with which bodies end a clamped step.
#pragma once
#include <vector>

#include "integrations/carriers.hpp"
#include "integrations/clamp.hpp"

namespace tamis::adapters {

/// Takes speeds (the first part of the policy). Returns the velocities with which the next step begins.
Velocities take_speeds(WantedStep& step, const Near& near, double gap);

/// Stops bodies where they met. Bodies that met may meet at another of their near places next. REQUIRES: bodies that
/// met are in `near`.
void stop_where_met(std::vector<NearContact> hits, const Near& near, const WantedStep& step, Velocities& velocities);

/// The end of a body that goes `fraction` of its way.
BodyEnd end_of(BodyId body, const WantedStep& step, double fraction, const Velocity& velocity, double gap);

}  // namespace tamis::adapters
