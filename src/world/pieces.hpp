// The pieces of a step on which bodies that turn are bounded, and their places at the pieces' ends.
#pragma once
#include <map>
#include <span>
#include <vector>

#include "world/body.hpp"

namespace tamis {

/// A step is cut into no more.
inline constexpr double kMostPieces = 4096;

/// Where bodies that turn are at one time of the step, in doubles: computed when first asked for.
class PlacesAt {
 public:
  /// REQUIRES: in [0,1].
  explicit PlacesAt(double time) : chains_(time) {}
  double time() const { return chains_.time(); }
  const RoundedTransform& of(const Body& body) {
    const auto [place, is_new] = places_.try_emplace(&body);
    if (is_new) place->second = time() == 0 ? body.at_start() : time() == 1 ? body.at_end() : chains_.of(body.chain());
    return place->second;
  }
  void forget() { places_.clear(); }

 private:
  ChainsAt chains_;
  std::map<const Body*, RoundedTransform> places_;
};

/// Keeps the places, for which several traversals of the same pieces ask.
class Pieces {
 public:
  /// Ends of pieces, of which there is a first and a last; ascending.
  explicit Pieces(std::span<const double> times) : places_(times.begin(), times.end()) {}

  std::size_t count() const { return places_.size() - 1; }
  PlacesAt& start(std::size_t piece) { return places_[piece]; }
  PlacesAt& end(std::size_t piece) { return places_[piece + 1]; }
  /// Do the pieces consist of the pose at t=0 alone?
  bool are_of_the_start() const { return places_.back().time() == 0; }
  /// Drops a piece's places after a traversal, where there are so many pieces that memory counts.
  void leave(std::size_t piece) {
    if (count() > kKept) start(piece).forget();
  }

 private:
  static constexpr std::size_t kKept = 64;

  std::vector<PlacesAt> places_;
};

}  // namespace tamis
