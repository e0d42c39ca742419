// What is right and what is wrong for each type that the public headers ask for.
#pragma once
#include <array>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "tamis/detector.hpp"
#include "tamis/pair.hpp"
#include "tamis/pair_distance.hpp"
#include "tamis/path.hpp"
#include "tamis/spline_path.hpp"

namespace tamis::test {

template <class T>
struct Type {};

template <class T>
struct Wrong {
  std::string name;
  T value;
};

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();
constexpr int kNoName = 99;

/// Two triangles, one of which falls through the other, and whatever the questions about them need.
class Right {
 public:
  template <class T>
  decltype(auto) of() {
    return get(Type<T>());
  }

  std::vector<Point> start{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {.25, .25, 1}, {1, .5, 2}, {.5, 1, 2}}, end = start;
  Detector detector{get(Type<Mesh>())};

 private:
  static Mesh get(Type<Mesh>) { return Mesh(6, {{0, 1, 2}, {3, 4, 5}}); }
  Step get(Type<Step>) { return {start, end}; }
  Positions get(Type<Positions>) { return start; }
  const Path& get(Type<Path>) { return path_; }
  static double get(Type<double>) { return 0.5; }
  static Index get(Type<Index>) { return 6; }
  static PairKind get(Type<PairKind>) { return PairKind::vertex_face; }
  static FeaturePair get(Type<FeaturePair>) { return {PairKind::vertex_face, {3, 0, 1, 2}}; }
  std::vector<FeaturePair>& get(Type<std::span<const FeaturePair>>) { return pairs_; }
  std::vector<PairResult>& get(Type<std::span<PairResult>>) { return results_; }
  std::span<const Point> get(Type<std::span<const Point>>) { return std::span(start).first(4); }
  template <class T>
  static std::optional<T> get(Type<std::optional<T>>) {
    return std::nullopt;
  }
  template <std::size_t n>
  static std::array<Index, n> get(Type<std::array<Index, n>>) {
    std::array<Index, n> result{3};
    for (std::size_t i = 1; i < n; ++i) result[i] = static_cast<Index>(i - 1);
    return result;
  }
  template <std::size_t n>
  std::array<Point, n> get(Type<std::array<Point, n>>) {
    std::array<Point, n> result;
    std::copy_n(start.begin(), n, result.begin());
    return result;
  }
  template <class T>
  static T get(Type<T>) {  // options, and lists of nothing
    return {};
  }

  BezierPath path_{{start, end}};
  std::vector<FeaturePair> pairs_{get(Type<FeaturePair>())};
  std::vector<PairResult> results_ = std::vector<PairResult>(1);
};

inline std::vector<Wrong<double>> wrong_values(Type<double>) {
  return {{"NaN", kNotANumber}, {"infinity", std::numeric_limits<double>::infinity()}, {"-1", -1}};
}

inline std::vector<Wrong<std::optional<double>>> wrong_values(Type<std::optional<double>>) {
  std::vector<Wrong<std::optional<double>>> found;
  for (const auto& [name, value] : wrong_values(Type<double>())) found.push_back({name, value});
  return found;
}

inline std::vector<Wrong<Index>> wrong_values(Type<Index>) {
  return {{"-1", -1}, {"the least number", std::numeric_limits<Index>::min()}};
}

template <class Enum>
std::enable_if_t<std::is_enum_v<Enum>, std::vector<Wrong<Enum>>> wrong_values(Type<Enum>) {
  return {{"a number without a name", static_cast<Enum>(kNoName)}};
}

inline std::vector<Wrong<Step>> wrong_values(Type<Step>) {
  static const std::vector<Point> none, fewer(2), good(6), bad(6, Point{kNotANumber, 0, 0});
  return {{"no rows", {none, none}},
          {"two rows", {fewer, fewer}},
          {"another number of rows", {good, fewer}},
          {"no memory", {Positions(nullptr, 6), good}},
          {"a stride of two", {good, Positions(good.front().data(), 6, 2)}},
          {"a negative number of rows", {Positions(good.front().data(), -1), Positions(good.front().data(), -1)}},
          {"NaN at the start", {bad, good}},
          {"NaN at the end", {good, bad}}};
}

inline std::vector<Wrong<Positions>> wrong_values(Type<Positions>) {
  std::vector<Wrong<Positions>> found;
  for (const auto& [name, step] : wrong_values(Type<Step>()))
    if (step.start.count() != 6 || step.start.data() != step.end.data()) found.push_back({name, step.start});
  std::erase_if(found, [](const auto& wrong) {
    return wrong.value.count() == 6 && wrong.value.data() && wrong.value[0][0] == 0;  // only the end was wrong
  });
  return found;
}

inline std::vector<Wrong<BezierPath>> wrong_values(Type<Path>) {
  return {{"of one vertex", BezierPath({{{0, 0, 0}}})}};
}

inline std::vector<Wrong<Mesh>> wrong_values(Type<Mesh>) { return {}; }  // none can be made

template <std::size_t n>
std::vector<Wrong<std::array<Index, n>>> wrong_values(Type<std::array<Index, n>>) {
  return {{"-1", {-1}}, {"a vertex that is not there", {kNoName}}};
}

template <std::size_t n>
std::vector<Wrong<std::array<Point, n>>> wrong_values(Type<std::array<Point, n>>) {
  return {{"NaN", {Point{0, kNotANumber, 0}}}};
}

/// Of rows of indices.
template <class Row>
std::vector<Wrong<std::vector<Row>>> wrong_values(Type<std::vector<Row>>) {
  std::vector<Wrong<std::vector<Row>>> found;
  if constexpr (std::is_same_v<Row, std::uint8_t>)
    found = {{"three flags", {1, 0, 1}}};
  else
    for (const auto& [name, value] : wrong_values(Type<Row>())) found.push_back({name, {value}});
  return found;
}

inline std::vector<Wrong<FeaturePair>> wrong_values(Type<FeaturePair>) {
  return {{"no kind", {static_cast<PairKind>(kNoName), {3, 0, 1, 2}}},
          {"a negative vertex", {PairKind::vertex_face, {3, 0, 1, -1}}},
          {"a vertex that is not there", {PairKind::edge_edge, {3, 0, 1, kNoName}}}};
}

inline auto wrong_values(Type<std::span<const FeaturePair>>) { return wrong_values(Type<std::vector<FeaturePair>>()); }

inline std::vector<Wrong<std::vector<PairResult>>> wrong_values(Type<std::span<PairResult>>) {
  return {{"of none", {}}, {"of two", std::vector<PairResult>(2)}};
}

inline std::vector<Wrong<std::vector<Point>>> wrong_values(Type<std::span<const Point>>) {
  return {{"none", {}}, {"three", std::vector<Point>(3)}, {"NaN", std::vector<Point>(4, Point{kNotANumber, 0, 0})}};
}

// Every value of these is right; functions that are none count as none.
template <class T>
std::vector<Wrong<std::function<T>>> wrong_values(Type<std::function<T>>) {
  return {};
}

}  // namespace tamis::test
