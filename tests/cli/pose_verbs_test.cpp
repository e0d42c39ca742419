// The verbs of one pose: tamis near and tamis intersections.
#include <gtest/gtest.h>

#include "cli/command.hpp"

namespace tamis::test {
namespace {

class PoseVerbs : public testing::Test {
 protected:
  PoseVerbs() {
    folder_.write_fall();
    folder_.write("pierced.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0.25 0.25 -1\nv 0.25 0.25 1\nf 1 2 3\nl 4 5\n");
  }
  CommandFolder folder_;
};

// Bugs: columns in another order, or a distance that is not that of the pair.
TEST_F(PoseVerbs, NearListsPairsWithTheirDistance) {
  EXPECT_EQ(folder_.run("near above.obj --distance 0.5 --json").json()["near"]["vf"], 0);
  const Outcome outcome = folder_.run("near above.obj --distance 1 --out near.csv --json");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.json()["near"]["vf"], 1);
  EXPECT_EQ(outcome.json()["smallest_distance"], 1);
  const std::string table = bytes_of_file(folder_.path() / "near.csv");
  EXPECT_EQ(table.rfind("kind,v0,v1,v2,v3,distance,u,v\nvf,3,0,1,2,1,0.2", 0), 0u) << table;
  EXPECT_NE(folder_.run("near above.obj --distance 1").out.find("1 vertex-face"), std::string::npos);
}

// Bug: a radius that is taken for another object, or counted once.
TEST_F(PoseVerbs, ThicknessOfObjectsAddsToTheDistance) {
  const auto near = [&](const std::string& options) { return folder_.run("near above.obj --json " + options).json(); };
  EXPECT_EQ(near("--distance 0.5 --thickness 0.25")["near"]["vf"], 1);
  EXPECT_EQ(near("--distance 0.5 --thickness 0.2")["near"]["vf"], 0);
  EXPECT_EQ(near("--distance 0 --thickness 0.75,0.25")["near"]["vf"], 1);
  EXPECT_EQ(near("--distance 0 --thickness 0,1")["near"]["vf"], 1);
  EXPECT_EQ(near("--distance 0 --thickness 0.5,0.25")["near"]["vf"], 0);
  EXPECT_EQ(near("--distance 0 --thickness 0.5,0.25")["thickness"], (std::vector<double>{0.5, 0.25}));
}

// Bug: an exit code that scripts cannot go by.
TEST_F(PoseVerbs, IntersectionsAnswerByTheirExitCode) {
  EXPECT_EQ(folder_.run("intersections above.obj").code, 0);
  const Outcome outcome = folder_.run("intersections pierced.obj --out found.csv --json");
  EXPECT_EQ(outcome.code, 1) << outcome.err;
  EXPECT_EQ(outcome.json()["intersections"], 1);
  EXPECT_EQ(bytes_of_file(folder_.path() / "found.csv"), "e0,e1,f0,f1,f2\n3,4,0,1,2\n");
  EXPECT_NE(folder_.run("intersections pierced.obj").out.find("edge 3 4 and face 0 1 2"), std::string::npos);
}

// Bug: what cannot be asked is answered.
TEST_F(PoseVerbs, RefuseWhatTheyCannotAnswer) {
  for (const char* arguments :
       {"near above.obj", "near above.obj --distance -1", "near above.obj --distance nan",
        "near nowhere.obj --distance 1", "near above.obj --distance 1 --out above.obj",
        "near above.obj --distance 1 --thickness 1,2,3", "near above.obj --distance 1 --thickness 1,",
        "near above.obj --distance 1 --thickness -1", "intersections nowhere.obj",
        "intersections above.obj --out above.obj"})
    EXPECT_EQ(folder_.run(arguments).code, 2) << arguments;
}

}  // namespace
}  // namespace tamis::test
