// Where the bodies of a linkage are at times of an edge, and how far their curves bend. Each is computed once.
#pragma once
#include <algorithm>
#include <memory>
#include <vector>

#include "worlds/body.hpp"
#include "worlds/linkage_tree.hpp"
#include "worlds/middle_box.hpp"

namespace tamis {

/// Times of an edge are counted in parts of 2^-kFinest.
inline constexpr int kFinest = 10;
inline constexpr std::size_t kTimes = (std::size_t{1} << kFinest) + 1;

/// Where a body is at one time. No vertex is off by more than `margin` along any direction of length 1. This covers
/// the rounding of projections, too.
struct PlaceOnEdge {
  RoundedTransform place{};
  double margin = 0;
};

/// How far the curves of a body bend on the whole edge: |x''| of a point at a distance r from the body's origin is at
/// most acceleration(r). Without its linear part, the point stays within orbit(r) of one point.
class Bend {
 public:
  Bend() = default;
  /// `at_origin` and `at_radius`: of points at the origin, and at the distance `radius`.
  Bend(const Curvature& at_origin, const Curvature& at_radius, double radius);
  /// A bound of the distance from the chord, for points within r of the origin, on a piece of the length 2^-level.
  /// REQUIRES (not checked: hot): r is at most the radius.
  double deviation(double r, int level) const {
    const double factor = 0.125 / static_cast<double>(std::uint64_t{1} << (2 * level));
    return std::min(factor * (acceleration_ + r * acceleration_slope_), 2 * (orbit_ + r * orbit_slope_)) * kRoundedUp;
  }
  bool is_zero() const { return acceleration_ == 0 && acceleration_slope_ == 0; }

 private:
  double acceleration_ = 0, acceleration_slope_ = 0, orbit_ = 0, orbit_slope_ = 0;
};

/// The items of a leaf at one time.
struct PlacedLeaf {
  std::uint64_t edge = 0;
  std::size_t time = 0;
  std::array<Triangle, kBlock> corners;
  std::array<Box, kBlock> boxes;
  Box all;
};

/// A body as a frame sees it: its shape, its places, its bend.
class BodyOnEdge {
 public:
  /// Keeps the shape. Its places are those of f(time index), computed once for each edge.
  BodyOnEdge(const BodyShape& shape, bool stays);

  const BodyShape& shape() const { return *shape_; }
  /// The box of a node.
  const MiddleBox& box(Index node) const { return boxes_[static_cast<std::size_t>(node)]; }
  /// To be called for each edge on which the body moves in another way.
  void begin(const Bend& bend) {
    bend_ = bend;
    ++edge_;
  }
  const Bend& bend() const { return bend_; }
  template <class F>
  const PlaceOnEdge& at_time(std::size_t time, const F& place_at) {
    if (stays_) time = 0;
    if (edge_of_[time] != edge_) {
      places_[time] = with_margin(place_at(time));
      edge_of_[time] = edge_;
    }
    return places_[time];
  }

  Triangle corners_at(const RoundedTransform& place, Index item) const;
  /// The items of a leaf at a time. `slot` 0 to 2: each keeps a leaf until it is wanted at another time.
  const PlacedLeaf& leaf_at(std::size_t time, const RoundedTransform& place, Index leaf, std::size_t slot);

 private:
  PlaceOnEdge with_margin(const RoundedTransform& place) const;

  const BodyShape* shape_;
  double size_;  ///< |x|_1 of its points is at most this
  Bend bend_;
  bool stays_;  ///< always, at one place
  std::uint64_t edge_ = 1;
  std::vector<std::uint64_t> edge_of_;  ///< for which edge each place was computed
  std::vector<PlaceOnEdge> places_;
  std::vector<MiddleBox> boxes_;                     ///< of its nodes
  std::vector<std::unique_ptr<PlacedLeaf>> leaves_;  ///< three of each, unless it stays; null until requested
};

/// The links of a linkage along one edge after the other.
class LinksOnEdge {
 public:
  explicit LinksOnEdge(const LinkageTree& tree) : tree_(tree), links_(tree.links.size()) {
    frames_.resize(tree.links.size() + 1);
    for (auto& frame : frames_) frame.resize(tree.links.size());
  }

  void begin(std::span<const double> start, std::span<const double> end);
  /// Where a body is in the frame behind a link (-1: the world). REQUIRES: the frame's link carries the body.
  RoundedTransform place_of(const LinkageTree::Carried& body, Index frame, std::size_t time);
  /// The bend of a body of this radius in that frame.
  Bend bend_of(const LinkageTree::Carried& body, Index frame, double radius) const;

 private:
  struct Times {
    std::vector<std::uint64_t> edge_of;
    std::vector<RoundedTransform> places;
  };
  const RoundedTransform& place_of(Index link, Index frame, std::size_t time);
  RoundedTransform own_place_of(std::size_t link, std::size_t time);

  const LinkageTree& tree_;
  std::uint64_t edge_ = 0;
  std::vector<RigidLink> links_;
  std::vector<std::vector<Times>> frames_;  ///< by frame + 1, then link
};

/// The time of an index, exactly.
inline double time_of(std::size_t index) { return static_cast<double>(index) / static_cast<double>(kTimes - 1); }

}  // namespace tamis
