// What is wrong on one rank is thrown on all of them, alike, and nobody waits for ever; then all goes on.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "distributed/tests/parts.hpp"
#include "scenes/scene_list.hpp"
#include "support/copied.hpp"
#include "tamis/detector.hpp"
#include "tamis/error.hpp"

namespace tamis::test {
namespace {

using scenes::Scene;

int last() { return rank_count() - 1; }
bool is_last() { return rank_of() == last(); }
std::string name_of_last() { return "rank " + std::to_string(last()) + ": "; }

/// The sentence of rank 0.
std::string told_by_first(std::string sentence) {
  sentence.resize(500);
  MPI_Bcast(sentence.data(), static_cast<int>(sentence.size()), MPI_CHAR, 0, MPI_COMM_WORLD);
  return sentence.c_str();
}

/// Collective: `ask` throws an `E` on every rank, with one sentence, which has `part` in it.
template <class E, class Ask>
void expect_on_all(const std::string& part, const Ask& ask) {
  std::string sentence = "nothing was thrown";
  try {
    ask();
  } catch (const E& error) {
    sentence = error.what();
  } catch (const std::exception& error) {
    sentence = std::string("another type: ") + error.what();
  }
  EXPECT_NE(sentence.find(part), std::string::npos) << sentence;
  EXPECT_EQ(sentence, told_by_first(sentence));
}

class Faults : public testing::Test {
 protected:
  const Scene scene_ = scenes::scene_by_name("folded-cloth", 400, 1);
  Part part_ = part_of(scene_, cuts()[0]);
  Options options_ = [] {
    Options options;
    options.threads = 1;
    return options;
  }();

  distributed::Detector detector() const { return {MPI_COMM_WORLD, part_.mesh, options_}; }

