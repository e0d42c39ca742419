// tamis view, and the outputs that it shares with tamis contacts; what is in them is tested in tools/viewer/test.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "command/tests/command.hpp"

namespace tamis::test {
namespace {

class View : public FallTest {
 protected:
  std::string bytes(const std::string& name) const { return bytes_of_file(folder_.path() / name); }
};

TEST_F(View, WritesOnePageOfAStepOrASequence) {
  const Outcome step = folder_.run("view above.obj below.obj --out step.html --json");
  EXPECT_EQ(step.code, 0) << step.err;
  EXPECT_EQ(step.json()["contacts"]["vf"], 1);
  EXPECT_EQ(step.json()["steps"], 1);
  EXPECT_EQ(step.json()["bytes"], bytes("step.html").size());
  const Outcome film = folder_.run("view above.obj below.obj lower.obj --json");
  EXPECT_EQ(film.code, 0) << film.err;
  EXPECT_EQ(film.json()["steps"], 2);
  EXPECT_EQ(film.json()["out"], "view.html");
  for (const char* name : {"step.html", "view.html"}) {
    EXPECT_TRUE(bytes(name).starts_with("<!doctype html>")) << name;
    EXPECT_EQ(bytes(name).find("<!--SCENE-->"), std::string::npos) << "holds no scene: " << name;
  }
}

// Bug: a single frame cannot be looked at, nor where it passes through itself.
TEST_F(View, ASingleFrameShowsItsIntersections) {
  folder_.write("pierced.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0.25 0.25 -1\nv 0.25 0.25 1\nf 1 2 3\nl 4 5\n");
  const Outcome pose = folder_.run("view pierced.obj --out pose.html --json");
  EXPECT_EQ(pose.code, 0) << pose.err;
  EXPECT_EQ(pose.json()["intersections"], 1);
  EXPECT_EQ(pose.json()["steps"], 0);
  EXPECT_EQ(folder_.run("intersections pierced.obj --out same.html").code, 1);
  EXPECT_EQ(bytes("pose.html"), bytes("same.html"));
  EXPECT_EQ(folder_.run("view pierced.obj --out rows.csv").code, 0);
  EXPECT_TRUE(bytes("rows.csv").starts_with("e0,e1,f0,f1,f2"));
  EXPECT_NE(bytes("rows.csv").find("\n3,4,0,1,2"), std::string::npos);
  EXPECT_EQ(folder_.run("view above.obj --out none.html").code, 0);
  EXPECT_EQ(folder_.run("view above.obj below.obj --json").json()["intersections"], nullptr);
  expect_refused("intersections pierced.obj --scale 2", "intersections has no option --scale");
  for (const char* option : {"--scale 2", "--at-start fail", "--min-separation 0.1", "--radius 0.1"})
    expect_refused(std::string("view above.obj --out none.html ") + option,
                   "are of steps, and a single frame is named");
}

// Bug: START and END are sorted like the frames of a sequence, and the motion runs backwards.
TEST_F(View, TwoFilesStayInTheirOrder) {
  folder_.write_frame("b.obj", 1);
  folder_.write_frame("a.obj", -3);
  const Outcome outcome = folder_.run("sequence b.obj a.obj --json");
  EXPECT_NEAR(outcome.json()["steps"][0]["toi_upper"], 0.25, 1e-12);
  EXPECT_EQ(outcome.json()["steps"][0]["start"], "b.obj");
}

// Bug: the same step gives another page when it is asked again, or on another number of threads.
TEST_F(View, TheSameStepGivesTheSameBytes) {
  for (const std::string extension : {"html", "glb", "vtp", "vtu", "csv"}) {
    const std::string one = "one." + extension, two = "two." + extension;
    EXPECT_EQ(folder_.run("view above.obj below.obj --threads 1 --out " + one).code, 0);
    EXPECT_EQ(folder_.run("contacts above.obj below.obj --threads 2 --out " + two).code, 0);
    EXPECT_FALSE(bytes(one).empty());
    EXPECT_EQ(bytes(one), bytes(two)) << extension;
  }
}

TEST_F(View, OutputsThatCannotBeMadeAreRefusedBeforeTheWork) {
  expect_refused("view above.obj below.obj --out step.mp4",
                 "step.mp4: nothing is written as .mp4 here: let the name end in .csv, .html, .glb, .vtp or .vtu");
  expect_refused("view above.obj below.obj lower.obj --out film.glb", "film.glb: such a file holds one step, not 2");
  expect_refused("view above.obj below.obj --out absent/step.html", "absent/step.html: cannot be written");
  expect_refused("view above.obj --out pose.glb", "pose.glb: such a file holds a step, not a single frame");
  folder_.write("nan.obj", "v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  expect_refused("view above.obj nan.obj --out step.html", "nan.obj: line 1");
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "step.html"));
  const std::string before = bytes("above.obj");
  std::filesystem::create_symlink("above.obj", folder_.path() / "page.html");
  expect_refused("view above.obj below.obj --out page.html", "--out page.html would overwrite an input");
  EXPECT_EQ(bytes("above.obj"), before);
}

// Bug: an infinite float in a file that readers trust.
TEST_F(View, WhatFloatsCannotHoldIsNoGltf) {
  folder_.write("near.obj", "v 0 0 0\nv 1e39 0 0\nv 0 1 0\nf 1 2 3\n");
  folder_.write("far.obj", "v 0 0 1\nv 1e39 0 1\nv 0 1 1\nf 1 2 3\n");
  expect_refused("view near.obj far.obj --out step.glb", "step.glb: the mesh is too large for the floats of glTF");
  folder_.write("tiny.obj", "v 0 0 0\nv 1e-40 0 0\nv 0 1e-40 0\nf 1 2 3\n");
  expect_refused("view tiny.obj tiny.obj --out step.glb", "step.glb: the mesh is too small for the floats of glTF");
  EXPECT_EQ(folder_.run("view near.obj far.obj --out step.html").code, 0);
}

// Bug: a page that says "This page cannot be shown", and exit code 0.
TEST_F(View, WhatADoubleCannotSpanIsNoPage) {
  folder_.write("near.obj", "v 0 0 -1.7e308\nv 1 0 0\nv 0 1 1.7e308\nf 1 2 3\n");
  expect_refused("view near.obj near.obj --out step.html", "step.html: the mesh is too large for a page");
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "step.html"));
  EXPECT_EQ(folder_.run("view near.obj near.obj --out step.vtp").code, 0);
  folder_.write("tiny.obj", "v 0 0 0\nv 1e-310 0 0\nv 0 1e-310 0\nf 1 2 3\n");
  expect_refused("view tiny.obj tiny.obj --out step.html", "step.html: the mesh is too small for a page");
  folder_.write("half.obj", "v 0 0 0\nv 1 0 0\nv 0 1 8e307\nf 1 2 3\n");
  EXPECT_EQ(folder_.run("view half.obj half.obj --out step.html").code, 0);
}

