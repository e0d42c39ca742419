// What a user may write, without a warning of any compiler.
#include <Eigen/Core>
#include <tamis/tamis.hpp>

namespace {

struct Xyz {
  double x, y, z;
};
struct Zyx {
  double z, y, x;
};
struct Integers {
  long long x, y, z;
};
struct WithPointer {
  const double* data;
  std::size_t count, stride;
  const double& operator[](std::size_t i) const { return data[i * stride]; }
};

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
template <class T>
constexpr bool kTaken = std::is_constructible_v<tamis::Positions, T>;

// Bug: what holds three doubles a vertex has to be copied.
static_assert(kTaken<const std::vector<tamis::Point>&> && kTaken<std::span<const tamis::Point>>);
static_assert(kTaken<std::vector<Eigen::Vector3d>&> && kTaken<std::vector<Eigen::RowVector3d>&>);
static_assert(kTaken<std::span<Eigen::Vector3d>> && kTaken<std::array<tamis::Point, 7>&> && kTaken<double (&)[7][3]>);
static_assert(kTaken<std::vector<Xyz>&>);
static_assert(kTaken<RowMajor&> && kTaken<Eigen::Matrix3Xd&> && kTaken<Eigen::Map<const RowMajor>>);
static_assert(kTaken<Eigen::Ref<const RowMajor>> && kTaken<decltype(std::declval<RowMajor&>().topRows(3))>);

// Bug: what is not a row of three doubles is read as if it were.
static_assert(!kTaken<std::vector<Zyx>&> && !kTaken<std::vector<Integers>&> && !kTaken<std::vector<WithPointer>&>);
static_assert(!kTaken<std::vector<std::vector<double>>&> && !kTaken<std::vector<Eigen::Vector4d>&>);
static_assert(!kTaken<std::vector<Eigen::Vector3f>&> && !kTaken<std::vector<double>&> && !kTaken<tamis::Point&>);

// Bug: a view of memory that is gone.
static_assert(!kTaken<std::vector<tamis::Point>> && !kTaken<const std::vector<tamis::Point>>);
static_assert(!kTaken<std::array<tamis::Point, 7>> && !kTaken<RowMajor> && !kTaken<Eigen::Matrix3Xd>);

}  // namespace

int main() {
  const std::vector<Eigen::Vector3f> floats(3);
  const std::vector<tamis::Point> points = tamis::points_of(floats);
  const std::vector<Eigen::Vector3d> vectors(3);
  // Bug: -Wextra warns of what {.threads = 1} leaves at its default.
  tamis::Detector detector(tamis::Mesh(3, {{0, 1, 2}}), {.threads = 1});
  (void)detector.contacts({points, vectors});
  const tamis::PairFilter filter{.group_of_vertex = {0, 0, 0}};
  const tamis::Options options{.min_separation = 1e-3, .filter = filter};
  const tamis::PairOptions pair{.latest = 0.5};
  const tamis::PairOptions list{.threads = 1};
  const tamis::PairOptions path{.tolerance = 1e-6};
  const tamis::Pose pose{.rotation = {0, 0, 1}};
  const tamis::RigidLink link{.end = pose};
  return options.threads + int(pair.latest + path.tolerance) + list.threads + int(link.start.position[0]);
}
