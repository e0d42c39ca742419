#include "longrun/one_place.hpp"

namespace tamis::test {
namespace {

/// Pair i has the vertices 4 i .. 4 i + 3.
Mesh mesh_of(PairKind kind) {
  std::vector<Face> faces;
  std::vector<Edge> edges;
  std::vector<Index> points;
  for (Index v = 0; v < 4 * OnePlace::kPairs; v += 4) {
    if (kind == PairKind::vertex_face) {
      points.push_back(v);
      faces.push_back({v + 1, v + 2, v + 3});
    } else {
      edges.push_back({v, v + 1});
      edges.push_back({v + 2, v + 3});
    }
  }
  return Mesh(4 * OnePlace::kPairs, std::move(faces), edges, std::move(points));
}

Options options_of(PairKind kind) {
  Options options;
  options.threads = 1;
  options.filter.accepts = [kind](PairKind k, const std::array<Index, 4>& v) {
    return k == kind && v[0] / 4 == v[1] / 4 && v[0] / 4 == v[2] / 4 && v[0] / 4 == v[3] / 4;
  };
  return options;
}

}  // namespace

OnePlace::OnePlace(PairKind kind) : detector_(mesh_of(kind), options_of(kind)), start_(4 * kPairs), end_(4 * kPairs) {}

const std::vector<PairResult>& OnePlace::answers(const std::vector<oracle::Motion>& motions) {
  for (std::size_t i = 0; i < motions.size(); ++i)
    for (std::size_t v = 0; v < 4; ++v) {
      start_[4 * i + v] = motions[i].start[v];
      end_[4 * i + v] = motions[i].end[v];
    }
  answers_.assign(motions.size(), {});
  for (const Contact& c : detector_.contacts({start_, end_}))
    answers_[static_cast<std::size_t>(c.vertices[0] / 4)] = {true, c.certainty, c.toi_lower, c.toi_upper,
                                                             c.u,  c.v,         c.normal};
  return answers_;
}

}  // namespace tamis::test
