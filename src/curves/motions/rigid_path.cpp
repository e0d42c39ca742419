#include "tamis/rigid_path.hpp"

#include <algorithm>
#include <string>

#include "curves/motions/chain_motion.hpp"
#include "curves/motions/fine_point.hpp"
#include "curves/motions/rigid_transform.hpp"
#include "numbers/floating_point_state.hpp"
#include "search/topology/at.hpp"
#include "tamis/error.hpp"

namespace tamis {
namespace {

void validate(const std::vector<Point>& rest, const std::vector<Index>& body_of_vertex,
              const std::vector<RigidChain>& chains, const std::vector<Point>& rest_end) {
  if (rest.size() != body_of_vertex.size())
    throw InvalidPath("the path has " + std::to_string(rest.size()) + " rest positions and " +
                      std::to_string(body_of_vertex.size()) + " numbers of bodies: give one each a vertex");
  if (rest.size() != rest_end.size())
    throw InvalidPath("the path has " + std::to_string(rest.size()) + " rest positions and " +
                      std::to_string(rest_end.size()) + " at the end: give one each a vertex, or none at the end");
  for (std::size_t v = 0; v < rest.size(); ++v) {
    if (!is_finite(rest[v]) || !is_finite(rest_end[v]))
      throw InvalidPath("vertex " + std::to_string(v) + " of the path is not finite at rest: give finite positions");
    if (body_of_vertex[v] < 0 || at(body_of_vertex[v]) >= chains.size())
      throw InvalidPath("vertex " + std::to_string(v) + " belongs to body " + std::to_string(body_of_vertex[v]) +
                        ": bodies must be in [0, " + std::to_string(chains.size()) + ")");
  }
  for (std::size_t b = 0; b < chains.size(); ++b)
    for (const RigidLink& link : chains[b])
      if (!is_finite(link.start) || !is_finite(link.end))
        throw InvalidPath("a pose of body " + std::to_string(b) +
                          " is not finite: give finite positions and rotation vectors");
}

}  // namespace

struct RigidPath::Motion {
  Motion(std::vector<Point> r, std::vector<Index> body_of_each, std::vector<RigidChain> c, std::vector<Point> end)
      : rest(std::move(r)),
        rest_end(end.empty() ? rest : std::move(end)),
        body_of_vertex(std::move(body_of_each)),
        chains(std::move(c)) {
    validate(rest, body_of_vertex, chains, rest_end);
    const std::vector<ChainBounds> bounds(chains.begin(), chains.end());
    for (const RigidChain& chain : chains) axes.push_back(fixed_axis(chain));
    for (std::size_t v = 0; v < rest.size(); ++v) {
      const double displacement = rest[v] == rest_end[v] ? 0 : change(rest[v], rest_end[v]);
      curves.push_back(bounds[at(body_of_vertex[v])].of(farthest(rest[v], rest_end[v]), displacement));
    }
  }

  std::vector<Point> rest, rest_end;
  std::vector<Index> body_of_vertex;
  std::vector<RigidChain> chains;
  std::vector<Point> axes;        ///< of each chain
  std::vector<Curvature> curves;  ///< of each vertex
};

RigidPath::RigidPath(std::vector<Point> rest, std::vector<Index> body_of_vertex, std::vector<RigidChain> chains,
                     std::vector<Point> rest_end)
    : motion_(computing([&] {
        return std::make_shared<const Motion>(std::move(rest), std::move(body_of_vertex), std::move(chains),
                                              std::move(rest_end));
      })) {}

Index RigidPath::vertex_count() const { return static_cast<Index>(motion_->rest.size()); }

namespace {

/// Calls f(i, v) for each place i in `vertices` and the vertex v there. Before, whenever the body changes, begin(body).
template <class Begin, class F>
void for_each_of_body(std::span<const Index> vertices, const std::vector<Index>& body_of_vertex, const Begin& begin,
                      const F& f) {
  Index body = -1;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const auto v = at(vertices[i]);
    if (body_of_vertex[v] != body) begin(at(body = body_of_vertex[v]));
    f(i, v);
  }
}

}  // namespace

