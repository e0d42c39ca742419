// Each block after "says" is a mistake: the compiler must not take it, and say what stands there. It takes the rest.
#include <Eigen/Core>
#include <tamis/tamis.hpp>

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

std::vector<tamis::Point> make_points();

int main() {
  tamis::Detector detector(tamis::Mesh(3, {{0, 1, 2}}));
  const RowMajor x = RowMajor::Zero(3, 3), v = x;
  {
    const RowMajor y = x + v;
    (void)detector.contacts({x, y});
  }
  {  // says: A temporary may be gone when the question is asked: keep it in a variable.
    const tamis::Step step{x, (x + v).eval()};
  }
  {  // says: A temporary may be gone when the question is asked: keep it in a variable.
    const tamis::Positions positions = make_points();
  }
  {  // says: Floats, or an expression without memory? tamis::points_of(x) copies it as doubles.
    const tamis::Step step{x, x + v};
  }
  {  // says: Floats, or an expression without memory? tamis::points_of(x) copies it as doubles.
    const Eigen::MatrixX3f floats = Eigen::MatrixX3f::Zero(3, 3);
    (void)detector.pairs_within(floats, 1);
  }
  {  // says: Floats? tamis::points_of(x).
    const std::vector<Eigen::Vector3f> floats(3);
    const tamis::Step step{floats, floats};
  }
  {  // says: Flat doubles, x y z x y z? Positions(data, vertices).
    const std::vector<double> flat(9);
    (void)detector.pairs_within(flat, 1);
  }
  {  // says: Column-major? Keep tamis::points_of(x).
    const Eigen::MatrixXd columns = x;
    (void)detector.pairs_within(columns, 1);
  }
  {  // says: Flat x y z? Positions(x.data(), vertices).
    const Eigen::VectorXd flat = Eigen::VectorXd::Zero(9);
    (void)detector.pairs_within(flat, 1);
  }
  {  // says: A matrix? tamis::faces_of(matrix).
    const tamis::Mesh mesh(3, Eigen::MatrixXi::Zero(1, 3));
  }
  {  // says: A matrix? tamis::edges_of(matrix).
    const tamis::Mesh mesh(3, {}, Eigen::MatrixXi::Zero(1, 2));
  }
}
