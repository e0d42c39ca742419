// tamis audit.
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <limits>

#include "command/tests/command.hpp"

namespace tamis::test {
namespace {

constexpr const char* kTriangles = "f 1 2 3\nf 4 5 6\n";

/// Two triangles; the second one's corner is at this height over the first.
std::string frame_at(double z) {
  return "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0.25 0.25 " + std::to_string(z) + "\nv 1 0.5 2\nv 0.5 1 2\n";
}

std::string word(std::uint32_t value, bool is_big_endian) {
  std::string bytes;
  for (int i = 0; i < 4; ++i) bytes += static_cast<char>(value >> (8 * (is_big_endian ? 3 - i : i)));
  return bytes;
}

/// The positions of frames as a cache has them.
std::string floats_at(const std::vector<float>& heights, bool is_big_endian) {
  std::string bytes;
  for (const float z : heights)
    for (const float x : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, .25f, .25f, z, 1.f, .5f, 2.f, .5f, 1.f, 2.f})
      bytes += word(std::bit_cast<std::uint32_t>(x), is_big_endian);
  return bytes;
}

std::string pc2(const std::vector<float>& heights, std::uint32_t vertices = 6) {
  return std::string("POINTCACHE2\0", 12) + word(1, false) + word(vertices, false) + word(0, false) +
         word(std::bit_cast<std::uint32_t>(1.f), false) + word(static_cast<std::uint32_t>(heights.size()), false) +
         floats_at(heights, false);
}

std::string mdd(const std::vector<float>& heights) {
  std::string bytes = word(static_cast<std::uint32_t>(heights.size()), true) + word(6, true);
  for (std::size_t i = 0; i < heights.size(); ++i)
    bytes += word(std::bit_cast<std::uint32_t>(static_cast<float>(i) / 25), true);
  return bytes + floats_at(heights, true);
}

class AuditVerb : public CommandTest {
 protected:
  AuditVerb() {
    const double heights[] = {1, 0.5, -1, 0.75, 1};
    for (int i = 0; i < 5; ++i) folder_.write("f/" + std::to_string(i) + ".obj", frame_at(heights[i]) + kTriangles);
  }

