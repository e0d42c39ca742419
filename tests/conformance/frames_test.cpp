// Recorded steps of simulations with their complete, exact sets of contacts: the methods, and the oracle itself.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <span>
#include <sstream>

#include "files/mesh/mesh_file.hpp"
#include "support/contact_sets.hpp"
#include "support/copied.hpp"
#include "support/test_data.hpp"
#include "support/test_names.hpp"
#include "support/yardstick/methods.hpp"
#include "tamis/detector.hpp"

namespace tamis::test {
namespace {

namespace fs = std::filesystem;

struct Row {
  PairName name;
  bool touches;
};

/// One order of vertices for a pair, however a table names it: a face's vertices ascending, edges as in Contact.
PairName in_one_order(PairName name) {
  auto& v = name.vertices;
  if (name.kind == PairKind::vertex_face) {
    std::sort(v.begin() + 1, v.end());
  } else {
    std::sort(v.begin(), v.begin() + 2);
    std::sort(v.begin() + 2, v.end());
    if (std::array{v[2], v[3]} < std::array{v[0], v[1]}) std::swap(v[0], v[2]), std::swap(v[1], v[3]);
  }
  return name;
}

/// Columns kind,v0,v1,v2,v3,collides.
std::vector<Row> read_truth(const fs::path& file) {
  std::ifstream in(file);
  std::vector<Row> rows;
  std::string line;
  std::getline(in, line);
  while (std::getline(in, line)) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream columns(line);
    std::string kind;
    Row row{};
    columns >> kind;
    for (Index& v : row.name.vertices) columns >> v;
    columns >> row.touches;
    row.name.kind = kind == "vf" ? PairKind::vertex_face : PairKind::edge_edge;
    rows.push_back(row);
  }
  return rows;
}

struct Frames {
  const char* folder;
  const char* start;
  const char* end;
  std::size_t contacts;
};

class RecordedStep : public testing::TestWithParam<Frames> {
 protected:
  void SetUp() override {
    if (data_folder().empty()) GTEST_SKIP() << kNoData;
    const fs::path folder = data_folder() / "frames" / GetParam().folder;
    start = io::read_mesh(folder / GetParam().start);
    end = io::read_mesh(folder / GetParam().end);
    rows = read_truth(folder / "truth.csv");
    for (const Row& row : rows)
      if (row.touches) truth.insert(in_one_order(row.name));
    ASSERT_EQ(truth.size(), GetParam().contacts);
  }

  std::vector<Contact> find(Method method) const {
    yardstick::Options options;
    options.method = method;
    return contacts_of(yardstick::make_detector(io::mesh_of(start), options), {start.positions, end.positions});
  }

  static PairSet names(std::span<const Contact> contacts) {
    PairSet result;
    for (const Contact& c : contacts) result.insert(in_one_order({c.kind, c.vertices}));
    return result;
  }

  oracle::Motion motion(const std::array<Index, 4>& vertices) const {
    oracle::Motion m;
    for (std::size_t i = 0; i < 4; ++i) {
      m.start[i] = start.positions[static_cast<std::size_t>(vertices[i])];
      m.end[i] = end.positions[static_cast<std::size_t>(vertices[i])];
    }
    return m;
  }

  io::MeshFile start, end;
  std::vector<Row> rows;
  PairSet truth;
};

TEST_P(RecordedStep, GivesTheTruth) {
  const auto contacts = find(Method::tamis);
  const PairSet found = names(contacts);
  EXPECT_EQ(missing(truth, found), "") << "missed";
  EXPECT_EQ(missing(found, truth), "") << "made up";
  EXPECT_EQ(found.size(), contacts.size()) << "a pair is reported twice";
  for (const Contact& c : contacts) {
    EXPECT_EQ(c.certainty, Certainty::certified);
    EXPECT_LE(c.toi_upper - c.toi_lower, 1e-11);
  }
}

// Every fortieth contact of a large step: the bracket is what it says.
TEST_P(RecordedStep, BracketsHoldTheFirstContact) {
  const auto contacts = find(Method::tamis);
  const std::size_t stride = contacts.size() > 1000 ? 40 : 1;
  for (std::size_t i = 0; i < contacts.size(); i += stride) {
    const Contact& c = contacts[i];
    const auto m = motion(c.vertices);
    EXPECT_FALSE(c.toi_lower > 0 && oracle::touches(c.kind, m, {0, c.toi_lower, true})) << "contact " << i;
    EXPECT_TRUE(oracle::touches(c.kind, m, {c.toi_lower, c.toi_upper})) << "contact " << i;
  }
}

TEST_P(RecordedStep, OracleAgreesWithThePublishedAnswers) {
  const std::size_t stride = rows.size() > 1000 ? 40 : 1;
  for (std::size_t i = 0; i < rows.size(); i += stride)
    EXPECT_EQ(oracle::touches(rows[i].name.kind, motion(rows[i].name.vertices)), rows[i].touches) << "row " << i + 2;
}

INSTANTIATE_TEST_SUITE_P(Frames, RecordedStep,
                         testing::Values(Frames{"cloth-funnel", "227.ply", "228.ply", 27 + 107},
                                         Frames{"cloth-ball", "cloth_ball92.ply", "cloth_ball93.ply", 19032 + 94822}),
                         [](const testing::TestParamInfo<Frames>& step) { return test_name(step.param.folder); });

}  // namespace
}  // namespace tamis::test
