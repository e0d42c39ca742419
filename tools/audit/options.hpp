// What a caller of an audit may choose, each with its default.
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>

#include "tamis/mesh.hpp"

namespace tamis::audit {

struct Options {
  /// For contacts, as in tamis::Options.
  double min_separation = 0;
  /// >= 0; 0: all. The report does not depend on it.
  int threads = 0;
  /// Ask for the intersections of frames.
  bool intersections = true;
  /// Ask for the contacts of steps.
  bool contacts = true;
  /// How far to search for the path between two features, in edges, in [1, 1000].
  Index ring_limit = 10;
  /// The number of pairs that the report lists at most, the first ones; all are counted.
  std::uint64_t listed_pairs = 1'000'000;
  /// Memory for the frames that the report keeps with their positions, so that they can be looked at; 0: none.
  std::size_t kept_bytes = std::size_t{256} << 20;
  /// Called now and then with the number of frames that have been asked about.
  std::function<void(std::size_t)> progress = nullptr;
  /// Called often, from several threads; true ends the audit.
  std::function<bool()> is_cancelled = nullptr;
};

/// Throws InvalidOptions.
void require_sound(const Options& options);

}  // namespace tamis::audit
