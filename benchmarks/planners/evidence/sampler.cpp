// sampler SCENE FLAGS: sampled checks of edges by coal, and the truth by an independent route. Compiled with WITH_FCL:
// sampled checks by FCL alone (both packages have an octomap of their own, which one process cannot hold).
//
// The truth: for each pair of bodies coal's distance at a time, divided by a bound of their relative speed, is how far
// the pair may go on. An edge is free if all pairs reach its end, and collides if a state on the way does. Where the
// distance falls below kNear and no state collides, the edge is left open. Prints a line for each method: its name,
// seconds, and the answers are in FLAGS, a byte an edge and method: 0 free, 1 collides, 2 open.
#ifdef WITH_FCL
#include <fcl/fcl.h>
#else
#include <coal/BVH/BVH_model.h>
#include <coal/collision.h>
#include <coal/distance.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using Vector = Eigen::Vector3d;
using Matrix = Eigen::Matrix3d;
constexpr double kNear = 1e-6, kFar = 0.02;

struct Joint {
  std::int64_t parent, turns, coordinate;
  double factor, offset;
  Vector shift, axis;
};

struct Body {
  std::int64_t joint;
  std::vector<Vector> points;
  std::vector<std::array<std::int64_t, 3>> faces;
  double radius = 0;  ///< around the joint
  Vector center = Vector::Zero();
  double around = 0;  ///< the radius around the center
};

struct Place {
  Matrix turn = Matrix::Identity();
  Vector shift = Vector::Zero();
};

struct Scene {
  std::vector<Joint> joints;
  std::vector<Body> bodies;
  std::vector<std::array<std::int64_t, 2>> pairs;
  std::int64_t dimension = 0, edges = 0;
  std::vector<double> starts, ends;
};

template <class T>
T read(std::ifstream& file) {
  T value{};
  file.read(reinterpret_cast<char*>(&value), sizeof value);
  if (!file) throw std::runtime_error("the scene's file ends early");
  return value;
}

Vector read_vector(std::ifstream& file) {
  const double x = read<double>(file), y = read<double>(file), z = read<double>(file);
  return {x, y, z};
}

Scene read_scene(const char* name) {
  std::ifstream file(name, std::ios::binary);
  Scene scene;
  scene.joints.resize(static_cast<std::size_t>(read<std::int64_t>(file)));
  for (Joint& joint : scene.joints) {
    joint.parent = read<std::int64_t>(file), joint.turns = read<std::int64_t>(file);
    joint.coordinate = read<std::int64_t>(file);
    joint.factor = read<double>(file), joint.offset = read<double>(file);
    joint.shift = read_vector(file), joint.axis = read_vector(file);
  }
  scene.bodies.resize(static_cast<std::size_t>(read<std::int64_t>(file)));
  for (Body& body : scene.bodies) {
    body.joint = read<std::int64_t>(file);
    body.points.resize(static_cast<std::size_t>(read<std::int64_t>(file)));
    body.faces.resize(static_cast<std::size_t>(read<std::int64_t>(file)));
    for (Vector& point : body.points) body.radius = std::max(body.radius, (point = read_vector(file)).norm());
    for (const Vector& point : body.points) body.center += point / static_cast<double>(body.points.size());
    for (const Vector& point : body.points) body.around = std::max(body.around, (point - body.center).norm());
    for (auto& face : body.faces)
      for (std::int64_t& corner : face) corner = read<std::int64_t>(file);
  }
  scene.pairs.resize(static_cast<std::size_t>(read<std::int64_t>(file)));
  for (auto& pair : scene.pairs) pair = {read<std::int64_t>(file), read<std::int64_t>(file)};
  scene.dimension = read<std::int64_t>(file), scene.edges = read<std::int64_t>(file);
  for (auto* list : {&scene.starts, &scene.ends}) {
    list->resize(static_cast<std::size_t>(scene.dimension * scene.edges));
    for (double& number : *list) number = read<double>(file);
  }
  return scene;
}

/// One edge, and where bodies are on it.
class Edge {
 public:
  Edge(const Scene& scene, std::int64_t number)
      : scene_(scene),
        start_(&scene.starts[static_cast<std::size_t>(number * scene.dimension)]),
        end_(&scene.ends[static_cast<std::size_t>(number * scene.dimension)]) {}

  double value(const Joint& joint, double time) const {
    const auto c = static_cast<std::size_t>(joint.coordinate);
    return joint.factor * ((1 - time) * start_[c] + time * end_[c]) + joint.offset;
  }

