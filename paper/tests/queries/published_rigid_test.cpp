// The published queries of turning bodies, with first times of contact found elsewhere with 50 digits.
#include <gtest/gtest.h>

#include <cstdlib>

#include "paper/queries/queries.hpp"
#include "support/temporary_folder.hpp"
#include "support/test_data.hpp"
#include "tamis/rigid_path.hpp"

namespace tamis::test {
namespace {

TEST(RigidQueries, NoneIsMissedNoneIsFalseAndBracketsHoldTheTime) {
  if (data_folder().empty() || !std::filesystem::is_directory(data_folder() / "rigid")) GTEST_SKIP() << kNoData;
  const std::filesystem::path folder = data_folder() / "rigid";
  const std::string table = bytes_of_file(folder / "truth.csv");
  int count = 0;
  for (const lab::QueryFile& file : lab::query_files({folder.string()})) {
    SCOPED_TRACE(file.name);
    const auto query = std::get<lab::RigidQuery>(lab::read_queries(file).at(0));
    constexpr std::array<Index, 4> kAll{0, 1, 2, 3};
    const PairResult result =
        query.kind == PairKind::vertex_face ? vertex_face(query.path(), kAll) : edge_edge(query.path(), kAll);
    ++count;
    // file,kind,touches,toi,...
    const std::string row = file.name + (query.kind == PairKind::vertex_face ? ",vf," : ",ee,");
    const std::size_t place = table.find("\n" + row);
    ASSERT_NE(place, std::string::npos);
    const char* touches = table.c_str() + place + 1 + row.size();
    EXPECT_EQ(query.touches, *touches == '1');
    ASSERT_EQ(result.touches, *touches == '1');
    if (!result.touches) continue;
    const double time = std::strtod(touches + 2, nullptr);
    EXPECT_EQ(result.certainty, Certainty::certified);
    EXPECT_LE(result.toi_upper - result.toi_lower, 1e-9);
    EXPECT_GT(result.toi_lower, 0);
    EXPECT_LE(result.toi_lower, time + 1e-17);
    EXPECT_GE(result.toi_upper, time - 1e-17);
  }
  EXPECT_EQ(count, 17);
}

}  // namespace
}  // namespace tamis::test
