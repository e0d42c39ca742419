// Bullet 3.24, the vertex-face CCD of its deformable bodies (bernsteinCCD), as Debian builds it: floats. zlib licence.
#include <BulletSoftBody/btSoftBody.h>
#include <BulletSoftBody/btSoftBodyInternals.h>

#include "benchmarks/contenders/contender.hpp"

namespace tamis::bench {
namespace {

using Node = btSoftBody::Node;
using BulletFace = btSoftBody::Face;

btVector3 vector_of(const Point& p) {
  return {static_cast<btScalar>(p[0]), static_cast<btScalar>(p[1]), static_cast<btScalar>(p[2])};
}

class Bullet final : public Contender {
 public:
  std::string name() const override { return "Bullet bernsteinCCD"; }
  Field field() const override { return Field::one_pair; }

  Cost run(const Task& task) override {
    const Stopwatch watch;
    prepare(task);
    touching_.clear();
    btVector3 weights;
    for (const VertexFace& pair : task.vertex_face_candidates)
      if (bernsteinCCD(&faces_[static_cast<std::size_t>(pair.face)], &nodes_[static_cast<std::size_t>(pair.vertex)], 1,
                       SAFE_EPSILON, weights))
        touching_.push_back(pair);
    return watch.cost();
  }

  Answer answer(const Task& task) override {
    std::vector<Pair> pairs;
    for (const VertexFace& pair : touching_) {
      const Face& f = task.mesh.faces()[static_cast<std::size_t>(pair.face)];
      pairs.push_back({PairKind::vertex_face, {pair.vertex, f[0], f[1], f[2]}});
    }
    return compare(task, pairs, true, false);
  }

 private:
  /// Fills in nodes and faces of the step, with the normals that Bullet keeps in them. This time counts.
  void prepare(const Task& task) {
    nodes_.resize(task.start.size());
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      nodes_[i].m_x = vector_of(task.start[i]);
      nodes_[i].m_q = vector_of(task.end[i]);
      nodes_[i].m_v = nodes_[i].m_q - nodes_[i].m_x;
    }
    faces_.resize(task.mesh.faces().size());
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      BulletFace& face = faces_[i];
      for (std::size_t corner = 0; corner < 3; ++corner)
        face.m_n[corner] = &nodes_[static_cast<std::size_t>(task.mesh.faces()[i][corner])];
      const Node &a = *face.m_n[0], &b = *face.m_n[1], &c = *face.m_n[2];
      face.m_n0 = (b.m_x - a.m_x).cross(c.m_x - a.m_x);
      face.m_n1 = (b.m_q - a.m_q).cross(c.m_q - a.m_q);
      face.m_vn = (b.m_v - a.m_v).cross(c.m_v - a.m_v);
    }
  }

  std::vector<Node> nodes_;
  std::vector<BulletFace> faces_;
  std::vector<VertexFace> touching_;
};

}  // namespace

void add_bullet(Contenders& list) { list.push_back(std::make_unique<Bullet>()); }

}  // namespace tamis::bench
