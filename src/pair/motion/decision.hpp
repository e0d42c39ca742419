// Whether a pair touches, and when, as far as that is known. Place and normal are found later.
#pragma once
#include <algorithm>
#include <cstdint>

namespace tamis {

enum class Verdict : std::uint8_t { is_free, touches, unsure };

/// Times of the step. The pair is apart on [0, lower); `touches`: it touches within [lower, upper].
struct Decision {
  Verdict verdict = Verdict::is_free;
  double lower = 1, upper = 1;

  bool is_free() const { return verdict == Verdict::is_free; }
  bool touches() const { return verdict == Verdict::touches; }

  /// Adds a part of the step that may hold a contact, or one that does. Parts come in the order of time. The bracket of
  /// a contact begins at the first unsure part before it. REQUIRES: no contact was added.
  void add_unsure(double from, double until) {
    if (is_free()) *this = {Verdict::unsure, from, until};
    upper = std::max(upper, until);
  }
  void add_contact(double from, double until) { *this = {Verdict::touches, is_free() ? from : lower, until}; }
};

}  // namespace tamis
