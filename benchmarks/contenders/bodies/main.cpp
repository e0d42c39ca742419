// tamis_body_contenders: public packages and Tamis on the same pairs of moving bodies; answers are compared with an
// oracle before times count.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

#include "benchmarks/contenders/bodies/bodies.hpp"

namespace tamis::bench {
namespace {

/// A time is right if it is off by no more than this part of the step.
constexpr double kRight = 1e-3;

BodyContenders all_contenders() {
  BodyContenders list;
#define TAMIS_CONTENDER(name) add_##name(list);
#include "benchmarks/body_contenders.inc"
#undef TAMIS_CONTENDER
  return list;
}

struct Row {
  int right = 0, missed = 0, late = 0, early = 0, no_answer = 0;
  double largest_error = 0;  ///< of the right times
  std::vector<double> microseconds;
  std::vector<std::size_t> wrong;

  void add(std::size_t pair, double truth, double answer) {
    const bool touches = truth <= 1, says_so = answer <= 1;
    if (answer == kNoAnswer)
      ++no_answer;
    else if (touches && !says_so)
      ++missed;
    else if (says_so && answer > truth + kRight)
      ++late;
    else if (says_so && answer < truth - kRight)
      ++early;
    else {
      ++right;
      if (touches) largest_error = std::max(largest_error, std::abs(answer - truth));
      return;
    }
    wrong.push_back(pair);
  }
};

/// The least time of `repeat` runs.
double microseconds_of(BodyContender& contender, int repeat) {
  double least = 1e300;
  for (int i = 0; i < repeat; ++i) {
    const auto start = std::chrono::steady_clock::now();
    contender.first_contact();
    const std::chrono::duration<double, std::micro> took = std::chrono::steady_clock::now() - start;
    least = std::min(least, took.count());
  }
  return least;
}

Row row_of(BodyContender& contender, const BodyScene& scene, const std::vector<double>& truths, int repeat) {
  Row row;
  for (std::size_t i = 0; i < scene.pairs.size(); ++i) {
    contender.take(scene.pairs[i], scene.is_convex);
    row.add(i, truths[i], contender.first_contact());
    row.microseconds.push_back(microseconds_of(contender, repeat));
  }
  return row;
}

void print(const std::string& name, const Row& row) {
  std::vector<double> times = row.microseconds;
  std::ranges::sort(times);
  std::string wrong;
  for (std::size_t i = 0; i < std::min<std::size_t>(row.wrong.size(), 5); ++i)
    wrong += fmt::format(" {}", row.wrong[i]);
  fmt::print("{:<36} {:>6} {:>6} {:>6} {:>6} {:>6} {:>9.1e} {:>10.1f} {:>10.1f} {}\n", name, row.right, row.missed,
             row.late, row.early, row.no_answer, row.largest_error, times[times.size() / 2], times.back(), wrong);
  std::fflush(stdout);
}

std::vector<double> truths_of(const BodyScene& scene) {
  std::vector<double> truths;
  for (const MovingPair& pair : scene.pairs) truths.push_back(true_first_contact(pair));
  return truths;
}

/// Prints a row for each contender. Returns whether Tamis is right about all pairs.
bool compare(const BodyScene& scene, const BodyContenders& contenders, int repeat) {
  const std::vector<double> truths = truths_of(scene);
  const auto touching = std::ranges::count_if(truths, [](double truth) { return truth <= 1; });
  fmt::print("\n{}: {} pairs, {} touch\n{:<36} {:>6} {:>6} {:>6} {:>6} {:>6} {:>9} {:>10} {:>10} {}\n", scene.name,
             truths.size(), touching, "", "right", "missed", "late", "early", "none", "error", "us", "most us",
             "wrong at");
  bool is_right = true;
  for (const auto& contender : contenders) {
    if (!contender->knows(scene)) continue;
    const Row row = row_of(*contender, scene, truths, repeat);
    print(contender->name(), row);
    if (contender->name() == "Tamis") is_right = row.wrong.empty();
  }
  return is_right;
}

/// Prints the answers of all contenders for one pair.
void show(const BodyScene& scene, const BodyContenders& contenders, std::size_t number) {
  const MovingPair& pair = scene.pairs.at(number);
  fmt::print("\n{}, pair {}\n{:<36} {:.12g}\n", scene.name, number, "oracle", true_first_contact(pair));
  for (const auto& contender : contenders)
    if (contender->knows(scene)) {
      contender->take(pair, scene.is_convex);
      fmt::print("{:<36} {:.12g}\n", contender->name(), contender->first_contact());
    }
}

}  // namespace
}  // namespace tamis::bench

int main(int argc, char** argv) {
  CLI::App app("Public packages and Tamis on pairs of moving bodies: answers compared, then times.",
               "tamis_body_contenders");
  int pairs = 200, repeat = 5;
  std::optional<std::size_t> number;
  std::string only;
  app.add_option("--pairs", pairs, "of convex bodies; of meshes a tenth")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  app.add_option("--repeat", repeat, "timed runs of each pair; the least counts")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app.add_option("--scene", only, "only scenes whose name has this in it");
  app.add_option("--pair", number, "what all say of the pair of this number; 2: never, -1: no answer");
  CLI11_PARSE(app, argc, argv);
  const auto contenders = tamis::bench::all_contenders();
  bool is_right = true;
  for (const auto& scene : tamis::bench::body_scenes(pairs)) {
    if (scene.name.find(only) == std::string::npos) continue;
    if (!number)
      is_right &= tamis::bench::compare(scene, contenders, repeat);
    else if (*number < scene.pairs.size())
      tamis::bench::show(scene, contenders, *number);
  }
  return is_right ? 0 : 1;
}