  /// After whatever went wrong.
  void expect_right_answer(distributed::Detector& many) {
    part_.move(scene_.start, scene_.end);
    (void)many.contacts(part_.step());
    const std::size_t count = many.gather_contacts(0).size();
    EXPECT_EQ(count, rank_of() == 0 ? contacts_of(Detector(scene_.mesh()), scene_.step()).size() : 0);
  }
};

TEST_F(Faults, OtherOptionsOnOneRank) {
  if (rank_count() == 1) GTEST_SKIP() << "one rank agrees with itself";
  if (is_last()) options_.min_separation = 0.5;
  expect_on_all<InvalidOptions>(name_of_last() + "here it is 'min_separation 0.5'", [&] { detector(); });
}

TEST_F(Faults, AnotherQuestionOnOneRank) {
  if (rank_count() == 1) GTEST_SKIP() << "one rank agrees with itself";
  auto many = detector();
  expect_on_all<InvalidOptions>(name_of_last() + "here it is 'earliest'", [&] {
    if (is_last())
      (void)many.earliest(part_.step());
    else
      (void)many.contacts(part_.step());
  });
  expect_right_answer(many);
}

TEST_F(Faults, OptionsThatNoDetectorTakes) {
  if (is_last()) options_.threads = -1;
  expect_on_all<InvalidOptions>(name_of_last() + "threads is -1", [&] { detector(); });
}

TEST_F(Faults, NoFeatureOnAnyRank) {
  part_.mesh = {};
  expect_on_all<InvalidMesh>("on any rank", [&] { detector(); });
}

TEST_F(Faults, AVertexThatNobodyGives) {
  if (is_last()) part_.mesh.faces.push_back({0, 1, 1'000'000});
  expect_on_all<InvalidMesh>(name_of_last() + "vertex 1000000 is used, but no rank gives its position",
                             [&] { detector(); });
}

TEST_F(Faults, AVertexNumberBelowZero) {
  if (is_last()) part_.mesh.faces.push_back({0, 1, -7});
  expect_on_all<InvalidMesh>("names vertex -7", [&] { detector(); });
}

TEST_F(Faults, AVertexGivenTwiceByOneRank) {
  if (is_last()) part_.mesh.vertices.push_back(part_.mesh.vertices.front());
  expect_on_all<InvalidMesh>("has two rows of positions", [&] { detector(); });
}

TEST_F(Faults, GroupsThatDifferBetweenRanks) {
  if (rank_count() == 1) GTEST_SKIP() << "one rank agrees with itself";
  options_.filter.group_count = rank_count();
  options_.filter.group_of_vertex.assign(part_.mesh.vertices.size(), rank_of());
  expect_on_all<InvalidOptions>("give it the same group everywhere", [&] { detector(); });
}

TEST_F(Faults, NotANumberOnOneRank) {
  auto many = detector();
  if (is_last()) part_.end.back()[1] = std::numeric_limits<double>::quiet_NaN();
  Index vertex = part_.mesh.vertices.back();
  MPI_Bcast(&vertex, 1, MPI_INT32_T, last(), MPI_COMM_WORLD);
  // One on a border is refused as different, by whoever sees that first.
  expect_on_all<InvalidStep>("vertex " + std::to_string(vertex) + " in the end of the step",
                             [&] { (void)many.contacts(part_.step()); });
  expect_right_answer(many);
}

TEST_F(Faults, APositionThatDiffersBetweenRanks) {
  if (rank_count() == 1) GTEST_SKIP() << "one rank agrees with itself";
  part_ = part_of(scene_, cuts()[1]);  // round robin: nearly all vertices are shared
  auto many = detector();
  if (is_last()) part_.start.front()[2] += 0.25;
  expect_on_all<InvalidStep>("give it the same position everywhere", [&] { (void)many.is_free(part_.step()); });
  expect_right_answer(many);
}

TEST_F(Faults, TooFewRowsOnOneRank) {
  auto many = detector();
  if (is_last()) part_.start.pop_back();
  expect_on_all<InvalidStep>(name_of_last() + "the start of the step has", [&] { (void)many.earliest(part_.step()); });
  expect_right_answer(many);
}

TEST_F(Faults, ASeparationThatIsNoDistance) {
  auto many = detector();
  expect_on_all<InvalidOptions>("give a finite distance >= 0",
                                [&] { (void)many.contacts(part_.step(), {.min_separation = -1}); });
  expect_right_answer(many);
}

TEST_F(Faults, WhatRanksCannotDo) {
  auto many = detector();
  expect_on_all<InvalidOptions>("ranks know report and ignore",
                                [&] { (void)many.contacts(part_.step(), {.at_start = AtStart::fail}); });
  expect_right_answer(many);
  Options options;
  options.filter.rings = 2;
  expect_on_all<InvalidOptions>("rings is 2",
                                [&] { distributed::Detector(MPI_COMM_WORLD, part_.mesh, std::move(options)); });
}

TEST_F(Faults, AFractionThatIsNone) {
  auto many = detector();
  expect_on_all<InvalidOptions>("fraction", [&] { (void)many.safe_step(part_.step(), 1); });
  expect_right_answer(many);
}

TEST_F(Faults, ARankThatIsNone) {
  auto many = detector();
  (void)many.contacts(part_.step());
  for (const int rank : {-1, rank_count()})
    expect_on_all<InvalidOptions>("there is no rank " + std::to_string(rank),
                                  [&] { (void)many.gather_contacts(rank); });
  expect_right_answer(many);
}

TEST_F(Faults, AnExceptionInACallbackOfOneRank) {
  bool throws = true;
  options_.filter.accepts = [&](PairKind, const auto&) {
    if (throws && is_last()) throw std::runtime_error("the filter is not ready");
    return true;
  };
  auto many = detector();
  expect_on_all<Error>(name_of_last() + "the filter is not ready", [&] { (void)many.contacts(part_.step()); });
  throws = false;
  expect_right_answer(many);
}

TEST_F(Faults, OneRankCancels) {
  bool cancels = true;
  options_.is_cancelled = [&] { return cancels && is_last(); };
  auto many = detector();
  expect_on_all<Cancelled>(name_of_last() + "the question was cancelled", [&] { (void)many.contacts(part_.step()); });
  cancels = false;
  expect_right_answer(many);
}

}  // namespace
}  // namespace tamis::test
