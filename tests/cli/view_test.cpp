// tamis view, and the outputs that it shares with tamis contacts; what is in them is tested in viewer/test.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "cli/command.hpp"

namespace tamis::test {
namespace {

class View : public testing::Test {
 protected:
  View() { folder_.write_fall(); }

  std::string bytes(const std::string& name) const { return bytes_of_file(folder_.path() / name); }

  void expect_refused(const std::string& arguments, const std::string& says) const {
    const Outcome outcome = folder_.run(arguments);
    EXPECT_EQ(outcome.code, 2) << arguments;
    EXPECT_NE(outcome.err.find(says), std::string::npos) << arguments << "\n" << outcome.err << "should say: " << says;
  }

  CommandFolder folder_;
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
  for (const char* extension : {"html", "glb", "vtp", "vtu", "csv"}) {
    const std::string one = std::string("one.") + extension, two = std::string("two.") + extension;
    EXPECT_EQ(folder_.run("view above.obj below.obj --threads 1 --out " + one).code, 0);
    EXPECT_EQ(folder_.run("contacts above.obj below.obj --threads 2 --out " + two).code, 0);
    EXPECT_FALSE(bytes(one).empty());
    EXPECT_EQ(bytes(one), bytes(two)) << extension;
  }
}

TEST_F(View, OutputsThatCannotBeMadeAreRefusedBeforeTheWork) {
  expect_refused("view above.obj below.obj --out step.mp4", "step.mp4: no output has this extension");
  expect_refused("view above.obj below.obj lower.obj --out film.glb", "film.glb: such a file holds one step, not 2");
  expect_refused("view above.obj below.obj --out absent/step.html", "absent/step.html: cannot be written");
  expect_refused("view above.obj", "above.obj: a single frame does not move");
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
  EXPECT_EQ(folder_.run("view near.obj far.obj --out step.html").code, 0);
}

// Bug: a name that is no extension makes `contacts` fail where it wrote a table before.
TEST_F(View, ContactsAreATableUnlessTheExtensionSaysOtherwise) {
  EXPECT_EQ(folder_.run("contacts above.obj below.obj --out table").code, 0);
  EXPECT_TRUE(bytes("table").starts_with("kind,v0,v1"));
}

}  // namespace
}  // namespace tamis::test
