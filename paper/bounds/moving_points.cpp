#include "paper/bounds/moving_points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "numbers/assert.hpp"
#include "numbers/scale.hpp"

namespace tamis::lab {
namespace {

Vec3<double> scaled(const double* p, double scale) { return {scale * p[0], scale * p[1], scale * p[2]}; }

double largest_coordinate(const Mesh& mesh, const Step& step) {
  double size = 0;
  for (Index v : mesh.points())
    for (int axis = 0; axis < 3; ++axis)
      size = std::max({size, std::fabs(step.start[v][axis]), std::fabs(step.end[v][axis])});
  return size;
}

}  // namespace

void MovingPoints::update(const Mesh& mesh, const Step& step) {
  TAMIS_ASSERT(step.start.count() == mesh.vertex_count() && step.end.count() == mesh.vertex_count());
  scale_ = scale_below_one(largest_coordinate(mesh, step));
  points_.resize(static_cast<std::size_t>(mesh.vertex_count()));
  constexpr double kHuge = std::numeric_limits<double>::max();
  Vec3<double> low{kHuge, kHuge, kHuge}, high{-kHuge, -kHuge, -kHuge};
  for (Index v : mesh.points()) {
    Moving<double>& p = points_[static_cast<std::size_t>(v)];
    p = {scaled(step.start[v], scale_), scaled(step.end[v], scale_)};
    for (const auto& at : {p.at0, p.at1}) {
      low = {std::min(low.x, at.x), std::min(low.y, at.y), std::min(low.z, at.z)};
      high = {std::max(high.x, at.x), std::max(high.y, at.y), std::max(high.z, at.z)};
    }
  }
  centre_ = 0.5 * (low + high);
}

}  // namespace tamis::lab
