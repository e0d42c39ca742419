#include "distributed/src/local_search.hpp"

#include <atomic>

#include "api/detector_access.hpp"

namespace tamis::distributed {
namespace {

constexpr std::uint8_t kMine = 1, kOthers = 2;

std::vector<ElementId> ids_of(std::span<const ElementSet* const> sets) {
  std::vector<ElementId> ids;
  for (const ElementSet* set : sets) ids.insert(ids.end(), set->ids.begin(), set->ids.end());
  return ids;
}

Mesh mesh_of(const ElementSet& set) {
  std::vector<Face> faces;
  std::vector<Edge> edges;
  std::vector<Index> points;
  for (const Corners& c : set.elements)
    if (c[2] >= 0)
      faces.push_back(c);
    else if (c[1] >= 0)
      edges.push_back({c[0], c[1]});
    else
      points.push_back(c[0]);
  return Mesh(static_cast<Index>(set.vertices.size()), std::move(faces), edges, std::move(points));
}

}  // namespace

void LocalSearch::assign(std::span<const ElementSet* const> sets, const BoxFrame& frame) {
  std::vector<ElementId> ids = ids_of(sets);
  if (ids == ids_ && !ids.empty()) {
    for (const ElementSet* set : sets) copy_motions(*set, set_);
  } else {
    set_ = united(sets);
    ids_ = std::move(ids);
    detector_.reset();
  }
  start_.resize(set_.motions.size());
  end_.resize(set_.motions.size());
  for (std::size_t v = 0; v < set_.motions.size(); ++v) {
    start_[v] = set_.motions[v].start;
    end_[v] = set_.motions[v].end;
  }
  if (!detector_ && !empty()) make_detector();
  if (detector_) DetectorAccess::use_frame(*detector_, frame);
  pairs_of_vertex_.assign(counts_pairs_ ? set_.vertices.size() : 0, 0);
}

void LocalSearch::assign_sides(const ElementSet& mine, const ElementSet& others, const BoxFrame& frame) {
  const ElementSet* const both[] = {&mine, &others};
  if (side_.empty()) detector_.reset();
  side_.assign(1, 0);
  assign(both, frame);
  side_.assign(set_.vertices.size(), 0);
  const auto mark = [&](const ElementSet& set, std::uint8_t side) {
    std::size_t place = 0;
    for (const Vertex& vertex : set.vertices) {
      while (set_.vertices[place].number < vertex.number) ++place;
      side_[place] |= side;
    }
  };
  mark(mine, kMine);
  mark(others, kOthers);
}

void LocalSearch::forget() {
  ids_.clear();
  set_ = {};
  detector_.reset();
}

void LocalSearch::count_pairs(bool counts) {
  if (counts != counts_pairs_) forget();
  counts_pairs_ = counts;
}

void LocalSearch::make_detector() { detector_.emplace(mesh_of(set_), local_options()); }

Options LocalSearch::local_options() {
  Options options = options_;
  options.filter.group_of_vertex.clear();
  if (options.filter.groups_may_touch.empty() && options.radii.empty()) {
    options.filter.group_count = 1;
  } else {
    for (const Vertex& vertex : set_.vertices) options.filter.group_of_vertex.push_back(vertex.group);
  }
  if (counts_pairs_ || !side_.empty() || options_.filter.accepts)
    options.filter.accepts = [this](PairKind kind, const auto& vertices) { return is_wanted(kind, vertices); };
  return options;
}

bool LocalSearch::is_wanted(PairKind kind, const std::array<Index, 4>& vertices) {
  if (!side_.empty() && is_within_a_side(vertices)) return false;
  if (counts_pairs_) count(vertices);
  return !options_.filter.accepts || accepts(kind, vertices);
}

/// A vertex of one side alone belongs only to features of that side.
bool LocalSearch::is_within_a_side(const std::array<Index, 4>& vertices) const {
  std::uint8_t sides = 0;
  for (const Index v : vertices)
    if (v >= 0) sides |= side_[static_cast<std::size_t>(v)];
  return sides != (kMine | kOthers);
}

void LocalSearch::count(const std::array<Index, 4>& vertices) {
  for (const Index v : vertices)
    if (v >= 0) std::atomic_ref(pairs_of_vertex_[static_cast<std::size_t>(v)]).fetch_add(1, std::memory_order_relaxed);
}

bool LocalSearch::accepts(PairKind kind, std::array<Index, 4> vertices) const {
  translate(vertices);
  return options_.filter.accepts(kind, vertices);
}

void LocalSearch::translate(std::array<Index, 4>& vertices) const {
  for (Index& v : vertices)
    if (v >= 0) v = set_.vertices[static_cast<std::size_t>(v)].number;
}

std::vector<HomedContact> LocalSearch::contacts(const QueryOptions& asked) {
  std::vector<HomedContact> result;
  for (Contact contact : detector_->contacts(step(), asked)) {
    const int home = set_.vertices[static_cast<std::size_t>(contact.vertices[0])].home;
    translate(contact.vertices);
    result.push_back({contact, home});
  }
  return result;
}

EarliestContact LocalSearch::earliest(const QueryOptions& asked) {
  EarliestContact first = detector_->earliest(step(), asked);
  if (first.contact) translate(first.contact->vertices);
  return first;
}

bool LocalSearch::is_free(const QueryOptions& asked) { return detector_->is_free(step(), asked); }

SafeStep LocalSearch::safe_step(double keep, const QueryOptions& asked) {
  SafeStep safe = detector_->safe_step(step(), keep, asked);
  if (safe.pair) translate(safe.pair->vertices);
  return safe;
}

std::uint64_t LocalSearch::pairs_tested() const {
  if (!detector_ || detector_->statistics().stages.empty()) return 0;
  const auto& [name, vf, ee, ve, vv] = detector_->statistics().stages.front();
  return vf + ee + ve + vv;
}

std::vector<std::uint64_t> LocalSearch::weights_of(const ElementSet& part) const {
  std::vector<std::uint64_t> of_vertex;
  std::size_t place = 0;
  for (const Vertex& vertex : part.vertices) {
    while (place < set_.vertices.size() && set_.vertices[place].number < vertex.number) ++place;
    const bool is_here = place < set_.vertices.size() && set_.vertices[place].number == vertex.number;
    of_vertex.push_back(is_here ? pairs_of_vertex_[place] : 0);
  }
  std::vector<std::uint64_t> weights;
  for (const Corners& corners : part.elements) {
    weights.push_back(1);
    for_each_corner(corners, [&](std::size_t v) { weights.back() += of_vertex[v]; });
  }
  return weights;
}

}  // namespace tamis::distributed
