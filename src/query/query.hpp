// What is asked. A query goes down through the engine unchanged; answers come back in collectors.
#pragma once
#include "motion/separations.hpp"
#include "tamis/options.hpp"
#include "tamis/pair.hpp"
#include "tamis/step.hpp"

namespace tamis {

enum class Question : std::uint8_t {
  all_contacts,
  earliest,
  is_free,  ///< of intersections: is there none?
};

/// Step, radii, filter and function must outlive it.
struct Query {
  Step step;  ///< of a question about one pose: from the pose to itself
  Separations separations;
  const PairFilter& filter;
  const std::function<bool()>& is_cancelled;
  Question question = Question::all_contacts;

  /// By which a pair is decided.
  PairOptions rule_for(PairKind kind, const std::array<Index, 4>& vertices) const {
    return {.min_separation = separations.between(kind, vertices)};
  }
};

}  // namespace tamis
