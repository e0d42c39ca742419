// What every reader promises, whatever the bytes.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <string_view>

#include "files/error.hpp"
#include "files/mesh/mesh_file.hpp"
#include "fuzz/require.hpp"

namespace tamis::fuzz {

/// Reads; a refusal is one line of printable text. Any other exception ends the fuzzer.
template <class Read>
void check_reader(const std::uint8_t* data, std::size_t size, const Read& read) {
  try {
    read(std::string_view(reinterpret_cast<const char*>(data), size));
  } catch (const io::FileError& refusal) {
    const std::string_view text = refusal.what();
    require(std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c <= '~'; }),
            "a message that is not one printable line", [&] { return text; });
  }
}

inline void check_finite(std::span<const Point> points) {
  for (const Point& p : points)
    require(std::all_of(p.begin(), p.end(), [](double x) { return std::isfinite(x); }), "a coordinate is not finite",
            [] { return ""; });
}

/// What MeshFile promises is what the detector needs.
inline void check_mesh(const io::MeshFile& mesh) {
  const auto check_indices = [&](std::span<const Index> indices) {
    for (const Index i : indices)
      require(i >= 0 && static_cast<std::size_t>(i) < mesh.positions.size(), "an index out of range",
              [&] { return std::to_string(i); });
    for (const Index i : indices) check_finite(std::span(mesh.positions).subspan(static_cast<std::size_t>(i), 1));
  };
  for (const Face& f : mesh.faces) check_indices(f);
  for (const Edge& e : mesh.loose_edges) check_indices(e);
  check_indices(mesh.loose_points);
}

}  // namespace tamis::fuzz
