#include <gtest/gtest.h>

#include <algorithm>
#include <ctime>
#include <limits>

#include "files/tests/messages.hpp"
#include "paper/queries/queries.hpp"
#include "paper/queries/query_results_csv.hpp"
#include "support/temporary_folder.hpp"

namespace tamis::lab {
namespace {

const char* const kPoses =
    R"("pose_t0":{"position":[1,2,3],"rotation":[0,0,4]},"pose_t1":{"position":[5,6,7],"rotation":[0,8,0]})";

/// A query of two edges; `second` stands in the second one.
std::string edges(const std::string& second = R"("vertex0":[7,8,9],"vertex1":[-7,8,9])") {
  return std::string(R"({"type":"ee","edge0":{)") + kPoses + R"(,"vertex0":[0,0,1],"vertex1":[0,0,2]},"edge1":{)" +
         kPoses + "," + second + "}}";
}

std::string rigid_error_of(const std::string& text) {
  return test::file_error("q.json", [&] { parse_rigid_query(text, "q.json"); });
}

// Bug: the two bodies, or the two poses of one, exchanged.
TEST(RigidQueries, PosesAndPointsAreTaken) {
  const RigidQuery query = parse_rigid_query(edges(), "q.json");
  EXPECT_EQ(query.kind, PairKind::edge_edge);
  EXPECT_EQ(query.points[1], (Point{0, 0, 2}));
  EXPECT_EQ(query.points[2], (Point{7, 8, 9}));
  EXPECT_EQ(query.bodies[1].start.position, (Point{1, 2, 3}));
  EXPECT_EQ(query.bodies[0].end.rotation, (Point{0, 8, 0}));
  EXPECT_EQ(query.path().vertex_count(), 4);
  const std::string face = std::string(R"({"type":"fv","face":{)") + kPoses +
                           R"(,"vertex0":[1,0,0],"vertex1":[2,0,0],"vertex2":[3,0,0]},"vertex":{)" + kPoses +
                           R"(,"vertex":[4,0,0]}})";
  const RigidQuery other = parse_rigid_query(face, "q.json");
  EXPECT_EQ(other.kind, PairKind::vertex_face);
  EXPECT_EQ(other.points[0][0], 4);
  EXPECT_EQ(other.points[3][0], 3);
}

// Bug: half a file answers as if a corner were at the origin.
TEST(RigidQueries, ErrorsNameThePlace) {
  EXPECT_TRUE(test::contains(rigid_error_of("{"), "not JSON"));
  EXPECT_TRUE(test::contains(rigid_error_of("[]"), "type: is missing"));
  EXPECT_TRUE(test::contains(rigid_error_of(R"({"type":"vv"})"), "neither fv nor ee"));
  EXPECT_TRUE(test::contains(rigid_error_of(R"({"type":"ee"})"), "edge0: is missing"));
  EXPECT_TRUE(test::contains(rigid_error_of(edges(R"("vertex0":[7,8,9])")), "edge1.vertex1: is missing"));
  EXPECT_TRUE(test::contains(rigid_error_of(edges(R"("vertex0":[7,8])")), "edge1.vertex0: is not an array of three"));
  EXPECT_TRUE(test::contains(rigid_error_of(edges(R"("vertex0":[7,"8",9])")), "edge1.vertex0: holds something"));
  EXPECT_TRUE(test::contains(rigid_error_of(edges(R"("vertex0":[7,1e999,9])")), "q.json"));
}

/// A query of two edges with so many keys that nothing asks for.
std::string edges_among_keys(int count) {
  std::string keys;
  for (int i = 0; i < count; ++i) keys += "\"key" + std::to_string(i) + "\":{},";
  return "{" + keys + edges().substr(1);
}

/// Seconds of processor time, the least of three runs.
double parsing_time(const std::string& text) {
  double least = std::numeric_limits<double>::infinity();
  for (int run = 0; run < 3; ++run) {
    const std::clock_t begin = std::clock();
    parse_rigid_query(text, "q.json");
    least = std::min(least, static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
  }
  return least;
}

// Bug: every key is looked for among all before it: eight times as many took sixty-four times as long, 12 s.
TEST(RigidQueries, TimeGrowsWithTheNumberOfKeys) {
  const double few = parsing_time(edges_among_keys(12'500)), many = parsing_time(edges_among_keys(100'000));
  EXPECT_LT(many, 24 * std::max(few, 1e-3));
}

// Bug: a file that is no query takes all memory, or the stack.
TEST(RigidQueries, WhatNoQueryNeedsIsRefused) {
  EXPECT_TRUE(test::contains(rigid_error_of(std::string(5'000'000, ' ')), "a query takes no more than 4194304"));
  EXPECT_TRUE(test::contains(rigid_error_of(std::string(1'000'000, '[')), "nests deeper than 64 levels"));
  const std::string quoted = R"("name":"[{\"[[{", )" + std::string(100, ' ');
  EXPECT_EQ(parse_rigid_query("{" + quoted + edges().substr(1), "q.json").kind, PairKind::edge_edge);
}

// Bug: the answer of another file of that name; a table that is not a table of answers taken for one.
TEST(RigidQueries, AnswersAreFoundInTheTableAbove) {
  const test::TemporaryFolder folder;
  folder.write("all/truth.csv", "file,kind,touches,toi\nq.json,ee,0,\ninner/q.json,ee,1,0.5\n");
  folder.write("all/q.json", edges());
  folder.write("all/inner/q.json", edges());
  folder.write("all/inner/other.json", edges());
  const auto files = query_files({(folder.path() / "all").string()});
  ASSERT_EQ(files.size(), 3u);
  std::vector<std::optional<bool>> answers;
  std::vector<std::string> names;
  for (const QueryFile& file : files) {
    answers.push_back(std::get<RigidQuery>(read_queries(file).at(0)).touches);
    names.push_back(file.name);
  }
  EXPECT_EQ(names, (std::vector<std::string>{"inner/other.json", "inner/q.json", "q.json"}));
  EXPECT_EQ(answers, (std::vector<std::optional<bool>>{std::nullopt, true, false}));
  folder.write("all/truth.csv", "file,kind,touches\nq.json,ee,2\n");
  EXPECT_TRUE(test::contains(
      test::file_error((folder.path() / "all/truth.csv").string(), [&] { read_queries(files[2]); }), "line 2"));
}

TEST(QueryResults, AreATable) {
  const test::TemporaryFolder folder;
  PairResult touching;
  touching.touches = true;
  touching.toi_lower = 0.1;
  touching.toi_upper = 0.2;
  const auto path = folder.path() / "out.csv";
  write_query_results_csv(path,
                          {{"a.json", PairKind::vertex_face, touching}, {"b,\"c\".csv", PairKind::edge_edge, {}}});
  EXPECT_EQ(test::bytes_of_file(path),
            "file,kind,touches,toi_lower,toi_upper\na.json,vf,1,0.1,0.2\n\"b,\"\"c\"\".csv\",ee,0,,\n");
}

}  // namespace
}  // namespace tamis::lab
