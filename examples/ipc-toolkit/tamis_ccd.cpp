#include "tamis_ccd.hpp"

#include <tamis/pair_distance.hpp>

namespace ipc {
namespace {

template <class Vector>
tamis::Point point_of(const Vector& p) {
  return {p[0], p[1], p.size() > 2 ? p[2] : 0.0};
}

template <std::size_t points>
bool ends(tamis::PairKind kind, const std::array<tamis::Point, points>& start,
          const std::array<tamis::Point, points>& end, double keep, double min_distance, double tmax, double& toi) {
  const tamis::FeaturePair pair{kind, {0, 1, 2, 3}};
  tamis::PairOptions options;
  options.min_separation = min_distance;
  options.latest = tmax;
  const auto step = tamis::safe_step(pair, {start, end}, keep, options);
  toi = step.toi_lower;
  return step.pair.has_value();
}

}  // namespace

bool TamisCCD::point_point_ccd(Eigen::ConstRef<VectorMax3d> p0_t0, Eigen::ConstRef<VectorMax3d> p1_t0,
                               Eigen::ConstRef<VectorMax3d> p0_t1, Eigen::ConstRef<VectorMax3d> p1_t1, double& toi,
                               const double min_distance, const double tmax) const {
  return ends<2>(tamis::PairKind::vertex_vertex, {point_of(p0_t0), point_of(p1_t0)}, {point_of(p0_t1), point_of(p1_t1)},
                 1 - conservative_rescaling, min_distance, tmax, toi);
}

bool TamisCCD::point_edge_ccd(Eigen::ConstRef<VectorMax3d> p_t0, Eigen::ConstRef<VectorMax3d> e0_t0,
                              Eigen::ConstRef<VectorMax3d> e1_t0, Eigen::ConstRef<VectorMax3d> p_t1,
                              Eigen::ConstRef<VectorMax3d> e0_t1, Eigen::ConstRef<VectorMax3d> e1_t1, double& toi,
                              const double min_distance, const double tmax) const {
  return ends<3>(tamis::PairKind::vertex_edge, {point_of(p_t0), point_of(e0_t0), point_of(e1_t0)},
                 {point_of(p_t1), point_of(e0_t1), point_of(e1_t1)}, 1 - conservative_rescaling, min_distance, tmax,
                 toi);
}

bool TamisCCD::point_triangle_ccd(Eigen::ConstRef<Eigen::Vector3d> p_t0, Eigen::ConstRef<Eigen::Vector3d> t0_t0,
                                  Eigen::ConstRef<Eigen::Vector3d> t1_t0, Eigen::ConstRef<Eigen::Vector3d> t2_t0,
                                  Eigen::ConstRef<Eigen::Vector3d> p_t1, Eigen::ConstRef<Eigen::Vector3d> t0_t1,
                                  Eigen::ConstRef<Eigen::Vector3d> t1_t1, Eigen::ConstRef<Eigen::Vector3d> t2_t1,
                                  double& toi, const double min_distance, const double tmax) const {
  return ends<4>(tamis::PairKind::vertex_face, {point_of(p_t0), point_of(t0_t0), point_of(t1_t0), point_of(t2_t0)},
                 {point_of(p_t1), point_of(t0_t1), point_of(t1_t1), point_of(t2_t1)}, 1 - conservative_rescaling,
                 min_distance, tmax, toi);
}

bool TamisCCD::edge_edge_ccd(Eigen::ConstRef<Eigen::Vector3d> ea0_t0, Eigen::ConstRef<Eigen::Vector3d> ea1_t0,
                             Eigen::ConstRef<Eigen::Vector3d> eb0_t0, Eigen::ConstRef<Eigen::Vector3d> eb1_t0,
                             Eigen::ConstRef<Eigen::Vector3d> ea0_t1, Eigen::ConstRef<Eigen::Vector3d> ea1_t1,
                             Eigen::ConstRef<Eigen::Vector3d> eb0_t1, Eigen::ConstRef<Eigen::Vector3d> eb1_t1,
                             double& toi, const double min_distance, const double tmax) const {
  return ends<4>(tamis::PairKind::edge_edge, {point_of(ea0_t0), point_of(ea1_t0), point_of(eb0_t0), point_of(eb1_t0)},
                 {point_of(ea0_t1), point_of(ea1_t1), point_of(eb0_t1), point_of(eb1_t1)}, 1 - conservative_rescaling,
                 min_distance, tmax, toi);
}

}  // namespace ipc
