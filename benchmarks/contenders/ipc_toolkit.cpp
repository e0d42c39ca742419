// ipc-toolkit: its largest safe step with its own defaults. Compiled if find_package finds it. MIT licence.
#include <fmt/format.h>

#include <Eigen/Core>
#include <ipc/ipc.hpp>

#include "benchmarks/contenders/contender.hpp"

namespace tamis::bench {
namespace {

template <class Rows>
Eigen::MatrixXd positions_of(const Rows& rows) {
  Eigen::MatrixXd matrix(static_cast<Eigen::Index>(rows.size()), 3);
  for (Eigen::Index i = 0; i < matrix.rows(); ++i)
    for (Eigen::Index axis = 0; axis < 3; ++axis)
      matrix(i, axis) = rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(axis)];
  return matrix;
}

template <class Rows>
Eigen::MatrixXi indices_of(const Rows& rows, Eigen::Index columns) {
  Eigen::MatrixXi matrix(static_cast<Eigen::Index>(rows.size()), columns);
  for (Eigen::Index i = 0; i < matrix.rows(); ++i)
    for (Eigen::Index column = 0; column < columns; ++column)
      matrix(i, column) = rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(column)];
  return matrix;
}

class IpcToolkit final : public Contender {
 public:
  std::string name() const override { return "ipc-toolkit"; }
  Field field() const override { return Field::largest_step; }
  Cost run(const Task& task) override {
    const Stopwatch watch;
    if (!mesh_) {
      start_ = positions_of(task.start);
      end_ = positions_of(task.end);
      mesh_ = std::make_unique<ipc::CollisionMesh>(start_, indices_of(task.mesh.edges(), 2),
                                                   indices_of(task.mesh.faces(), 3));
    }
    step_ = ipc::compute_collision_free_stepsize(*mesh_, start_, end_);
    return watch.cost();
  }
  Answer answer(const Task&) override { return {0, 0, 0, 0, fmt::format("step {:.10g}", step_)}; }

 private:
  std::unique_ptr<ipc::CollisionMesh> mesh_;
  Eigen::MatrixXd start_, end_;
  double step_ = 0;
};

}  // namespace

void add_ipc_toolkit(Contenders& list) { list.push_back(std::make_unique<IpcToolkit>()); }

}  // namespace tamis::bench
