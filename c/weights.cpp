#include <algorithm>
#include <array>

#include "c/kind.hpp"

using namespace tamis::c;

tamis_status tamis_weights_of(int32_t kind, double u, double v, double* weights) {
  Outcome outcome;
  return attempt(outcome, [&] {
    double* to = &required(weights, "weights");
    const std::array<double, 4> answer = tamis::weights_of(known_kind(kind), u, v);
    std::copy(answer.begin(), answer.end(), to);
  });
}
