#include "distributed/tests/same_answers.hpp"

#include "support/contact_bits.hpp"
#include "support/copied.hpp"

namespace tamis::test {
namespace {

constexpr double kFractions[] = {0, 0.1, 0.9};

}  // namespace

void expect_same(std::span<const Contact> one, std::span<const Contact> many, const std::string& what) {
  ASSERT_EQ(one.size(), many.size()) << what;
  for (std::size_t i = 0; i < one.size(); ++i)
    ASSERT_EQ(bits_of(one[i]), bits_of(many[i])) << what << ", contact " << i;
}

void expect_same(const EarliestContact& one, const EarliestContact& many, const std::string& what) {
  EXPECT_EQ(one.toi_lower, many.toi_lower) << what;
  EXPECT_EQ(one.toi_upper, many.toi_upper) << what;
  ASSERT_EQ(one.contact.has_value(), many.contact.has_value()) << what;
  if (!one.contact) return;
  EXPECT_EQ(bits_of(*one.contact), bits_of(*many.contact)) << what;
}

void expect_same(const SafeStep& one, const SafeStep& many, const std::string& what) {
  EXPECT_EQ(one.toi_lower, many.toi_lower) << what;
  EXPECT_EQ(one.toi_upper, many.toi_upper) << what;
  ASSERT_EQ(one.pair.has_value(), many.pair.has_value()) << what;
  if (!one.pair) return;
  EXPECT_EQ(one.pair->kind, many.pair->kind) << what;
  EXPECT_EQ(one.pair->vertices, many.pair->vertices) << what;
  EXPECT_EQ(one.pair->distance, many.pair->distance) << what;
}

Options one_thread() {
  Options options;
  options.threads = 1;
  return options;
}

OneAnswers answers_of(Detector& one, const scenes::Scene& scene, double separation) {
  OneAnswers answers;
  answers.separation = separation;
  const Step step = scene.step();
  const QueryOptions ignore = answers.ignoring_start();
  answers.contacts = copied(one.contacts(step));
  answers.earliest = one.earliest(step);
  answers.is_free = one.is_free(step);
  for (const double fraction : kFractions) answers.safe.push_back(one.safe_step(step, fraction));
  answers.earliest_ignoring_start = one.earliest(step, ignore);
  answers.safe_ignoring_start = one.safe_step(step, 0.1, ignore);
  return answers;
}

void expect_same_answers(const OneAnswers& one, distributed::Detector& many, const Part& part,
                         const std::string& what) {
  (void)many.contacts(part.step());
  const auto gathered = many.gather_contacts(0);
  if (rank_of() == 0)
    expect_same(one.contacts, gathered, what);
  else
    EXPECT_TRUE(gathered.empty()) << what;
  expect_same(one.earliest, many.earliest(part.step()), what);
  EXPECT_EQ(one.is_free, many.is_free(part.step())) << what;
  for (std::size_t i = 0; i < std::size(kFractions); ++i)
    expect_same(one.safe[i], many.safe_step(part.step(), kFractions[i]), what);
  const QueryOptions ignore = one.ignoring_start();
  expect_same(one.earliest_ignoring_start, many.earliest(part.step(), ignore), what);
  expect_same(one.safe_ignoring_start, many.safe_step(part.step(), 0.1, ignore), what);
}

void expect_same_for_all_cuts(const scenes::Scene& scene, const Options& options) {
  Detector one(scene.mesh(), options);
  const OneAnswers expected = answers_of(one, scene);
  for (const Cut& cut : cuts()) {
    const Part part = part_of(scene, cut);
    Options local = options;
    if (!options.filter.group_of_vertex.empty()) local.filter.group_of_vertex = part.group_of_vertex;
    distributed::Detector many(MPI_COMM_WORLD, part.mesh, local);
    expect_same_answers(expected, many, part, cut.name);
  }
}

}  // namespace tamis::test
