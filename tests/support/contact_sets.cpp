#include "support/contact_sets.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>
#include <sstream>

#include "support/copied.hpp"
#include "support/yardstick/methods.hpp"
#include "support/yardstick/pairs.hpp"

namespace tamis::test {

using scenes::Scene;

PairSet names_of(std::span<const Contact> contacts) {
  PairSet names;
  for (const Contact& c : contacts) names.insert({c.kind, c.vertices});
  return names;
}

PairSet certified_names_of(std::span<const Contact> contacts) {
  PairSet names;
  for (const Contact& c : contacts)
    if (c.certainty == Certainty::certified) names.insert({c.kind, c.vertices});
  return names;
}

std::vector<Contact> find_contacts(const Scene& scene, const yardstick::Options& options) {
  return contacts_of(yardstick::make_detector(scene.mesh(), options), scene.step());
}

PairSet find_names(const Scene& scene, const yardstick::Options& options) {
  return names_of(find_contacts(scene, options));
}

PairFilter some_pairs(const Scene& scene, std::uint64_t count) {
  std::uint64_t all = 0;
  yardstick::for_each_pair(scene.mesh(), {}, [&](PairKind, const PairVertices&) { ++all; });
  PairFilter filter;
  filter.accepts = [stride = 1 + all / count](PairKind, const PairVertices& v) {
    std::uint64_t hash = 0;
    for (const Index i : v) hash = (hash ^ static_cast<std::uint64_t>(i)) * 0x9e3779b97f4a7c15;
    return (hash >> 32) % stride == 0;
  };
  return filter;
}

oracle::Motion motion_of(const Scene& scene, const std::array<Index, 4>& vertices) {
  oracle::Motion motion;
  for (std::size_t i = 0; i < 4; ++i) {
    if (vertices[i] < 0) continue;  // this kind has fewer corners
    motion.start[i] = scene.start[static_cast<std::size_t>(vertices[i])];
    motion.end[i] = scene.end[static_cast<std::size_t>(vertices[i])];
  }
  return motion;
}

namespace {

std::set<Edge> edges_of(const Scene& scene) {
  std::set<Edge> edges;
  const auto add = [&](Index a, Index b) {
    if (a != b) edges.insert({std::min(a, b), std::max(a, b)});
  };
  for (const Face& f : scene.faces) add(f[0], f[1]), add(f[1], f[2]), add(f[2], f[0]);
  for (const Edge& e : scene.loose_edges) add(e[0], e[1]);
  return edges;
}

std::set<Index> points_of(const Scene& scene) {
  std::set<Index> points(scene.loose_points.begin(), scene.loose_points.end());
  for (const Face& f : scene.faces) points.insert(f.begin(), f.end());
  for (const Edge& e : scene.loose_edges) points.insert(e.begin(), e.end());
  return points;
}

void add_if_touching(const Scene& scene, PairKind kind, const std::array<Index, 4>& vertices, PairSet& contacts) {
  const std::size_t first_of_second = kind == PairKind::vertex_face ? 1 : 2;
  const auto second = vertices.begin() + static_cast<std::ptrdiff_t>(first_of_second);
  if (std::find_first_of(vertices.begin(), second, second, vertices.end()) != second) return;  // adjacent
  if (oracle::touches(kind, motion_of(scene, vertices))) contacts.insert({kind, vertices});
}

/// Adds contacts of loose points with loose edges and with each other: the other kinds do not include these pairs.
void add_loose_contacts(const Scene& scene, const std::set<Edge>& edges, PairSet& contacts) {
  std::set<Index> loose = points_of(scene);
  for (const Edge& e : edges) loose.erase(e[0]), loose.erase(e[1]);
  for (const Face& f : scene.faces)
    for (const Index v : f) loose.erase(v);
  std::set<Edge> loose_edges = edges;
  for (const Face& f : scene.faces)
    for (std::size_t k = 0; k < 3; ++k)
      loose_edges.erase({std::min(f[k], f[(k + 1) % 3]), std::max(f[k], f[(k + 1) % 3])});
  const auto add = [&](PairKind kind, const std::array<Index, 4>& vertices) {
    if (oracle::touches(kind, motion_of(scene, vertices))) contacts.insert({kind, vertices});
  };
  for (auto p = loose.begin(); p != loose.end(); ++p) {
    for (const Edge& e : loose_edges) add(PairKind::vertex_edge, {*p, e[0], e[1], -1});
    for (auto q = std::next(p); q != loose.end(); ++q) add(PairKind::vertex_vertex, {*p, *q, -1, -1});
  }
}

}  // namespace

PairSet oracle_contacts(const Scene& scene) {
  PairSet contacts;
  for (const Index p : points_of(scene))
    for (const Face& f : scene.faces) add_if_touching(scene, PairKind::vertex_face, {p, f[0], f[1], f[2]}, contacts);
  const std::set<Edge> edges = edges_of(scene);
  for (auto a = edges.begin(); a != edges.end(); ++a)
    for (auto b = std::next(a); b != edges.end(); ++b)
      add_if_touching(scene, PairKind::edge_edge, {(*a)[0], (*a)[1], (*b)[0], (*b)[1]}, contacts);
  add_loose_contacts(scene, edges, contacts);
  return contacts;
}

double size_at_start(const scenes::Scene& scene) {
  double size = 0;
  for (const Point& p : scene.start) size = std::max({size, std::fabs(p[0]), std::fabs(p[1]), std::fabs(p[2])});
  return size;
}

std::string missing(const PairSet& a, const PairSet& b) {
  std::vector<PairName> difference;
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(difference));
  if (difference.empty()) return {};
  std::ostringstream out;
  out << difference.size() << " pairs:";
  for (std::size_t i = 0; i < std::min<std::size_t>(difference.size(), 5); ++i) {
    out << ' ' << name_of(difference[i].kind);
    for (Index v : difference[i].vertices) out << ' ' << v;
    out << ';';
  }
  return out.str();
}

}  // namespace tamis::test
