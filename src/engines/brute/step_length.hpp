// Step lengths that keep a fraction of every distance, from every pair.
#pragma once
#include "engines/step_limit.hpp"
#include "motion/separations.hpp"
#include "tamis/contact.hpp"
#include "tamis/mesh.hpp"
#include "tamis/options.hpp"
#include "tamis/statistics.hpp"
#include "tamis/step.hpp"

namespace tamis {

/// By looking at every pair: the tests' yardstick.
SafeStep step_length_by_brute_force(const Mesh& mesh, const Options& options, const Step& step,
                                    const Separations& separations, double fraction, Statistics& statistics);

/// As StepLengthSearch::find_all.
void step_ends_by_brute_force(const Mesh& mesh, const Options& options, const Step& step,
                              const Separations& separations, double fraction, std::vector<StepLimit>& ends,
                              Statistics& statistics);

}  // namespace tamis