void RigidPath::points_at(double time, std::span<const Index> vertices, std::span<Point> points,
                          std::span<double> errors) const {
  const ComputingState state;
  RoundedTransform transform{};
  const auto begin = [&](std::size_t body) { transform = transform_at(motion_->chains[body], time); };
  for_each_of_body(vertices, motion_->body_of_vertex, begin, [&](std::size_t i, std::size_t v) {
    const RoundedPlace place = rounded_linear(motion_->rest[v], motion_->rest_end[v], time);
    points[i] = transform.of(place.x);
    errors[i] = transform.error_of(sum_of_sizes(place.x), place.error);
  });
}

void RigidPath::fine_points_at(double time, std::span<const Index> vertices, std::span<FinePoint> points) const {
  const ComputingState state;
  RigidTransform transform;
  const auto begin = [&](std::size_t body) { transform = transform_of(motion_->chains[body], time); };
  for_each_of_body(vertices, motion_->body_of_vertex, begin, [&](std::size_t i, std::size_t v) {
    points[i] = fine_point(transform.rows * linear(motion_->rest[v], motion_->rest_end[v], time) + transform.shift);
  });
}

void RigidPath::deviations(double from, double to, std::span<const Index> vertices,
                           std::span<double> deviations) const {
  const ComputingState state;
  const Interval factor = chord_factor(Interval(to) - Interval(from));
  for (std::size_t i = 0; i < vertices.size(); ++i) deviations[i] = motion_->curves[at(vertices[i])].deviation(factor);
}

void RigidPath::straight_directions(std::span<const Index> vertices, std::span<Point> directions) const {
  for (std::size_t i = 0; i < vertices.size(); ++i)
    directions[i] = motion_->axes[at(motion_->body_of_vertex[at(vertices[i])])];
}

std::optional<CarriedPath> RigidPath::carried(std::span<const Index> vertices) const {
  const ComputingState state;
  const std::vector<Point>&rest = motion_->rest, &rest_end = motion_->rest_end;
  const std::vector<Index>& body_of_vertex = motion_->body_of_vertex;
  const auto chain_of = [&](Index v) -> const RigidChain& { return motion_->chains[at(body_of_vertex[at(v)])]; };
  const RigidChain& first = chain_of(vertices.front());
  std::size_t shared = first.size();
  for (const Index v : vertices) shared = std::min(shared, shared_links(first, chain_of(v)));
  const auto stays = [&](Index v) {
    const auto inner = std::span(chain_of(v)).subspan(shared);
    return rest[at(v)] == rest_end[at(v)] &&
           std::ranges::all_of(inner, [](const RigidLink& link) { return link.start == link.end; });
  };
  const bool is_still = std::ranges::all_of(vertices, stays);
  if (shared == 0 && !is_still) return std::nullopt;

  std::vector<Point> inner_rest, inner_end;
  std::vector<Index> body_of_each;
  std::vector<RigidChain> inner_chains;
  for (const Index v : vertices) {
    if (inner_chains.empty() || body_of_vertex[at(v)] != body_of_vertex[at(vertices[body_of_each.size() - 1])])
      inner_chains.push_back(without(chain_of(v), shared));
    inner_rest.push_back(rest[at(v)]);
    inner_end.push_back(rest_end[at(v)]);
    body_of_each.push_back(static_cast<Index>(inner_chains.size()) - 1);
  }
  RigidChain carrier(first.begin(), first.begin() + static_cast<std::ptrdiff_t>(shared));
  return CarriedPath{std::make_shared<RigidPath>(std::move(inner_rest), std::move(body_of_each),
                                                 std::move(inner_chains), std::move(inner_end)),
                     is_still, [carrier = std::move(carrier)](double time, const Point& direction) {
                       return turned_by(carrier, time, direction);
                     }};
}

}  // namespace tamis
