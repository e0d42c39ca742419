// The published queries: every variant of the paper's method, and the reader of the laboratory.
#include <gtest/gtest.h>

#include "files/file_bytes.hpp"
#include "paper/detector.hpp"
#include "paper/queries/queries.hpp"
#include "support/test_data.hpp"

namespace tamis::lab {
namespace {

/// The pair as a mesh of its own, through all stages of a method.
std::size_t contacts_of(const test::Query& q, std::string_view method) {
  Options options;
  choose_method(options, method);
  options.threads = 1;
  options.filter.accepts = [&](PairKind kind, const std::array<Index, 4>& v) {
    return kind == q.kind && v == std::array<Index, 4>{0, 1, 2, 3};
  };
  const bool is_vf = q.kind == PairKind::vertex_face;
  Mesh mesh = is_vf ? Mesh(4, {{1, 2, 3}}, {}, {0}) : Mesh(4, {}, {{0, 1}, {2, 3}});
  const Positions start(q.motion.start), end(q.motion.end);
  Detector detector = make_detector(std::move(mesh), options);
  return detector.contacts({start, end}).size();
}

class PublishedQueries : public testing::Test {
 protected:
  void SetUp() override {
    if (test::data_folder().empty()) GTEST_SKIP() << test::kNoData;
  }
  const std::filesystem::path folder_ = test::data_folder() / "queries";
};

// A stage that proves more than the decision all methods share, or less, shows here.
TEST_F(PublishedQueries, EveryMethodGivesTheAnswer) {
  for (const test::Query& q : test::read_queries(folder_))
    for (const std::string_view method : method_choices())
      ASSERT_EQ(contacts_of(q, method), q.touches ? 1u : 0u) << method << ": " << q.origin;
}

TEST_F(PublishedQueries, AreReadAndHaveTheirAnswers) {
  std::size_t queries = 0;
  for (const QueryFile& file : query_files({folder_.string()}))
    for (const Query& query : parse_queries(io::FileBytes(file.path).view(), file.kind.value(), file.path.string())) {
      EXPECT_TRUE(query.touches.has_value());
      ++queries;
    }
  EXPECT_EQ(queries, 4779u);
}

}  // namespace
}  // namespace tamis::lab
