#include "paper/queries/queries.hpp"

#include <gtest/gtest.h>

#include "files/tests/messages.hpp"
#include "support/temporary_folder.hpp"

namespace tamis::lab {
namespace {

/// Rows whose x counts 0, 1, 2, ... in halves.
std::string rows(int count, const std::string& answer) {
  std::string text;
  for (int i = 0; i < count; ++i) text += std::to_string(i) + ",2,-1,4,3,1" + answer + "\n";
  return text;
}

std::string error_of_queries(const std::string& text) {
  return test::file_error("q.csv", [&] { parse_queries(text, PairKind::edge_edge, "q.csv"); });
}

// Bug: t=0 and t=1 are exchanged, or axes are.
TEST(Queries, EightRowsMakeOneQuery) {
  const auto queries = parse_queries(rows(16, ",1"), PairKind::vertex_face, "q.csv");
  ASSERT_EQ(queries.size(), 2u);
  EXPECT_EQ(queries[1].kind, PairKind::vertex_face);
  EXPECT_EQ(queries[1].start[0], (Point{4, -0.25, 3}));
  EXPECT_EQ(queries[1].end[3], (Point{7.5, -0.25, 3}));
  EXPECT_EQ(queries[0].touches, std::optional<bool>(true));
}

TEST(Queries, TheAnswerMayBeMissing) {
  const auto queries = parse_queries(rows(8, ""), PairKind::edge_edge, "q.csv");
  ASSERT_EQ(queries.size(), 1u);
  EXPECT_EQ(queries[0].touches, std::nullopt);
}

// Bug: a rounded coordinate, a cut file or a mixed answer goes into the statistics.
TEST(Queries, EachErrorNamesItsLine) {
  EXPECT_TRUE(test::contains(error_of_queries(rows(12, ",1")), "4 of its 8 rows"));
  EXPECT_TRUE(test::contains(error_of_queries(rows(7, ",1") + "1,2,1,2,1,2,0\n"), "line 8: the answer differs"));
  EXPECT_TRUE(test::contains(error_of_queries(rows(7, ",1") + "1,2,1,2,1,2\n"), "line 8: the answer differs"));
  EXPECT_TRUE(test::contains(error_of_queries("1,3,0,1,0,1,1\n"), "line 1: '1' / '3' is not exactly a double"));
  EXPECT_TRUE(test::contains(error_of_queries("1,0,0,1,0,1,1\n"), "not exactly a double"));
  EXPECT_TRUE(test::contains(error_of_queries("1,1,0,1,0,1,2\n"), "the answer is '2'"));
  EXPECT_TRUE(test::contains(error_of_queries("1,1,0,1,0\n"), "5 columns"));
  EXPECT_TRUE(test::contains(error_of_queries("1,1,0,1,0,1,1,1\n"), "8 columns"));
}

// Bug: the kind is guessed from a folder further up, or other tables are taken for queries.
TEST(QueryFiles, TheNearestFolderTellsTheKind) {
  const test::TemporaryFolder folder;
  folder.write("edge-edge/scene/vertex-face/data_10.csv", "");
  folder.write("edge-edge/scene/vertex-face/data_9.csv", "");
  folder.write("truth.csv", "");
  folder.write("edge-edge/readme.md", "");
  const auto files = query_files({folder.path().string()});
  ASSERT_EQ(files.size(), 2u);
  EXPECT_EQ(files[0].path.filename(), "data_9.csv");
  EXPECT_EQ(files[0].kind, PairKind::vertex_face);
  EXPECT_EQ(files[0].folder, "scene");
  test::file_error((folder.path() / "truth.csv").string(),
                   [&] { query_files({(folder.path() / "truth.csv").string()}); });
}

}  // namespace
}  // namespace tamis::lab
