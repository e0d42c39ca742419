// OMPL with Tamis: states without overlap, and motions that are proven. For Debian's libompl-dev; Python has
// tamis.robots.ompl.
#pragma once
#include <ompl/base/MotionValidator.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/StateValidityChecker.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>

#include <memory>
#include <span>
#include <stdexcept>
#include <string>

#include "tamis/linkage.hpp"

namespace tamis::planning {

/// A world, and the linkage that a plan moves in it. Keeps a reference to both. One thread at a time may ask.
struct PlannedWorld {
  World& world;
  const Linkage& linkage;
  EdgeOptions options = {};  ///< of every question; `starts_are_free` is set where OMPL has tested the start

  /// Returns the numbers of a state of a RealVectorStateSpace.
  [[nodiscard]] std::span<const double> numbers(const ompl::base::State* state) const {
    return {state->as<ompl::base::RealVectorStateSpace::StateType>()->values, linkage.dimension()};
  }
};

/// Throws std::invalid_argument unless the space is a RealVectorStateSpace with a number for each coordinate.
inline void check_space(const ompl::base::SpaceInformationPtr& information, const Linkage& linkage) {
  const auto* space = dynamic_cast<const ompl::base::RealVectorStateSpace*>(information->getStateSpace().get());
  if (!space || space->getDimension() != linkage.dimension())
    throw std::invalid_argument("the planner's space is no RealVectorStateSpace of " +
                                std::to_string(linkage.dimension()) + " numbers: make one, a number each coordinate");
}

/// Tests states: nothing overlaps and nothing touches. A link inside an obstacle overlaps it.
class StateChecker : public ompl::base::StateValidityChecker {
 public:
  StateChecker(const ompl::base::SpaceInformationPtr& information, PlannedWorld planned)
      : StateValidityChecker(information), planned_(planned) {
    check_space(information, planned.linkage);
  }

  bool isValid(const ompl::base::State* state) const override {
    if (!si_->satisfiesBounds(state)) return false;
    return planned_.world.configurations_are_free(planned_.linkage, planned_.numbers(state), planned_.options)[0];
  }

 private:
  PlannedWorld planned_;
};

/// Proves motions free, on which each number goes linearly. As OMPL has it, the start of a motion is valid already.
class MotionValidator : public ompl::base::MotionValidator {
 public:
  MotionValidator(const ompl::base::SpaceInformationPtr& information, PlannedWorld planned)
      : ompl::base::MotionValidator(information), planned_(planned) {
    check_space(information, planned.linkage);
    planned_.options.starts_are_free = true;
  }

  bool checkMotion(const ompl::base::State* from, const ompl::base::State* to) const override {
    return counted(planned_.world.edges_are_free(planned_.linkage, planned_.numbers(from), planned_.numbers(to),
                                                 planned_.options)[0]);
  }

  /// The last valid state is a little before the contact, where the motion is proven free.
  bool checkMotion(const ompl::base::State* from, const ompl::base::State* to,
                   std::pair<ompl::base::State*, double>& last_valid) const override {
    const EdgeAnswer answer =
        planned_.world.last_valid(planned_.linkage, planned_.numbers(from), planned_.numbers(to), planned_.options)[0];
    if (!answer.is_free()) {
      last_valid.second = answer.fraction * (1 - 1e-6);
      if (last_valid.first) si_->getStateSpace()->interpolate(from, to, last_valid.second, last_valid.first);
    }
    return counted(answer.is_free());
  }

 private:
  bool counted(bool is_free) const {
    ++(is_free ? valid_ : invalid_);
    return is_free;
  }

  PlannedWorld planned_;
};

/// Makes a planner's space test states and prove motions in this world.
inline void set_world(const ompl::base::SpaceInformationPtr& information, const PlannedWorld& planned) {
  information->setStateValidityChecker(std::make_shared<StateChecker>(information, planned));
  information->setMotionValidator(std::make_shared<MotionValidator>(information, planned));
}

}  // namespace tamis::planning
