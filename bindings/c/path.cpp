// Makes ready-made paths, and paths that the caller's functions describe.
#include "c/path.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "c/poses.hpp"
#include "tamis/spline_path.hpp"

namespace tamis::c {
namespace {

tamis_pose to_c(const Pose& pose) {
  const Point &p = pose.position, &r = pose.rotation;
  return {{p[0], p[1], p[2]}, {r[0], r[1], r[2]}};
}

bool is_finite(const Pose& pose) {
  const auto all_finite = [](const Point& p) {
    return std::all_of(p.begin(), p.end(), [](double x) { return std::isfinite(x); });
  };
  return all_finite(pose.position) && all_finite(pose.rotation);
}

std::size_t vertices(int32_t count) {
  if (count < 0) throw InvalidPath("vertex_count is " + std::to_string(count) + ": give a number >= 0");
  return static_cast<std::size_t>(count);
}

std::vector<RigidChain> chains_of(const tamis_rigid_path_input& input) {
  check_count(input.body_count, "body_count");
  const std::size_t* counts = array(input.links_of_body, input.body_count, "links_of_body");
  std::vector<RigidChain> chains;
  const tamis_rigid_link* link = input.links;
  for (std::size_t body = 0; body < input.body_count; link += counts[body++]) {
    check_count(counts[body], "an entry of links_of_body");
    chains.push_back(chain_of(array(link, counts[body], "links"), counts[body]));
  }
  return chains;
}

RigidPath rigid_path_of(const tamis_rigid_path_input& input) {
  const std::size_t count = vertices(input.vertex_count);
  const int32_t* bodies = array(input.body_of_vertex, count, "body_of_vertex");
  auto rest_end = input.rest_end ? point_rows(input.rest_end, count, "rest_end") : std::vector<Point>{};
  return {point_rows(input.rest, count, "rest"), {bodies, bodies + count}, chains_of(input), std::move(rest_end)};
}

std::vector<std::vector<Point>> frames_of(const tamis_spline_path_input& input) {
  const std::size_t count = vertices(input.vertex_count);
  check_count(input.frame_count, "frame_count");
  std::vector<std::vector<Point>> frames;
  frames.reserve(input.frame_count);
  for (std::size_t i = 0; i < input.frame_count; ++i)
    frames.push_back(point_rows(array(input.frames, count, "frames") + 3 * count * i, count, "frames"));
  return frames;
}

template <class Spline>
tamis_status create_spline(const tamis_spline_path_input* input, tamis_path** path) noexcept {
  return make_handle(path, [&](tamis_path& handle) {
    handle.object = std::make_unique<const Spline>(frames_of(read_sized(input, "input")));
  });
}

/// A path that calls the caller's functions.
class FunctionPath final : public Path {
 public:
  explicit FunctionPath(const tamis_path_functions& functions) : functions_(functions) {
    vertices(functions.vertex_count);
    required(functions.points_at, "points_at");
    required(functions.deviations, "deviations");
  }

  Index vertex_count() const override { return functions_.vertex_count; }
  void points_at(double time, std::span<const Index> vertices, std::span<Point> points,
                 std::span<double> errors) const override {
    functions_.points_at(functions_.user, time, vertices.data(), vertices.size(), points.data()->data(), errors.data());
  }
  void deviations(double from, double to, std::span<const Index> vertices,
                  std::span<double> deviations) const override {
    functions_.deviations(functions_.user, from, to, vertices.data(), vertices.size(), deviations.data());
  }

 private:
  tamis_path_functions functions_;
};

Point center_of(const double* center) { return center ? point_of(center) : Point{0, 0, 0}; }

/// Writes the pose that `make(position)` returns, in a call without a handle.
template <class Make>
tamis_status write_pose(tamis_pose* pose, const double* position, const Make& make) noexcept {
  Outcome outcome;
  return attempt(outcome, [&] {
    const Pose made = make(point_of(&required(position, "position")));
    if (!is_finite(made)) throw InvalidPath("the position is not finite: give finite numbers");
    required(pose, "pose") = to_c(made);
  });
}

/// Writes the chain that `make` returns, in a call without a handle.
template <class Make>
tamis_status write_chain(tamis_rigid_link* links, const Make& make) noexcept {
  Outcome outcome;
  return attempt(outcome, [&] {
    tamis_rigid_link* to = &required(links, "links");
    for (const RigidLink& link : make()) {
      if (!is_finite(link.start) || !is_finite(link.end))
        throw InvalidPath("a pose or a turn is not finite: give finite numbers");
      *to++ = {to_c(link.start), to_c(link.end)};
    }
  });
}

}  // namespace
}  // namespace tamis::c

using namespace tamis::c;

tamis_status tamis_turned_chain(const tamis_pose* start, const double* turn, const double* end_position,
                                const double* center, tamis_rigid_link* links) {
  return write_chain(links, [&] {
    const double &axis = required(turn, "turn"), &end = required(end_position, "end_position");
    return tamis::turned_chain(pose_of(required(start, "start")), point_of(&axis), point_of(&end), center_of(center));
  });
}

tamis_status tamis_chain_between(const tamis_pose* start, const tamis_pose* end, const double* center,
                                 tamis_rigid_link* links) {
  return write_chain(links, [&] {
    return tamis::chain_between(pose_of(required(start, "start")), pose_of(required(end, "end")), center_of(center));
  });
}

tamis_status tamis_pose_at(const tamis_rigid_link* links, size_t count, double time, tamis_pose* pose) {
  Outcome outcome;
  return attempt(outcome, [&] {
    required(pose, "pose") = to_c(tamis::pose_at(chain_of(array(links, count, "links"), count), time));
  });
}

tamis_status tamis_nlerp_deviation(const tamis_pose* start, const tamis_pose* end, double* part) {
  Outcome outcome;
  return attempt(outcome, [&] {
    required(part, "part") = tamis::nlerp_deviation(pose_of(required(start, "start")), pose_of(required(end, "end")));
  });
}

tamis_status tamis_pose_of_quaternion(const double* quaternion, const double* position, tamis_pose* pose) {
  return write_pose(pose, position, [&](const tamis::Point& at) {
    const double* q = &required(quaternion, "quaternion");
    return tamis::pose_of_quaternion({q[0], q[1], q[2], q[3]}, at);
  });
}

tamis_status tamis_pose_of_matrix(const double* rows, const double* position, tamis_pose* pose) {
  return write_pose(pose, position, [&](const tamis::Point& at) {
    const double* r = &required(rows, "rows");
    return tamis::pose_of_matrix({point_of(r), point_of(r + 3), point_of(r + 6)}, at);
  });
}

tamis_status tamis_rigid_path_create(const tamis_rigid_path_input* input, tamis_path** path) {
  return make_handle(path, [&](tamis_path& handle) {
    handle.object = std::make_unique<const tamis::RigidPath>(rigid_path_of(read_sized(input, "input")));
  });
}

tamis_status tamis_bezier_path_create(const tamis_spline_path_input* input, tamis_path** path) {
  return create_spline<tamis::BezierPath>(input, path);
}

tamis_status tamis_catmull_rom_path_create(const tamis_spline_path_input* input, tamis_path** path) {
  return create_spline<tamis::CatmullRomPath>(input, path);
}

tamis_status tamis_function_path_create(const tamis_path_functions* functions, tamis_path** path) {
  return make_handle(path, [&](tamis_path& handle) {
    handle.object = std::make_unique<const FunctionPath>(read_sized(functions, "functions"));
  });
}

void tamis_path_free(tamis_path* path) { delete path; }

const char* tamis_path_message(const tamis_path* path) { return message_of(path); }
