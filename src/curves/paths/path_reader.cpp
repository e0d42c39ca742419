#include "curves/paths/path_reader.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "numbers/finite.hpp"
#include "numbers/number_text.hpp"
#include "numbers/scale.hpp"
#include "tamis/error.hpp"

namespace tamis {
namespace {

/// Completes a moment whose first `count` points are set.
template <class T>
Moment<T> completed(Moment<T> moment, std::size_t count) {
  using I = BasicInterval<T>;
  for (std::size_t i = count; i < 4; ++i) moment.points[i] = moment.points[0];
  for (const auto& p : moment.points)
    for (const I& x : {p.x, p.y, p.z})
      moment.error = std::max(moment.error, upper_double((I(x.upper) - I(x.lower)).upper));
  return moment;
}

/// Zero for an unbounded interval: the moment's infinite error covers that.
double finite_middle(const Interval& x) {
  const double middle = x.middle();
  return std::isfinite(middle) ? middle : 0;
}

Point middle_of(const Vec3<Interval>& p) { return {finite_middle(p.x), finite_middle(p.y), finite_middle(p.z)}; }

StraightDirection direction_of(Index vertex, const Point& given) {
  if (!is_finite(given))
    throw InvalidPath("vertex " + std::to_string(vertex) +
                      " of the path goes straight along a direction that is not finite: give a finite "
                      "one, or zeros");
  const double size = std::max({std::fabs(given[0]), std::fabs(given[1]), std::fabs(given[2])});
  if (size == 0) return {};
  const double scale = scale_below_one(size);
  const Vec3<double> d{scale * given[0], scale * given[1], scale * given[2]};
  if (Point{d.x / scale, d.y / scale, d.z / scale} != given) return {};  // scaling has lost digits
  return {d, 1 / std::sqrt(dot(d, d)) * (1 + 0x1p-48)};                  // off by 4 u without the factor
}

}  // namespace

void Path::fine_points_at(double time, std::span<const Index> vertices, std::span<FinePoint> points) const {
  std::vector<Point> high(vertices.size());
  std::vector<double> errors(vertices.size());
  points_at(time, vertices, high, errors);
  for (std::size_t i = 0; i < vertices.size(); ++i) points[i] = {high[i], {0, 0, 0}, errors[i]};
}

void Path::straight_directions(std::span<const Index>, std::span<Point> directions) const {
  std::fill(directions.begin(), directions.end(), Point{0, 0, 0});
}

std::optional<CarriedPath> Path::carried(std::span<const Index>) const { return std::nullopt; }

void check_point(Index vertex, double time, const Point& point, double error) {
  if (is_finite(point) && error >= 0) return;
  const std::string place = "vertex " + std::to_string(vertex) + " of the path at t = " + number_text(time);
  if (!is_finite(point)) throw InvalidPath(place + " is not finite: give finite positions");
  throw InvalidPath(place + " has the error " + number_text(error) + ": give a bound >= 0 of how far it is off");
}

void check_deviation(Index vertex, double from, double to, double deviation) {
  if (deviation >= 0) return;
  throw InvalidPath("vertex " + std::to_string(vertex) + " of the path deviates by " + number_text(deviation) +
                    " between t = " + number_text(from) + " and " + number_text(to) +
                    ": give a bound >= 0 of its distance from the chord");
}

PairPoints points_between(const Moment<double>& from, const Moment<double>& to) {
  PairPoints points;
  for (std::size_t i = 0; i < 4; ++i) {
    points.start[i] = middle_of(from.points[i]);
    points.end[i] = middle_of(to.points[i]);
  }
  return points;
}

PairReader::PairReader(const Path& path, const PairVertices& vertices, double time_of_unit)
    : path_(path),
      vertices_(vertices),
      count_(static_cast<std::size_t>(std::find(vertices.begin(), vertices.end(), -1) - vertices.begin())) {
  std::array<Point, 4> given{};
  path_.straight_directions(std::span(vertices_).first(count_), given);
  for (std::size_t i = 0; i < count_; ++i) directions_[i] = direction_of(vertices_[i], given[i]);
  const auto moment = at<double>(time_of_unit);
  double size = 0;
  for (const auto& p : moment.points)
    for (const auto k : {&Vec3<Interval>::x, &Vec3<Interval>::y, &Vec3<Interval>::z})
      size = std::max(size, std::fabs((p.*k).middle() - (moment.points[0].*k).middle()));
  scale_ = scale_below_one(size);
}

template <>
Moment<double> PairReader::at(double time) const {
  std::array<Point, 4> points{};
  std::array<double, 4> errors{};
  path_.points_at(time, std::span(vertices_).first(count_), points, errors);
  Moment<double> moment;
  moment.time = time;
  for (std::size_t i = 0; i < count_; ++i) {
    check_point(vertices_[i], time, points[i], errors[i]);
    const auto enclosed = [&](double x) {
      return Interval(rounding::below(x - errors[i]) * scale_, rounding::above(x + errors[i]) * scale_);
    };
    moment.points[i] = {enclosed(points[i][0]), enclosed(points[i][1]), enclosed(points[i][2])};
  }
  return completed(moment, count_);
}

template <>
Moment<DoubleDouble> PairReader::at(double time) const {
  std::array<FinePoint, 4> points{};
  path_.fine_points_at(time, std::span(vertices_).first(count_), points);
  Moment<DoubleDouble> moment;
  moment.time = time;
  const FineInterval scale{DoubleDouble(scale_)};
  for (std::size_t i = 0; i < count_; ++i) {
    const FinePoint& p = points[i];
    check_point(vertices_[i], time, p.high, p.error);
    check_point(vertices_[i], time, p.low, p.error);
    const FineInterval error{DoubleDouble(-p.error), DoubleDouble(p.error)};
    const auto enclosed = [&](std::size_t k) {
      return scale * (FineInterval(DoubleDouble(p.high[k])) + FineInterval(DoubleDouble(p.low[k])) + error);
    };
    moment.points[i] = {enclosed(0), enclosed(1), enclosed(2)};
  }
  return completed(moment, count_);
}

std::array<double, 4> PairReader::deviations(double from, double to) const {
  std::array<double, 4> deviations{};
  path_.deviations(from, to, std::span(vertices_).first(count_), deviations);
  for (std::size_t i = 0; i < count_; ++i) {
    check_deviation(vertices_[i], from, to, deviations[i]);
    deviations[i] *= scale_;
  }
  return deviations;
}

}  // namespace tamis
