// What is known of whether a pair touches, and when, before its place and its normal are.
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

  /// Of parts of the step, the earliest first. One that may hold a contact stays when one that does follows: as the
  /// lower end. REQUIRES: none before does.
  void add_unsure(double from, double until) {
    if (is_free()) *this = {Verdict::unsure, from, until};
    upper = std::max(upper, until);
  }
  void add_contact(double from, double until) { *this = {Verdict::touches, is_free() ? from : lower, until}; }
};

}  // namespace tamis
