#include "files/mesh/weld.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <unordered_map>

#include "files/mesh/loose_features.hpp"

namespace tamis::io {
namespace {

/// A cell of a grid, or a single place, among the vertices of one group.
struct Cell {
  Index group;
  std::array<double, 3> place;
  bool operator==(const Cell&) const = default;
};

struct CellHash {
  std::size_t operator()(const Cell& cell) const {
    std::uint64_t hash = static_cast<std::uint64_t>(cell.group) + 1;
    constexpr std::uint64_t kOdd = 0x9e3779b97f4a7c15;
    for (const double x : cell.place) {
      hash = (hash ^ std::bit_cast<std::uint64_t>(x)) * kOdd;
      hash ^= hash >> 29;
    }
    return static_cast<std::size_t>(hash);
  }
};

/// The first vertices of groups, found by their places.
class FirstVertices {
 public:
  FirstVertices(std::span<const Point> positions, double distance) : positions_(positions), distance_(distance) {}

  /// The earliest first vertex of this group that is near enough to v; v itself, which is then one, if there is none.
  /// A point that is not finite is near to none.
  Index of(Index group, Index v) {
    Index found = v;
    const Point& p = positions_[static_cast<std::size_t>(v)];
    if (!std::ranges::all_of(p, [](double x) { return std::isfinite(x); })) return v;
    const std::array<int, 3> offsets{0, -1, 1};
    for (const int x : offsets)
      for (const int y : offsets)
        for (const int z : offsets) {
          if (distance_ == 0 && (x != 0 || y != 0 || z != 0)) continue;
          const auto cell = cells_.find(cell_of(group, p, {x, y, z}));
          if (cell == cells_.end()) continue;
          for (const Index first : cell->second)
            if (first < found && is_near(first, v)) found = first;
        }
    if (found == v) cells_[cell_of(group, p, {0, 0, 0})].push_back(v);
    return found;
  }

 private:
  Cell cell_of(Index group, const Point& p, const std::array<int, 3>& offset) const {
    Cell cell{group, {}};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double place = distance_ == 0 ? p[axis] : std::floor(p[axis] / distance_) + offset[axis];
      cell.place[axis] = place == 0 ? 0 : place;  // -0 is the same place as 0
    }
    return cell;
  }

  bool is_near(Index a, Index b) const {
    const Point &p = positions_[static_cast<std::size_t>(a)], &q = positions_[static_cast<std::size_t>(b)];
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) <= distance_;
  }

  std::span<const Point> positions_;
  double distance_;
  std::unordered_map<Cell, std::vector<Index>, CellHash> cells_;
};

}  // namespace

Weld::Weld(std::size_t vertex_count, double distance) : distance_(distance), first_(vertex_count, 0) {}

void Weld::add_frame(std::span<const Point> positions) {
  FirstVertices firsts(positions, distance_);
  for (std::size_t v = 0; v < first_.size(); ++v) first_[v] = firsts.of(first_[v], static_cast<Index>(v));
}

std::size_t Weld::joined_count() const {
  std::size_t count = 0;
  for (std::size_t v = 0; v < first_.size(); ++v) count += first_[v] != static_cast<Index>(v);
  return count;
}

void Weld::apply_to(MeshFile& file) const {
  const auto rename = [&](Index& v) { v = first_[static_cast<std::size_t>(v)]; };
  for (Face& face : file.faces) std::ranges::for_each(face, rename);
  for (Edge& edge : file.loose_edges) std::ranges::for_each(edge, rename);
  std::ranges::for_each(file.loose_points, rename);
}

Mesh Weld::welded(const Mesh& mesh) const {
  MeshFile file;
  file.positions.resize(static_cast<std::size_t>(mesh.vertex_count()));
  file.faces.assign(mesh.faces().begin(), mesh.faces().end());
  file.loose_edges = rods_of(mesh);
  file.loose_points = loose_points_of(mesh);
  apply_to(file);
  return mesh_of(std::move(file));
}

}  // namespace tamis::io