  /// The places of all joints.
  const std::vector<Place>& places(double time) {
    places_.resize(scene_.joints.size());
    for (std::size_t k = 0; k < places_.size(); ++k) {
      const Joint& joint = scene_.joints[k];
      const Place parent = joint.parent < 0 ? Place{} : places_[static_cast<std::size_t>(joint.parent)];
      const double v = value(joint, time);
      const Vector shift = joint.turns ? joint.shift : Vector(joint.shift + v * joint.axis);
      places_[k].turn =
          joint.turns ? Matrix(parent.turn * Eigen::AngleAxisd(v, joint.axis).toRotationMatrix()) : parent.turn;
      places_[k].shift = parent.turn * shift + parent.shift;
    }
    return places_;
  }

  /// No two points of a pair of bodies change their distance faster.
  double speed(std::int64_t a, std::int64_t b) const {
    const std::vector<std::int64_t> first = chain(a), second = chain(b);
    std::size_t common = 0;
    while (common < first.size() && common < second.size() && first[common] == second[common]) ++common;
    return speed_beyond(first, common, a) + speed_beyond(second, common, b);
  }

 private:
  std::vector<std::int64_t> chain(std::int64_t body) const {
    std::vector<std::int64_t> joints;
    for (std::int64_t k = scene_.bodies[static_cast<std::size_t>(body)].joint; k >= 0;
         k = scene_.joints[static_cast<std::size_t>(k)].parent)
      joints.insert(joints.begin(), k);
    return joints;
  }

  double speed_beyond(const std::vector<std::int64_t>& chain, std::size_t common, std::int64_t body) const {
    double reach = scene_.bodies[static_cast<std::size_t>(body)].radius, sum = 0;
    for (std::size_t i = chain.size(); i-- > common;) {
      const Joint& joint = scene_.joints[static_cast<std::size_t>(chain[i])];
      const double from = value(joint, 0), to = value(joint, 1);
      sum += std::abs(to - from) * (joint.turns ? reach : 1);
      reach += joint.shift.norm() + (joint.turns ? 0 : std::max(std::abs(from), std::abs(to)));
    }
    return sum;
  }

  const Scene& scene_;
  const double *start_, *end_;
  std::vector<Place> places_;
};

#ifdef WITH_FCL
struct Fcl {
  static constexpr const char* name = "FCL";
  using Model = fcl::BVHModel<fcl::OBBRSSd>;
  std::vector<std::unique_ptr<fcl::CollisionObjectd>> objects;

  explicit Fcl(const Scene& scene) {
    for (const Body& body : scene.bodies) {
      auto model = std::make_shared<Model>();
      std::vector<fcl::Vector3d> points(body.points.begin(), body.points.end());
      std::vector<fcl::Triangle> faces;
      for (const auto& f : body.faces)
        faces.emplace_back(static_cast<std::size_t>(f[0]), static_cast<std::size_t>(f[1]),
                           static_cast<std::size_t>(f[2]));
      model->beginModel(static_cast<int>(faces.size()), static_cast<int>(points.size()));
      model->addSubModel(points, faces);
      model->endModel();
      model->computeLocalAABB();
      objects.push_back(std::make_unique<fcl::CollisionObjectd>(model));
      objects.back()->computeAABB();
    }
  }
  void place(std::size_t body, const Place& p) {
    objects[body]->setTransform(p.turn, p.shift);
    objects[body]->computeAABB();
  }
  bool collides(std::size_t a, std::size_t b) const {
    if (!objects[a]->getAABB().overlap(objects[b]->getAABB())) return false;
    fcl::CollisionResultd result;
    return fcl::collide(objects[a].get(), objects[b].get(), fcl::CollisionRequestd(), result) > 0;
  }
};
#else
struct Coal {
  static constexpr const char* name = "coal";
  using Model = coal::BVHModel<coal::OBBRSS>;
  std::vector<std::unique_ptr<coal::CollisionObject>> objects;

  explicit Coal(const Scene& scene) {
    for (const Body& body : scene.bodies) {
      auto model = std::make_shared<Model>();
      std::vector<coal::Vec3s> points(body.points.begin(), body.points.end());
      std::vector<coal::Triangle> faces;
      for (const auto& f : body.faces)
        faces.emplace_back(static_cast<unsigned>(f[0]), static_cast<unsigned>(f[1]), static_cast<unsigned>(f[2]));
      model->beginModel(static_cast<unsigned>(faces.size()), static_cast<unsigned>(points.size()));
      model->addSubModel(points, faces);
      model->endModel();
      model->computeLocalAABB();
      objects.push_back(std::make_unique<coal::CollisionObject>(model));
      objects.back()->computeAABB();
    }
  }
  void place(std::size_t body, const Place& p) {
    objects[body]->setTransform(coal::Transform3s(p.turn, p.shift));
    objects[body]->computeAABB();
  }
  bool collides(std::size_t a, std::size_t b) const {
    if (!objects[a]->getAABB().overlap(objects[b]->getAABB())) return false;
    coal::CollisionResult result;
    return coal::collide(objects[a].get(), objects[b].get(), coal::CollisionRequest(), result) > 0;
  }
  double distance(std::size_t a, std::size_t b) const {
    coal::DistanceResult result;
    return coal::distance(objects[a].get(), objects[b].get(), coal::DistanceRequest(), result);
  }
};
#endif