  /// Says that a frame could not be asked, and what the others have.
  void expect_problem(const std::string& arguments, const std::string& says) const {
    const Outcome outcome = folder_.run(arguments);
    EXPECT_EQ(outcome.code, 2) << arguments;
    EXPECT_NE(outcome.err.find(says), std::string::npos) << arguments << "\n" << outcome.err << "should say: " << says;
  }
};

TEST_F(AuditVerb, SaysWhichFramesAreBadAndWhere) {
  const Outcome outcome = folder_.run("audit f --json");
  EXPECT_EQ(outcome.code, 1) << outcome.err;
  const auto json = outcome.json();
  EXPECT_FALSE(json["free"].get<bool>());
  EXPECT_EQ(json["frames"], 5);
  EXPECT_EQ(json["steps"], 4);
  EXPECT_EQ(json["first_bad"]["frame"], 2);
  EXPECT_EQ(json["first_bad"]["name"], "2.obj");
  EXPECT_EQ(json["bad_frames"].size(), 2u);
  EXPECT_EQ(json["intersections"], 2);
  EXPECT_EQ(json["contacts"]["vf"], 2);
  EXPECT_EQ(json["rings"]["unconnected"], 4);
  EXPECT_EQ(json["pairs"][2]["vertices"], (std::vector<int>{3, 0, 1, 2}));
  EXPECT_EQ(json["pairs"][2]["kind"], "vf");
  EXPECT_EQ(json["pairs"][2]["rings"], nullptr);
  EXPECT_NEAR(json["pairs"][2]["toi_upper"].get<double>(), 1.0 / 3, 1e-12);
  const Outcome text = folder_.run("audit f");
  EXPECT_EQ(text.code, 1);
  EXPECT_NE(text.out.find("first bad       frame 2, 2.obj"), std::string::npos) << text.out;
}

TEST_F(AuditVerb, FreeMeansExitCodeZero) {
  EXPECT_EQ(folder_.run("audit f/0.obj f/1.obj").code, 0);
  EXPECT_EQ(folder_.run("audit f/0.obj").code, 0);
  EXPECT_EQ(folder_.run("audit f/2.obj").code, 1);
  EXPECT_EQ(folder_.run("audit f/2.obj f/2.obj --no-intersections").code, 0);
  EXPECT_EQ(folder_.run("audit f/0.obj f/3.obj --no-intersections --min-separation 0.8").code, 1);
}

TEST_F(AuditVerb, WritesTablesAndAPage) {
  EXPECT_EQ(folder_.run("audit f --out pairs.csv --out-frames frames.csv").code, 1);
  const std::string pairs = bytes_of_file(folder_.path() / "pairs.csv");
  EXPECT_TRUE(
      pairs.starts_with("frame,kind,v0,v1,v2,v3,v4,toi_lower,toi_upper,object_a,object_b,rings,new\n2,ef,3,4,0,1,2,1"))
      << pairs;
  const std::string frames = bytes_of_file(folder_.path() / "frames.csv");
  EXPECT_NE(frames.find("\n2,\"2.obj\",1,1,1,0,0,0,2,0,"), std::string::npos) << frames;
  EXPECT_EQ(folder_.run("audit f --out page.html").code, 1);
  EXPECT_TRUE(bytes_of_file(folder_.path() / "page.html").starts_with("<!doctype html>"));
  expect_refused("audit f --out page.png", "page.png");
  expect_refused("audit f --out f/0.obj", "nothing is written as .obj");
  expect_refused("audit f --out-frames x.html", "x.html");
}

// Bug: the exit code of a recording whose first frame has intersections says nothing of an accident later on.
TEST_F(AuditVerb, PairsThatTheFrameBeforeDoesNotHaveAreNew) {
  const auto json = folder_.run("audit f --json").json();
  EXPECT_EQ(json["first_new"]["frame"], 2);
  EXPECT_EQ(json["new"], 3);  // the vertex leaves through the face by which it came
  EXPECT_TRUE(json["pairs"][0]["new"].get<bool>());
  EXPECT_FALSE(json["pairs"][3]["new"].get<bool>());
  EXPECT_EQ(folder_.run("audit f --new").code, 1);
  const Outcome permanent = folder_.run("audit f/2.obj f/2.obj --new --json");
  EXPECT_EQ(permanent.code, 0);
  EXPECT_FALSE(permanent.json()["free"].get<bool>());
  EXPECT_EQ(permanent.json()["first_new"], nullptr);
  EXPECT_NE(folder_.run("audit f").out.find("new             3 in 1 frame"), std::string::npos);
}

// Bug: pairs beyond the limit are lost without a word.
TEST_F(AuditVerb, PairsThatAreNotListedAreCounted) {
  const auto json = folder_.run("audit f --pairs 1 --json").json();
  EXPECT_EQ(json["pairs"].size(), 1u);
  EXPECT_EQ(json["pairs_left_out"], 3);
  EXPECT_EQ(json["rings"]["unconnected"], 4);
  EXPECT_NE(folder_.run("audit f --pairs 1").out.find("not listed      3"), std::string::npos);
}

// Bug: floats are read in the wrong order of bytes, or from the wrong place.
TEST_F(AuditVerb, ReadsPointCaches) {
  const std::vector<float> heights{1, 0.5f, -1, 0.75f, 1};
  folder_.write("cloth.obj", frame_at(1) + kTriangles);
  folder_.write("cloth.pc2", pc2(heights));
  folder_.write("cloth.mdd", mdd(heights));
  const auto pairs = folder_.run("audit f --json").json()["pairs"];
  for (const std::string cache : {"cloth.pc2", "cloth.mdd"}) {
    const Outcome outcome = folder_.run("audit cloth.obj " + cache + " --json");
    EXPECT_EQ(outcome.code, 1) << outcome.err;
    EXPECT_EQ(outcome.json()["pairs"], pairs) << cache;
  }
  EXPECT_EQ(folder_.run("audit cloth.obj cloth.mdd --json").json()["first_bad"]["name"], "0.08 s");
}

TEST_F(AuditVerb, ABadCacheIsSaid) {
  folder_.write("cloth.obj", frame_at(1) + kTriangles);
  const std::string good = pc2({1, 0.9f, 0.8f});
  folder_.write("cut.pc2", good.substr(0, good.size() - 5));
  folder_.write("long.pc2", good + std::string(72, '\0'));
  folder_.write("long.mdd", mdd({1, 0.9f}) + "x");
  folder_.write("head.pc2", good.substr(0, 20));
  folder_.write("other.pc2", pc2({1}, 7));
  folder_.write("none.pc2", pc2({}));
  folder_.write("text.pc2", std::string(100, 'x'));
  folder_.write("text.mdd", std::string(100, 'x'));
  expect_problem("audit cloth.obj cut.pc2", "frame 2, 2: the file ends here: it was cut short, and 1 of its 3 frames");
  expect_problem("audit cloth.obj long.pc2",
                 "frame 3, rest: the file continues after the 3 frames that its header names");
  expect_problem("audit cloth.obj long.mdd", "frame 2, rest: the file continues after the 2 frames");
  expect_refused("audit cloth.obj head.pc2", "ends in its header");
  expect_refused("audit cloth.obj other.pc2", "it has 7 vertices a frame, the mesh 6");
  expect_refused("audit cloth.obj none.pc2", "names 0 frames");
  expect_refused("audit cloth.obj text.pc2", "begins with POINTCACHE2");
  expect_refused("audit cloth.obj text.mdd", "frames");
  expect_refused("audit cut.pc2", "together with one mesh file");
  expect_refused("audit cloth.obj f/0.obj cut.pc2", "together with one mesh file");
}

// Bug: a cache that was cut short is not mentioned, as a contact was found in what is left of it.
TEST_F(AuditVerb, WhatCouldNotBeAskedIsSaidBesideWhatWasFound) {
  folder_.write("cloth.obj", frame_at(1) + kTriangles);
  std::string cut = pc2({1, -1, 1});
  cut.pop_back();
  folder_.write("cut.pc2", cut);
  const Outcome outcome = folder_.run("audit cloth.obj cut.pc2");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.err.find("note: 2: the file ends here: it was cut short"), std::string::npos) << outcome.err;
}

