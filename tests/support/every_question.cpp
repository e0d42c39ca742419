#include "support/every_question.hpp"

#include <cmath>
#include <span>
#include <type_traits>

#include "scenes/shapes.hpp"

namespace tamis::test {
namespace {

using Numbers = std::vector<double>;

void append(Numbers& numbers, std::initializer_list<double> more) {
  numbers.insert(numbers.end(), more.begin(), more.end());
}

template <class Numbers3>
void append_all(Numbers& numbers, const Numbers3& more) {
  for (const auto x : more) numbers.push_back(static_cast<double>(x));
}

Numbers numbers_of(std::span<const Contact> contacts) {
  Numbers numbers;
  for (const Contact& c : contacts) {
    append(numbers, {double(c.kind), double(c.certainty), c.toi_lower, c.toi_upper, c.u, c.v});
    append_all(numbers, c.vertices);
    append_all(numbers, c.normal);
  }
  return numbers;
}

Numbers numbers_of(const EarliestContact& first) {
  Numbers numbers{first.toi_lower, first.toi_upper};
  if (first.contact) append_all(numbers, numbers_of(std::vector{*first.contact}));
  return numbers;
}

Numbers numbers_of(std::span<const NearPair> pairs) {
  Numbers numbers;
  for (const NearPair& p : pairs) {
    append(numbers, {double(p.kind), p.distance, p.u, p.v});
    append_all(numbers, p.vertices);
    append_all(numbers, p.direction);
  }
  return numbers;
}

Numbers numbers_of(const SafeStep& safe) {
  Numbers numbers{safe.toi_lower, safe.toi_upper};
  if (safe.pair) append_all(numbers, numbers_of(std::vector{*safe.pair}));
  return numbers;
}

Numbers numbers_of(std::span<const Intersection> intersections) {
  Numbers numbers;
  for (const Intersection& i : intersections) {
    append(numbers, {i.s_lower, i.s_upper, i.u, i.v});
    append_all(numbers, i.edge);
    append_all(numbers, i.face);
  }
  return numbers;
}

Numbers numbers_of(const TruncatedStep& step) {
  Numbers numbers{double(step.is_free)};
  for (const Point& p : step.positions) append_all(numbers, p);
  return numbers;
}

Numbers numbers_of(bool answer) { return {double(answer)}; }

template <class Ask>
AnyQuestion question(std::string name, const Ask& ask) {
  return {std::move(name), [ask](Detector& d) { return numbers_of(ask(d)); },
          [ask](Detector& d) { static_cast<void>(ask(d)); },
          !std::is_reference_v<std::invoke_result_t<Ask, Detector&>>};
}

}  // namespace

std::vector<AnyQuestion> questions_of(const scenes::Scene& scene, double distance) {
  const Step step = scene.step();
  const double separation = 0.1 * distance;
  return {question("contacts", [=](Detector& d) -> decltype(auto) { return d.contacts(step); }),
          question("contacts within a separation",
                   [=](Detector& d) -> decltype(auto) { return d.contacts(step, {.min_separation = separation}); }),
          question("earliest", [=](Detector& d) { return d.earliest(step); }),
          question("earliest within a separation",
                   [=](Detector& d) { return d.earliest(step, {.min_separation = separation}); }),
          question("is_free", [=](Detector& d) { return d.is_free(step); }),
          question("safe_step", [=](Detector& d) { return d.safe_step(step, 0.2); }),
          question("safe_step 0", [=](Detector& d) { return d.safe_step(step, 0); }),
          question("near", [=](Detector& d) -> decltype(auto) { return d.pairs_within(step.start, distance); }),
          question("intersections", [=](Detector& d) -> decltype(auto) { return d.intersections(step.end); }),
          question("has_intersection", [=](Detector& d) { return d.has_intersection(step.end); }),
          question("truncate", [=](Detector& d) { return d.truncate(step); })};
}

std::vector<AnyQuestion> questions_of(const Path& path, double separation) {
  const Path* const p = &path;
  return {question("contacts on a path", [=](Detector& d) -> decltype(auto) { return d.contacts(*p); }),
          question("contacts within a separation on a path",
                   [=](Detector& d) -> decltype(auto) { return d.contacts(*p, {.min_separation = separation}); }),
          question("earliest on a path", [=](Detector& d) { return d.earliest(*p); }),
          question("is_free on a path", [=](Detector& d) { return d.is_free(*p); })};
}

scenes::Scene two_sheets(Index cells) {
  scenes::Scene scene;
  for (const Index sheet : {0, 1}) {
    const Index first = scene.vertex_count();
    for (Index i = 0; i <= cells; ++i)
      for (Index j = 0; j <= cells; ++j) {
        const double x = static_cast<double>(i) / cells, z = static_cast<double>(j) / cells;
        const double wave = 0.05 * std::sin(9 * x + sheet) * std::cos(7 * z);
        if (sheet == 0)
          scene.add_vertex({x, wave, z}, {x, wave, z}, sheet);
        else
          scene.add_vertex({0.97 * x + 0.013, 0.1 + wave, 0.99 * z + 0.007},
                           {0.97 * x + 0.113, wave - 0.1, 0.99 * z + 0.051}, sheet);
      }
    scenes::add_grid_faces(scene, first, cells + 1, cells + 1);
  }
  return scene;
}

BezierPath bent_path(const scenes::Scene& scene) { return BezierPath({scene.start, scene.start, scene.end}); }

}  // namespace tamis::test