template <class Package>
void place_all(const Scene& scene, Edge& edge, double time, Package& package) {
  const std::vector<Place>& places = edge.places(time);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    if (scene.bodies[i].joint >= 0) package.place(i, places[static_cast<std::size_t>(scene.bodies[i].joint)]);
}

template <class Package>
bool collides(const Scene& scene, Edge& edge, double time, Package& package) {
  place_all(scene, edge, time, package);
  return std::ranges::any_of(scene.pairs, [&](const auto& pair) {
    return package.collides(static_cast<std::size_t>(pair[0]), static_cast<std::size_t>(pair[1]));
  });
}

/// The numbers 0 to count, its ends first, then in the order of bisection, as planners test states.
std::vector<int> bisected(int count) {
  std::vector<int> order{0, count};
  std::vector<std::array<int, 2>> parts{{1, count - 1}};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto [low, high] = parts[i];
    if (low > high) continue;
    const int middle = (low + high) / 2;
    order.push_back(middle);
    parts.push_back({low, middle - 1});
    parts.push_back({middle + 1, high});
  }
  return order;
}

std::ofstream flags;

template <class Answers>
void report(const std::string& name, const Answers& answer_of, std::int64_t edges) {
  std::string answers;
  const std::clock_t begin = std::clock();  // time of this processor: a busy machine changes it less
  for (std::int64_t i = 0; i < edges; ++i) answers.push_back(static_cast<char>(answer_of(i)));
  const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  std::printf("%s\t%.9g\n", name.c_str(), seconds);
  std::fflush(stdout);
  flags << answers << std::flush;
}

template <class Package>
void sample(const Scene& scene, int states) {
  Package package(scene);
  const std::vector<int> order = bisected(states - 1);
  report(
      std::string(Package::name) + ", " + std::to_string(states),
      [&](std::int64_t i) {
        Edge edge(scene, i);
        return std::ranges::any_of(order,
                                   [&](int k) { return collides(scene, edge, k / double(states - 1), package); });
      },
      scene.edges);
}

#ifndef WITH_FCL
/// A bound of the distance of two bodies: the gap between the balls around them.
double balls_gap(const Scene& scene, const std::vector<Place>& places, std::size_t a, std::size_t b) {
  const auto center = [&](const Body& body) -> Vector {
    if (body.joint < 0) return body.center;
    const Place& place = places[static_cast<std::size_t>(body.joint)];
    return place.turn * body.center + place.shift;
  };
  const Body &first = scene.bodies[a], &second = scene.bodies[b];
  return (center(first) - center(second)).norm() - first.around - second.around;
}

/// 0: this pair is free all along. 1: it collides at a state. 2: it comes nearer than kNear, and no state collides.
/// Coal also says "collides" of triangles up to 1e-6 apart, so its distance must be 0, too.
int truth_of(const Scene& scene, Edge& edge, std::int64_t a, std::int64_t b, Coal& coal) {
  const double speed = edge.speed(a, b);
  const auto first = static_cast<std::size_t>(a), second = static_cast<std::size_t>(b);
  bool is_open = false;
  for (double time = 0;;) {
    const std::vector<Place>& places = edge.places(time);
    for (const std::size_t body : {first, second})
      if (scene.bodies[body].joint >= 0) coal.place(body, places[static_cast<std::size_t>(scene.bodies[body].joint)]);
    double gap = balls_gap(scene, places, first, second);
    if (gap < kFar) {
      gap = coal.distance(first, second);
      if (gap <= 0 && coal.collides(first, second)) return 1;
    }
    is_open = is_open || gap <= kNear;
    if (speed == 0 || time >= 1) return is_open ? 2 : 0;
    time = std::min(1., time + std::max(gap, kNear) / speed);
  }
}

int truth(const Scene& scene, std::int64_t number, Coal& coal) {
  Edge edge(scene, number);
  int worst = 0;
  for (const auto& pair : scene.pairs) {
    const int found = truth_of(scene, edge, pair[0], pair[1], coal);
    if (found == 1) return 1;
    worst = std::max(worst, found);
  }
  return worst;
}
#endif

}  // namespace

int main(int count, char** names) {
  if (count != 3) return 2;
  const Scene scene = read_scene(names[1]);
  flags.open(names[2], std::ios::binary);
#ifdef WITH_FCL
  for (const int states : {10, 100}) sample<Fcl>(scene, states);
#else
  for (const int states : {10, 100, 1000}) sample<Coal>(scene, states);
  Coal coal(scene);
  report(
      "truth", [&](std::int64_t i) { return truth(scene, i, coal); }, scene.edges);
#endif
}