// Bug: a page without a frame is refused in words that do not say why.
TEST_F(AuditVerb, APageOfNothingSaysWhatIsWrongWithTheFrames) {
  folder_.write("cloth.obj", frame_at(1) + kTriangles);
  folder_.write("nan.pc2", pc2({std::numeric_limits<float>::quiet_NaN()}));
  expect_refused("audit cloth.obj nan.pc2 --out page.html", "has this problem: vertex 3 is not finite");
}

// Bug: an unreadable frame ends it all; a step is asked across frames that are not there.
TEST_F(AuditVerb, FramesThatAreBrokenMissingOrOfAnotherMeshAreSaid) {
  for (int i = 0; i < 9; ++i) folder_.write("g/x0" + std::to_string(i) + ".obj", frame_at(1 + 0.01 * i) + kTriangles);
  EXPECT_EQ(folder_.run("audit g").code, 0);
  folder_.write("g/x02.obj", "v 0 0 zero\n");
  const Outcome broken = folder_.run("audit g --json");
  EXPECT_EQ(broken.code, 2);
  EXPECT_NE(broken.err.find("frame 2, x02.obj: "), std::string::npos) << broken.err;
  EXPECT_EQ(broken.json()["steps"], 6);
  EXPECT_EQ(broken.json()["problems"][0]["frame"], 2);
  std::filesystem::remove(folder_.path() / "g/x02.obj");
  std::filesystem::remove(folder_.path() / "g/x05.obj");
  std::filesystem::remove(folder_.path() / "g/x06.obj");
  const Outcome missing = folder_.run("audit g --json");
  EXPECT_EQ(missing.code, 0);
  EXPECT_EQ(missing.json()["steps"], 3);
  EXPECT_NE(missing.err.find("note: x03.obj: frame 2 is missing"), std::string::npos) << missing.err;
  EXPECT_NE(missing.err.find("note: x07.obj: frames 5 to 6 are missing"), std::string::npos) << missing.err;
  folder_.write("g/x08.obj", frame_at(1) + "f 1 2 3\n");
  const Outcome changed = folder_.run("audit g --json");
  EXPECT_EQ(changed.code, 0);
  EXPECT_EQ(changed.json()["steps"], 2);
  EXPECT_NE(changed.err.find("note: x08.obj: the topology changes here"), std::string::npos) << changed.err;
}

// Bug: every tenth frame is taken for a motion with holes.
TEST_F(AuditVerb, EveryTenthFrameIsNoGap) {
  for (int i = 0; i < 50; i += 10)
    folder_.write("t/x" + std::to_string(i) + ".obj", frame_at(1 + 0.01 * i) + kTriangles);
  const Outcome outcome = folder_.run("audit t --json");
  EXPECT_EQ(outcome.json()["steps"], 4) << outcome.err;
  EXPECT_EQ(outcome.err, "");
}

// Bug: twice the stride is more than a number holds, and the one step there is is left out.
TEST_F(AuditVerb, TwoFramesFarApartAreNoGap) {
  for (const char* name : {"u/x1.obj", "u/x9000000000000000000.obj"}) folder_.write(name, frame_at(1) + kTriangles);
  const Outcome outcome = folder_.run("audit u --json");
  EXPECT_EQ(outcome.json()["steps"], 1) << outcome.err;
}

TEST_F(AuditVerb, MisuseIsRefused) {
  expect_refused("audit f --no-contacts --no-intersections", "neither intersections nor contacts");
  expect_refused("audit f --no-contacts --min-separation 0.1", "the minimum separation is of contacts");
  expect_refused("audit f --out rows.csv --out-frames ./rows.csv", "./rows.csv is named for two outputs");
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "rows.csv"));
  expect_refused("audit f --ring-limit 0", "--ring-limit");
  expect_refused("audit nothing", "nothing");
}

}  // namespace
}  // namespace tamis::test
