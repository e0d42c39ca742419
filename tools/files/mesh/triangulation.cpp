#include "files/mesh/triangulation.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tamis::io {
namespace {

/// Products of two coordinates and sums of a million of them stay below the largest double.
constexpr int kLargestExponent = 490;

/// Scales by a power of two, so that neither products nor their errors leave the range of doubles.
bool scale(std::vector<Point>& points) {
  double largest = 0;
  for (const Point& p : points)
    for (const double x : p) {
      if (!std::isfinite(x)) return false;
      largest = std::max(largest, std::abs(x));
    }
  if (largest == 0) return true;
  // In two factors, each of which is a double whatever the size.
  const int exponent = kLargestExponent - std::ilogb(largest);
  const double first = std::ldexp(1, exponent / 2), second = std::ldexp(1, exponent - exponent / 2);
  for (Point& p : points)
    for (double& x : p) x = x * first * second;
  return true;
}

/// Twice the areas in the planes across the three axes (Newell), rounded.
struct Areas {
  Point across{};
  double products = 0;  ///< the sum of the sizes of all products that are in them
};

Areas areas_of(const std::vector<Point>& points) {
  Areas areas;
  const Point& origin = points[0];
  for (std::size_t i = 2; i < points.size(); ++i) {
    Point a, b;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      a[axis] = points[i - 1][axis] - origin[axis];
      b[axis] = points[i][axis] - origin[axis];
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t x = (axis + 1) % 3, y = (axis + 2) % 3;
      areas.across[axis] += a[x] * b[y] - a[y] * b[x];
      areas.products += std::abs(a[x] * b[y]) + std::abs(a[y] * b[x]);
    }
  }
  return areas;
}

/// Do the points leave the plane across `normal` by more than kFlat of their size?
bool is_bent(const std::vector<Point>& points, Point normal) {
  const double length = std::hypot(normal[0], normal[1], normal[2]);
  if (!(length > 0) || !std::isfinite(length)) return false;
  for (double& x : normal) x /= length;
  double least = 0, most = 0, size = 0;
  for (const Point& p : points) {
    double height = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double way = p[axis] - points[0][axis];
      height += normal[axis] * way;
      size = std::max(size, std::abs(way));
    }
    least = std::min(least, height);
    most = std::max(most, height);
  }
  return most - least > kFlat * size;
}

}  // namespace

PolygonDoubts Triangulation::cut(std::span<const Index> corners, std::span<const Point> positions,
                                 std::vector<Face>& faces) {
  take_corners(corners);
  PolygonDoubts doubts;
  if (size() <= 3 || !project(positions, doubts) || is_fan_inside()) {
    add_fan(faces);
    return doubts;
  }
  const std::size_t first = faces.size();
  doubts.is_tangled = crosses_itself() || !clip_ears(faces);
  if (doubts.is_tangled) {
    faces.resize(first);
    add_fan(faces);
  }
  return doubts;
}

/// Without indices that directly follow themselves, as long as three corners are left.
void Triangulation::take_corners(std::span<const Index> corners) {
  corners_.clear();
  for (const Index corner : corners)
    if (corners_.empty() || corners_.back() != corner) corners_.push_back(corner);
  while (size() > 3 && corners_.back() == corners_.front()) corners_.pop_back();
  if (size() < 3) corners_.assign(corners.begin(), corners.end());
}

/// Lays the corners into the plane; false if they have no area, or are not finite.
bool Triangulation::project(std::span<const Point> positions, PolygonDoubts& doubts) {
  scaled_.clear();
  for (const Index corner : corners_) scaled_.push_back(positions[static_cast<std::size_t>(corner)]);
  if (!scale(scaled_)) return false;
  const auto [areas, products] = areas_of(scaled_);
  const auto larger = [](double a, double b) { return std::abs(a) < std::abs(b); };
  const auto axis = static_cast<std::size_t>(std::max_element(areas.begin(), areas.end(), larger) - areas.begin());
  // A million corners round by less than this.
  constexpr double kClear = 1e-9;
  const bool is_clear = std::abs(areas[axis]) > kClear * products;
  const int turn = is_clear ? (areas[axis] > 0 ? 1 : -1) : turn_of(scaled_, axis);
  doubts.is_tangled = turn == 0;
  if (turn == 0) return false;
  doubts.is_bent = is_bent(scaled_, areas);
  const std::size_t x = (axis + (turn > 0 ? 1 : 2)) % 3, y = (axis + (turn > 0 ? 2 : 1)) % 3;
  plane_.clear();
  for (const Point& p : scaled_) plane_.push_back({p[x], p[y]});
  return true;
}

/// The sign of the area across an axis, exactly.
int Triangulation::turn_of(std::span<const Point> points, std::size_t axis) const {
  const std::size_t x = (axis + 1) % 3, y = (axis + 2) % 3;
  ExactSum area;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point &a = points[i], &b = points[i + 1 < points.size() ? i + 1 : 0];
    area.add_product(a[x], b[y]);
    area.add_product(-a[y], b[x]);
  }
  return area.sign();
}

/// Do the rays from the first corner to all others turn to the left, and by less than a whole turn together?
bool Triangulation::is_fan_inside() const {
  bool is_past_half = false;
  for (std::size_t i = 2; i < size(); ++i) {
    if (side_of(plane_[0], plane_[i - 1], plane_[i]) <= 0) return false;
    const bool is_left = side_of(plane_[0], plane_[1], plane_[i]) > 0;
    if (is_past_half && is_left) return false;
    is_past_half = !is_left;
  }
  return true;
}

