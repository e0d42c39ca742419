#include "detect/truncation.hpp"

#include <algorithm>

namespace tamis {

Truncation::Truncation(const Step& step, VertexSteps steps)
    : step_(step), steps_(std::move(steps)), positions_(steps_.until.size()) {
  place_all();
}

void Truncation::place_all() {
  for (std::size_t v = 0; v < positions_.size(); ++v) {
    const double t = steps_.until[v];
    const double *start = step_.start[static_cast<Index>(v)], *end = step_.end[static_cast<Index>(v)];
    for (std::size_t k = 0; k < 3; ++k)
      positions_[v][k] = t == 1 ? end[k] : t == 0 ? start[k] : (1 - t) * start[k] + t * end[k];
  }
}

void Truncation::pull_back(const std::vector<Contact>& contacts) {
  constexpr int kOneByOne = 8;      // rounds in which only what touches goes back
  constexpr int kAllTogether = 64;  // then all, half as far each time
  is_free_ = contacts.empty();
  goes_on_ = !is_free_ && steps_.together > 0;
  if (is_free_) return;
  if (++rounds_ < kOneByOne) {
    goes_on_ = true;
    for (const Contact& contact : contacts)
      for (const Index v : contact.vertices)
        if (v >= 0) steps_.until[static_cast<std::size_t>(v)] = steps_.together;
  } else {
    if (rounds_ > kOneByOne) steps_.together = rounds_ < kAllTogether ? 0.5 * steps_.together : 0;
    std::fill(steps_.until.begin(), steps_.until.end(), steps_.together);
    goes_on_ = goes_on_ || rounds_ == kOneByOne;
  }
  place_all();
}

}  // namespace tamis
