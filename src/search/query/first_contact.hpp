// The first of many contacts, by order of time, then kind and vertices. A crowd of pairs may meet at one time, as when
// a scene passes through one line. Then this order would need the exact time of each pair. So the pairs of a crowd
// count as touching together.
#pragma once
#include <utility>
#include <vector>

#include "search/query/pair_vertices.hpp"
#include "tamis/contact.hpp"

namespace tamis {

/// By kind, then vertices; duplicate features leave equal keys, so the time comes last.
bool comes_before(const Contact& a, const Contact& b);

/// Updates `first` by a contact: the earliest toi_lower with its contact, and the earliest certain toi_upper.
void keep_first(EarliestContact& first, const Contact& contact);

/// The beginning of a short time, at most 2^-37 of itself long, that holds `time`. A later time has no earlier
/// beginning.
double beginning_of(double time);

/// The result depends on the set of contacts, whatever their order.
///
/// Crowd: the pairs that integers decided whose toi_lower lies in the same short time as the earliest such toi_lower,
/// if they are kCrowd or more. All of them count as touching from the beginning of that time.
class FirstContact {
 public:
  static constexpr std::size_t kCrowd = 64;

  void add(const Contact& contact, bool by_integers);
  /// Adds all contacts of the other.
  void add(const FirstContact& other);
  EarliestContact answer() const;

  /// The earliest contact if nothing counts as a crowd.
  const EarliestContact& earliest() const { return first_; }
  /// A pair that gets its bracket from integers cannot change the answer if it is free until this time, at most
  /// `latest`.
  double needed_until(PairKind kind, const PairVertices& vertices, double latest) const;

 private:
  using Key = std::pair<PairKind, PairVertices>;

  bool is_crowd() const { return crowd_.size() >= kCrowd; }
  void add_to_crowd(double time, const Key& key);

  EarliestContact first_, first_by_doubles_;
  double crowd_time_ = 2;   ///< the beginning of the crowd's time; later than all times while there is none
  std::vector<Key> crowd_;  ///< the first kCrowd that were added
  std::optional<Contact> first_of_crowd_;  ///< by kind and vertices
};

}  // namespace tamis