/// Does an edge cross another one in a point inside of both?
bool Triangulation::crosses_itself() const {
  struct Side {
    double low, high;
    std::size_t first, second;
  };
  std::vector<Side> sides;
  for (std::size_t i = 0; i < size(); ++i) {
    const std::size_t next = i + 1 < size() ? i + 1 : 0;
    const auto [low, high] = std::minmax(plane_[i][0], plane_[next][0]);
    sides.push_back({low, high, i, next});
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.low < b.low; });
  for (std::size_t i = 0; i < size(); ++i)
    for (std::size_t j = i + 1; j < size() && sides[j].low <= sides[i].high; ++j) {
      const PlanePoint &a = plane_[sides[i].first], &b = plane_[sides[i].second];
      const PlanePoint &c = plane_[sides[j].first], &d = plane_[sides[j].second];
      if (std::max(a[1], b[1]) < std::min(c[1], d[1]) || std::max(c[1], d[1]) < std::min(a[1], b[1])) continue;
      if (side_of(a, b, c) * side_of(a, b, d) < 0 && side_of(c, d, a) * side_of(c, d, b) < 0) return true;
    }
  return false;
}

/// False if no ear is left though the polygon is.
bool Triangulation::clip_ears(std::vector<Face>& faces) {
  left_ = size();
  is_left_.assign(size(), true);
  before_.resize(size());
  after_.resize(size());
  by_x_.resize(size());
  for (std::size_t i = 0; i < size(); ++i) {
    before_[i] = i > 0 ? i - 1 : size() - 1;
    after_[i] = i + 1 < size() ? i + 1 : 0;
  }
  std::iota(by_x_.begin(), by_x_.end(), std::size_t{0});
  std::stable_sort(by_x_.begin(), by_x_.end(), [&](auto a, auto b) { return plane_[a][0] < plane_[b][0]; });
  std::size_t tip = 0, tried = 0;
  bool takes_spikes = false;
  while (left_ > 3) {
    if (is_ear(tip) || (takes_spikes && is_spike(tip))) {
      clip(tip, faces);
      tip = after_[after_[tip]];
      tried = 0;
      takes_spikes = false;
    } else if (tip = after_[tip]; ++tried == left_) {
      if (takes_spikes) return false;
      takes_spikes = true;
      tried = 0;
    }
  }
  const bool is_last_one_inside = side_of(plane_[before_[tip]], plane_[tip], plane_[after_[tip]]) > 0 || is_spike(tip);
  clip(tip, faces);
  return is_last_one_inside;
}

/// Is the triangle at this corner inside of what is left, with no other corner in it or on its sides?
bool Triangulation::is_ear(std::size_t tip) const {
  const std::array triangle{before_[tip], tip, after_[tip]};
  const PlanePoint &a = plane_[triangle[0]], &b = plane_[tip], &c = plane_[triangle[2]];
  if (side_of(a, b, c) <= 0) return false;
  const double low = std::min({a[0], b[0], c[0]}), high = std::max({a[0], b[0], c[0]});
  const double bottom = std::min({a[1], b[1], c[1]}), top = std::max({a[1], b[1], c[1]});
  auto place = std::lower_bound(by_x_.begin(), by_x_.end(), low, [&](auto i, double x) { return plane_[i][0] < x; });
  for (; place != by_x_.end() && plane_[*place][0] <= high; ++place) {
    const PlanePoint& p = plane_[*place];
    if (!is_left_[*place] || p[1] < bottom || p[1] > top) continue;
    const auto corner = std::ranges::find_if(triangle, [&](auto i) { return plane_[i] == p; });
    if (corner != triangle.end()) {
      if (std::ranges::find(triangle, *place) == triangle.end() && leads_inside(*corner, tip, *place)) return false;
    } else if (side_of(a, b, p) >= 0 && side_of(b, c, p) >= 0 && side_of(c, a, p) >= 0) {
      return false;
    }
  }
  return true;
}

/// Does an edge of `other`, which lies where `corner` of the triangle at `tip` lies, lead into the triangle?
bool Triangulation::leads_inside(std::size_t corner, std::size_t tip, std::size_t other) const {
  const std::array triangle{before_[tip], tip, after_[tip]};
  const auto place = static_cast<std::size_t>(std::ranges::find(triangle, corner) - triangle.begin());
  const PlanePoint &from = plane_[corner], &next = plane_[triangle[(place + 1) % 3]],
                   &last = plane_[triangle[(place + 2) % 3]];
  return std::ranges::any_of(std::array{before_[other], after_[other]}, [&](std::size_t end) {
    return side_of(from, next, plane_[end]) > 0 && side_of(last, from, plane_[end]) > 0;
  });
}

/// Does the polygon run along a line here and back, or stay at one point? Its triangle has no area.
bool Triangulation::is_spike(std::size_t tip) const {
  const PlanePoint &a = plane_[before_[tip]], &b = plane_[tip], &c = plane_[after_[tip]];
  return a == b || b == c || a == c;
}

void Triangulation::clip(std::size_t tip, std::vector<Face>& faces) {
  faces.push_back({corners_[before_[tip]], corners_[tip], corners_[after_[tip]]});
  after_[before_[tip]] = after_[tip];
  before_[after_[tip]] = before_[tip];
  is_left_[tip] = false;
  --left_;
}

void Triangulation::add_fan(std::vector<Face>& faces) const {
  for (std::size_t i = 2; i < size(); ++i) faces.push_back({corners_[0], corners_[i - 1], corners_[i]});
}

}  // namespace tamis::io
