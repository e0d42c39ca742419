// Tamis as a narrow phase of ipc-toolkit: each pair keeps 1 - conservative_rescaling of its distance, proven.
#pragma once
#include <ipc/ccd/narrow_phase_ccd.hpp>

namespace ipc {

/// As AdditiveCCD, the time that a call writes is one until which the pair keeps a fraction of its distance beyond
/// `min_distance`. A call returns false if the pair keeps it until `tmax`. Points in the plane are points with z = 0.
class TamisCCD : public NarrowPhaseCCD {
 public:
  explicit TamisCCD(double conservative_rescaling = 0.9) { this->conservative_rescaling = conservative_rescaling; }

  bool point_point_ccd(Eigen::ConstRef<VectorMax3d> p0_t0, Eigen::ConstRef<VectorMax3d> p1_t0,
                       Eigen::ConstRef<VectorMax3d> p0_t1, Eigen::ConstRef<VectorMax3d> p1_t1, double& toi,
                       double min_distance = 0.0, double tmax = 1.0) const override;
  bool point_edge_ccd(Eigen::ConstRef<VectorMax3d> p_t0, Eigen::ConstRef<VectorMax3d> e0_t0,
                      Eigen::ConstRef<VectorMax3d> e1_t0, Eigen::ConstRef<VectorMax3d> p_t1,
                      Eigen::ConstRef<VectorMax3d> e0_t1, Eigen::ConstRef<VectorMax3d> e1_t1, double& toi,
                      double min_distance = 0.0, double tmax = 1.0) const override;
  bool point_triangle_ccd(Eigen::ConstRef<Eigen::Vector3d> p_t0, Eigen::ConstRef<Eigen::Vector3d> t0_t0,
                          Eigen::ConstRef<Eigen::Vector3d> t1_t0, Eigen::ConstRef<Eigen::Vector3d> t2_t0,
                          Eigen::ConstRef<Eigen::Vector3d> p_t1, Eigen::ConstRef<Eigen::Vector3d> t0_t1,
                          Eigen::ConstRef<Eigen::Vector3d> t1_t1, Eigen::ConstRef<Eigen::Vector3d> t2_t1, double& toi,
                          double min_distance = 0.0, double tmax = 1.0) const override;
  bool edge_edge_ccd(Eigen::ConstRef<Eigen::Vector3d> ea0_t0, Eigen::ConstRef<Eigen::Vector3d> ea1_t0,
                     Eigen::ConstRef<Eigen::Vector3d> eb0_t0, Eigen::ConstRef<Eigen::Vector3d> eb1_t0,
                     Eigen::ConstRef<Eigen::Vector3d> ea0_t1, Eigen::ConstRef<Eigen::Vector3d> ea1_t1,
                     Eigen::ConstRef<Eigen::Vector3d> eb0_t1, Eigen::ConstRef<Eigen::Vector3d> eb1_t1, double& toi,
                     double min_distance = 0.0, double tmax = 1.0) const override;
};

}  // namespace ipc
