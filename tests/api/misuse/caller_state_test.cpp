// Answers do not depend on the floating-point state of the caller, which has it again afterwards and in its own
// functions. Bug: where results are rounded downward, every simple contact is "free"; where subnormal numbers are zero,
// contacts between such numbers are lost or invented.
#include <gtest/gtest.h>

#include <mutex>
#include <set>

#include "scenes/point_math.hpp"
#include "support/caller_states.hpp"
#include "support/every_question.hpp"
#include "support/pair_cases.hpp"
#include "tamis/error.hpp"
#include "tamis/pair_distance.hpp"
#include "tamis/rigid_path.hpp"

namespace tamis::test {
namespace {

using Numbers = std::vector<double>;
using scenes::Scene;

void append(Numbers& numbers, const PairResult& r) {
  numbers.insert(numbers.end(),
                 {double(r.touches), r.toi_lower, r.toi_upper, r.u, r.v, r.normal[0], r.normal[1], r.normal[2]});
}
void append(Numbers& numbers, const Point& p) { numbers.insert(numbers.end(), p.begin(), p.end()); }
void append(Numbers& numbers, const Pose& pose) {
  append(numbers, pose.position);
  append(numbers, pose.rotation);
}
void append(Numbers& numbers, const RigidChain& chain) {
  for (const RigidLink& link : chain) {
    append(numbers, link.start);
    append(numbers, link.end);
  }
}
void append(Numbers& numbers, const NearPair& p) {
  numbers.insert(numbers.end(), {p.distance, p.u, p.v});
  append(numbers, p.direction);
}

Scene scaled(Scene scene, double factor) {
  for (auto* points : {&scene.start, &scene.end})
    for (Point& p : *points)
      for (double& x : p) x *= factor;
  return scene;
}

Options threads(int count) {
  Options options;
  options.threads = count;
  return options;
}

void expect_same_answers(const Scene& scene, double distance, int thread_count) {
  const Mesh mesh = scene.mesh();
  for (const AnyQuestion& question : questions_of(scene, distance))
    expect_same_in_all_states(question.name + ", " + std::to_string(thread_count) + " threads", [&] {
      Detector detector(mesh, threads(thread_count));
      Numbers numbers = question.ask(detector), again = question.ask(detector);
      numbers.insert(numbers.end(), again.begin(), again.end());
      return numbers;
    });
}

class OfThreads : public testing::TestWithParam<int> {};

TEST_P(OfThreads, QuestionsAboutStepsAreAnsweredAlike) {
  const Index cells = 24;
  expect_same_answers(two_sheets(cells), 0.3 * edge_of_sheets(cells), GetParam());
}

TEST_P(OfThreads, SubnormalScenesAreAnsweredAlike) {
  const Index cells = 8;
  expect_same_answers(scaled(two_sheets(cells), 0x1p-1040), 0x1p-1042 * edge_of_sheets(cells), GetParam());
}

TEST_P(OfThreads, QuestionsAboutPathsAreAnsweredAlike) {
  const Index cells = 8;
  const Scene scene = two_sheets(cells);
  const Mesh mesh = scene.mesh();
  const std::size_t questions = questions_of(bent_path(scene), 0.1 * edge_of_sheets(cells)).size();
  for (std::size_t i = 0; i < questions; ++i)
    expect_same_in_all_states("path", [&] {
      const BezierPath path = bent_path(scene);
      Detector detector(mesh, threads(GetParam()));
      return questions_of(path, 0.1 / 8)[i].ask(detector);
    });
}

INSTANTIATE_TEST_SUITE_P(Of, OfThreads, testing::Values(0, 1, 4));

/// A vertex through a face at t = 1/2, two edges, and all families of pairs.
TEST(CallerState, PairsAreDecidedAlike) {
  const std::array<Point, 4> start{{{0.25, 0.25, 1}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  const std::array<Point, 4> end{{{0.25, 0.25, -1}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  for (const double separation : {0.0, 0.125}) {
    const PairOptions options{.min_separation = separation};
    in_state({"downward", FE_DOWNWARD, false}, [&] {
      EXPECT_TRUE(vertex_face(start, end, options).touches);
      EXPECT_TRUE(edge_edge({start[0], {0.25, 0.25, 2}, start[1], start[2]}, {end[0], {0.25, 0.25, -2}, end[1], end[2]},
                            {.min_separation = 0.3})
                      .touches);
    });
  }
  scenes::Random random(5);
  for (const Family& family : kFamilies)
    for (int i = 0; i < 20; ++i) {
      for (const double factor : {1.0, 0x1p-1050}) {
        // Everything that is given is computed here, to nearest.
        const auto make = [&](PairKind kind) {
          oracle::Motion motion = family.make(kind, random);
          for (auto* points : {&motion.start, &motion.end})
            for (Point& p : *points)
              for (double& x : p) x *= factor;
          return motion;
        };
        const oracle::Motion vf = make(PairKind::vertex_face), ee = make(PairKind::edge_edge);
        const oracle::Motion ve = make(PairKind::vertex_edge), vv = make(PairKind::vertex_vertex);
        const PairOptions options{.min_separation = 0.125 * factor};
        expect_same_in_all_states(std::string(family.name), [&] {
          Numbers numbers;
          append(numbers, vertex_face(vf.start, vf.end, options));
          append(numbers, vertex_face(vf.start, vf.end));
          append(numbers, edge_edge(ee.start, ee.end, options));
          append(numbers, edge_edge(ee.start, ee.end));
          append(numbers, vertex_edge({ve.start[0], ve.start[1], ve.start[2]}, {ve.end[0], ve.end[1], ve.end[2]}));
          append(numbers, vertex_vertex({vv.start[0], vv.start[1]}, {vv.end[0], vv.end[1]}, options));
          const FeaturePair pair{PairKind::edge_edge, {0, 1, 2, 3}};
          append(numbers, distance_of(pair, ee.start));
          for (const double keep : {0.0, 0.3}) {
            const SafeStep safe = safe_step(pair, {ee.start, ee.end}, keep);
            numbers.insert(numbers.end(), {safe.toi_lower, safe.toi_upper});
          }
          return numbers;
        });
      }
    }
}

TEST(CallerState, ListsAreDecidedAlike) {
  scenes::Random random(6);
  std::vector<Point> start, end;
  std::vector<FeaturePair> pairs;
  for (const Family& family : kFamilies)
    for (int i = 0; i < 1000; ++i) {
      const oracle::Motion motion = family.make(PairKind::vertex_face, random);
      const auto first = static_cast<Index>(start.size());
      start.insert(start.end(), motion.start.begin(), motion.start.end());
      end.insert(end.end(), motion.end.begin(), motion.end.end());
      pairs.push_back({PairKind::vertex_face, {first, first + 1, first + 2, first + 3}});
    }
  for (const int thread_count : {0, 1, 4})
    for (const double separation : {0.0, 0.125})
      expect_same_in_all_states("list", [&] {
        const PairOptions options{.min_separation = separation, .threads = thread_count};
        Numbers numbers;
        for (const PairResult& r : narrow_phase(pairs, {start, end}, options)) append(numbers, r);
        std::vector<PairResult> results(pairs.size());
        narrow_phase(PairKind::vertex_face, start, end, results, options);
        for (const PairResult& r : results) append(numbers, r);
        return numbers;
      });
}

TEST(CallerState, PosesAndPathsAreMadeAlike) {
  scenes::Random random(7);
  for (int i = 0; i < 50; ++i) {
    const auto point = [&](double size) {
      return Point{size * random.unit(), size * random.unit(), size * random.unit()};
    };
    const Pose a{point(1), point(3)}, b{point(1), point(3)};
    const Point center = point(1), x = point(1);
    const double time = random.unit(), half = 0.5 * time;
    expect_same_in_all_states("poses", [=] {
      Numbers numbers;
      append(numbers, interpolated_chain(a, b));
      append(numbers, turned_chain(a, b.rotation, b.position, center));
      const RigidChain chain = chain_between(a, b, center);
      append(numbers, chain);
      append(numbers, pose_at(chain, time));
      append(numbers, pose_at(interpolated_chain(a, b), time));
      numbers.push_back(nlerp_deviation(a, b));
      append(numbers, pose_of_quaternion({0.6, 0.48, 0.64, 0.00001}, x));
      append(numbers, pose_of_matrix({{{0.6, -0.8, 1e-9}, {0.8, 0.6, 0}, {0, 1e-9, 1}}}, x));
      for (const double weight : weights_of(PairKind::vertex_face, x[0], x[1])) numbers.push_back(weight);

      const RigidPath rigid({x, center}, {0, 0}, {chain});
      const BezierPath bezier({{x, center}, {center, a.position}, {b.position, x}});
      const CatmullRomPath smooth({{x, center}, {center, a.position}, {b.position, x}});
      for (const Path* path : std::initializer_list<const Path*>{&rigid, &bezier, &smooth}) {
        const Index vertices[]{0, 1};
        Point points[2], directions[2];
        double errors[2];
        FinePoint fine[2];
        path->points_at(time, vertices, points, errors);
        append(numbers, points[0]);
        numbers.insert(numbers.end(), {errors[0], errors[1]});
        path->fine_points_at(time, vertices, fine);
        append(numbers, fine[0].high);
        append(numbers, fine[0].low);
        numbers.push_back(fine[0].error);
        path->deviations(half, time, vertices, errors);
        numbers.insert(numbers.end(), {errors[0], errors[1]});
        path->straight_directions(vertices, directions);
        append(numbers, directions[1]);
        append(numbers, vertex_vertex(*path, {0, 1}, {.min_separation = 0.25}));
      }
      return numbers;
    });
  }
}

/// Collects the states in which the caller's functions run.
class Seen {
 public:
  void look() {
    const std::string here = state_here();
    const std::lock_guard lock(mutex_);
    states_.insert(here);
  }
  const std::set<std::string>& states() const { return states_; }

 private:
  std::mutex mutex_;
  std::set<std::string> states_;
};

/// A path that looks at the state in each call.
class SeenPath final : public Path {
 public:
  SeenPath(const Path& path, Seen& seen) : path_(path), seen_(seen) {}
  Index vertex_count() const override {
    seen_.look();
    return path_.vertex_count();
  }
  void points_at(double time, std::span<const Index> v, std::span<Point> p, std::span<double> e) const override {
    seen_.look();
    path_.points_at(time, v, p, e);
  }
  void fine_points_at(double time, std::span<const Index> v, std::span<FinePoint> p) const override {
    seen_.look();
    path_.fine_points_at(time, v, p);
  }
  void deviations(double from, double to, std::span<const Index> v, std::span<double> d) const override {
    seen_.look();
    path_.deviations(from, to, v, d);
  }
  void straight_directions(std::span<const Index> v, std::span<Point> d) const override {
    seen_.look();
    path_.straight_directions(v, d);
  }

 private:
  const Path& path_;
  Seen& seen_;
};

TEST_P(OfThreads, CallersFunctionsHaveTheCallersState) {
  const Index cells = 16;
  const Scene scene = two_sheets(cells);
  const Mesh mesh = scene.mesh();
  const BezierPath bent = bent_path(scene);
  for (const CallerState& state : kCallerStates) {
    Seen in_functions, in_paths;
    std::string expected;
    in_state(state, [&] {
      expected = state_here();
      Options options = threads(GetParam());
      options.is_cancelled = [&] {
        in_functions.look();
        return false;
      };
      // It may ask another detector, which computes as always.
      std::atomic<int> asked = 0, others = 0;
      options.filter.accepts = [&](PairKind, const std::array<Index, 4>&) {
        in_functions.look();
        if (asked++ % 64 == 0) others += Detector(mesh, threads(1)).is_free(scene.step());
        in_functions.look();
        return true;
      };
      Detector detector(mesh, options);
      for (const AnyQuestion& question : questions_of(scene, 0.1 / cells)) question.ask_only(detector);
      const SeenPath path(bent, in_paths);
      for (const AnyQuestion& question : questions_of(path, 0.01 / cells)) question.ask_only(detector);
      (void)vertex_face(path, {0, 300, 301, 320}, {.min_separation = 0.1});
      EXPECT_EQ(others, 0) << "the sheets touch";
    });
    EXPECT_EQ(in_functions.states(), std::set{expected});
    EXPECT_EQ(in_paths.states(), std::set{expected});
  }
}

TEST(CallerState, ComesBackAfterAnException) {
  const Scene scene = two_sheets(8);
  const Mesh mesh = scene.mesh();
  const BezierPath path = bent_path(scene);
  for (const CallerState& state : kCallerStates) {
    std::string before;
    const std::string after = in_state(state, [&] {
      before = state_here();
      Options options = threads(2);
      options.filter.accepts = [](PairKind, const std::array<Index, 4>&) -> bool {
        throw std::runtime_error("a test");
      };
      Detector throwing(mesh, options);
      Options cancelled = threads(2);
      cancelled.is_cancelled = [] { return true; };
      Detector stopping(mesh, cancelled);
      EXPECT_THROW((void)throwing.contacts(scene.step()), std::runtime_error);
      EXPECT_EQ(state_here(), before);
      EXPECT_THROW((void)stopping.contacts(scene.step()), Cancelled);
      EXPECT_EQ(state_here(), before);
      EXPECT_THROW((void)stopping.contacts(path), Cancelled);
      EXPECT_THROW((void)stopping.contacts(Step{}), InvalidStep);
      EXPECT_THROW((void)vertex_face(std::array<Point, 4>{}, {}, {.min_separation = -1}), InvalidOptions);
      EXPECT_THROW((void)pose_at({}, 2), InvalidPath);
      EXPECT_THROW(RigidPath({{0, 0, 0}}, {3}, {}), InvalidPath);
    });
    EXPECT_EQ(after, before);
  }
}

}  // namespace
}  // namespace tamis::test