// Bug: whoever wrote pictures with an earlier version is told nothing about what draws them now.
TEST_F(View, APictureIsSavedFromThePage) {
  for (const char* verb : {"contacts", "view"})
    expect_refused(std::string(verb) + " above.obj below.obj --out step.png",
                   "step.png: pictures are saved from the page: write step.html, open it and press K");
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "step.png"));
}

// Bug: a name that is no extension makes `contacts` fail where it wrote a table before.
TEST_F(View, ContactsAreATableUnlessTheExtensionSaysOtherwise) {
  EXPECT_EQ(folder_.run("contacts above.obj below.obj --out table").code, 0);
  EXPECT_TRUE(bytes("table").starts_with("kind,v0,v1"));
}

// Bug: what another program would read is written as CSV, without a word.
TEST_F(View, WhatTheNameSaysIsWrittenOrNothing) {
  for (const std::string name : {"c.json", "c.npz", "c.csv.gz", "c.txt"}) {
    expect_refused(
        "contacts above.obj below.obj --out " + name,
        name + ": nothing is written as " + name.substr(name.rfind('.')) + " here: let the name end in .csv");
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / name));
  }
  expect_refused("view above.obj below.obj --out page", "page: nothing is written without an extension here");
}

}  // namespace
}  // namespace tamis::test
