// tamis bodies: bodies of a file, and what is said of a file that cannot be used.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "command/tests/command.hpp"

namespace tamis::test {
namespace {

/// A triangle in the plane z = 0; a loose point at the origin; both are bodies' own frames.
const std::string kMeshes =
    R"("meshes": {"floor": {"points": [[-1,-1,0],[2,-1,0],[-1,2,0]], "faces": [[0,1,2]]},
                  "point": {"points": [[0.25,0.25,0]], "loose_points": [0]}},)";

std::string bodies_of(const std::string& bodies) { return "{" + kMeshes + "\"bodies\": [" + bodies + "]}"; }

std::string with_floor(const std::string& body) { return bodies_of(R"({"name": "floor", "mesh": "floor"},)" + body); }

class BodiesVerb : public CommandTest {
 protected:
  Outcome ask(const std::string& scene, const std::string& options = "--json") const {
    folder_.write("scene.json", scene);
    return folder_.run("bodies scene.json " + options);
  }
};

// Bug: a body that turns is taken for one whose vertices go straight: both ends of this step are free, and so are the
// chords.
TEST_F(BodiesVerb, ExampleOfTheDocsFindsTheRodThatSwingsThroughTheWall) {
  const std::string example = bytes_of_file(TAMIS_BODIES_EXAMPLE);
  const Outcome outcome = ask(example);
  EXPECT_EQ(outcome.code, 1) << outcome.err;
  const auto json = outcome.json();
  ASSERT_EQ(json["steps"].size(), 2u);
  EXPECT_TRUE(json["steps"][0]["toi_lower"].is_null());
  EXPECT_TRUE(json["steps"][0]["contact"].is_null());
  EXPECT_EQ(json["first_not_free"], 2);
  EXPECT_EQ(json["free_steps"], 1);
  EXPECT_EQ(json["free"], false);
  EXPECT_EQ(json["bodies"], (nlohmann::json{{"static", 1}, {"rigid", 1}, {"deforming", 0}}));
  const auto contact = json["steps"][1]["contact"];
  EXPECT_EQ(contact["bodies"], (std::vector<std::string>{"rod", "wall"}));
  EXPECT_EQ(contact["kind"], "vf");
  EXPECT_EQ(contact["vertices"][0], 4);
  const double time = (std::numbers::pi - std::acos(1 / 1.2) - 1.9) / 3;
  EXPECT_LE(contact["toi_lower"].get<double>(), time);
  EXPECT_NEAR(contact["toi_upper"].get<double>(), time, 1e-8);
  const std::string text = folder_.run("bodies scene.json").out;
  EXPECT_NE(text.find("1 static, 1 rigid, 0 deforming"), std::string::npos) << text;
  EXPECT_NE(text.find("first not free  step 2\nbetween         vertex 4 of rod and face 0 1 2 of wall"),
            std::string::npos)
      << text;
}

TEST_F(BodiesVerb, FirstContactsAreOneForEachPairOfBodies) {
  const std::string example = bytes_of_file(TAMIS_BODIES_EXAMPLE);
  const auto all = ask(example).json()["steps"][1], first = ask(example, "--first --json").json()["steps"][1];
  EXPECT_GT(all["contacts"]["vf"].get<int>() + all["contacts"]["ee"].get<int>(), 1);
  EXPECT_EQ(first["contacts"]["vf"].get<int>() + first["contacts"]["ee"].get<int>(), 1);
  EXPECT_EQ(first["contact"], all["contact"]);
}

// Bug: the shorter turn and a linear rotation vector are exchanged: by the linear one the rod turns once around.
TEST_F(BodiesVerb, TurnsAreThoseThatTheFileNames) {
  std::string scene = bytes_of_file(TAMIS_BODIES_EXAMPLE);
  scene.replace(scene.find("[0, 0, 4.9]"), 11, "[0, 0, 8.183185307179586]");  // a full turn further than 1.9
  EXPECT_EQ(ask(scene).code, 1);
  scene.replace(scene.find("linear"), 6, "shorter");
  const Outcome outcome = ask(scene);
  EXPECT_EQ(outcome.code, 0) << outcome.out;
  EXPECT_EQ(outcome.json()["free"], true);
  scene.erase(scene.find(R"("turn": "shorter", )"), 19);
  EXPECT_EQ(ask(scene).code, 0);
}

// Bug: a quaternion in another order, or not of unit length taken as it is.
TEST_F(BodiesVerb, QuaternionsAreRotations) {
  std::string scene = bytes_of_file(TAMIS_BODIES_EXAMPLE);
  const double half = std::sqrt(0.5);
  scene.replace(scene.find(R"("rotation": [0, 0, 4.9])"), 23,
                R"("quaternion": [)" + std::to_string(half) + ", 0, 0, " + std::to_string(half) + "]");
  scene.replace(scene.find("linear"), 6, "shorter");
  EXPECT_EQ(ask(scene).code, 0);  // 90 degrees about z
  scene.replace(scene.find("0, 0, 0.7") + 3, 1, "1");
  EXPECT_NE(ask(scene).err.find("scene.json: bodies[1].poses[2].quaternion: "), std::string::npos);
}

// Bug: files are looked for where the command runs; a deforming body whose frames are those of another step.
TEST_F(BodiesVerb, DeformingBodiesReadTheirFramesBesideTheFile) {
  const auto frame = [&](const std::string& name, double z) {
    folder_.write("there/" + name, "v 0.25 0.25 " + std::to_string(z) + "\nv 5 5 " + std::to_string(z) + "\nv 5 6 " +
                                       std::to_string(z) + "\nf 1 2 3\n");
  };
  frame("sheet2.obj", 3);
  frame("sheet6.obj", 1);
  frame("sheet10.obj", -1);
  folder_.write("there/ground.obj", "v -1 -1 0\nv 2 -1 0\nv -1 2 0\nf 1 2 3\n");
  folder_.write("there/scene.json",
                R"({"bodies": [{"mesh": "ground.obj"}, {"name": "sheet", "frames": ["sheet*.obj"]}]})");
  const Outcome outcome = folder_.run("bodies there/scene.json --json --out all.csv");
  EXPECT_EQ(outcome.code, 1) << outcome.err;
  const auto json = outcome.json();
  EXPECT_EQ(json["free_steps"], 1);
  const auto contact = json["steps"][1]["contact"];
  EXPECT_EQ(contact["bodies"], (std::vector<std::string>{"sheet", "body 0"}));
  EXPECT_LE(contact["toi_lower"].get<double>(), 0.5);
  EXPECT_NEAR(contact["toi_upper"].get<double>(), 0.5, 1e-12);
  const std::string table = bytes_of_file(folder_.path() / "all.csv");
  EXPECT_TRUE(
      table.starts_with("step,body_a,body_b,kind,v0,v1,v2,v3,toi_lower,toi_upper,u,v,status,nx,ny,nz\n"
                        "2,sheet,body 0,vf,0,0,1,2,0.4999999"))
      << table;
  EXPECT_EQ(static_cast<std::uint64_t>(std::count(table.begin(), table.end(), '\n')) - 1,
            json["contacts"]["vf"].get<std::uint64_t>() + json["contacts"]["ee"].get<std::uint64_t>());
}

// Bug: the name of the folder is taken for a pattern, and the frames of another folder are asked.
TEST_F(BodiesVerb, FramesAreThoseBesideTheFileWhateverItsFolderIsCalled) {
  for (const auto& [folder, z] : {std::pair{"run[1]", "-1"}, std::pair{"run1", "1"}}) {
    const std::string name = std::string(folder) + "/sheet";
    folder_.write(name + "1.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nv 0.25 0.25 1\np 4\n");
    folder_.write(name + "2.obj", std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nv 0.25 0.25 ") + z + "\np 4\n");
  }
  folder_.write("run[1]/scene.json", R"({"bodies": [{"frames": ["sheet*.obj"]}]})");
  folder_.write("run[1]/back.json", R"({"bodies": [{"frames": ["sheet2.obj", "sheet1.obj"]}]})");
  EXPECT_EQ(folder_.run("bodies 'run[1]/scene.json'").code, 1);
  EXPECT_EQ(folder_.run("bodies 'run[1]/back.json' --json").json()["contacts"]["vf"], 1);
}

// Bug: an option of the command that does not reach the question.
TEST_F(BodiesVerb, OptionsReachTheQuestion) {
  const std::string above =
      with_floor(R"({"name": "p", "mesh": "point", "poses": [{"position": [0,0,1]}, {"position": [0,0,0.5]}]})");
  EXPECT_EQ(ask(above, "--threads 1 --repeat 2").code, 0);
  EXPECT_EQ(ask(above, "--min-separation 0.75").code, 1);
  const std::string leaves =
      with_floor(R"({"name": "p", "mesh": "point", "poses": [{"position": [0,0,0]}, {"position": [0,0,0.5]}]})");
  EXPECT_EQ(ask(leaves).json()["steps"][0]["toi_upper"], 0);
  EXPECT_EQ(ask(leaves, "--at-start ignore").code, 0);
  const Outcome fails = ask(leaves, "--at-start fail");
  EXPECT_EQ(fails.code, 2);
  EXPECT_NE(fails.err.find("scene.json: step 1, bodies counted from 0: vertex 0 and "), std::string::npos) << fails.err;
  std::string apart = leaves;
  apart.replace(apart.rfind(']'), 1, R"(], "may_not_touch": [["p", "floor"]])");
  EXPECT_EQ(ask(apart).code, 0);
  const std::string one = ask(above, "").out;
  EXPECT_NE(one.find("first contact   none: the step is free, proven"), std::string::npos) << one;
}

// Bug: bodies that stand in each other are "free, proven" for as long as they do not touch anew.
TEST_F(BodiesVerb, StartIsAskedIfItIsToBe) {
  const auto scene = [](const std::string& height) {
    return R"({"meshes": {"floor": {"points": [[-1,-1,0],[2,-1,0],[-1,2,0]], "faces": [[0,1,2]]},
                          "pin": {"points": [[0.25,0.25,-1],[0.25,0.25,1]], "edges": [[0,1]]}},
               "bodies": [{"name": "floor", "mesh": "floor"},
                          {"name": "pin", "mesh": "pin", "poses": [{"position": [0,0,)" +
           height + R"(]}, {"position": [0.1,0,)" + height + R"(]}, {"position": [0.2,0,)" + height + "]}]}]}";
  };
  const Outcome unasked = ask(scene("0"), "");
  EXPECT_EQ(unasked.code, 0) << unasked.err;
  EXPECT_NE(unasked.out.find("presupposes     bodies that do not pass through each other at the START"),
            std::string::npos)
      << unasked.out;
  EXPECT_TRUE(ask(scene("0")).json()["start_intersections"].is_null());
  const Outcome through = ask(scene("0"), "--check-start --out all.csv");
  EXPECT_EQ(through.code, 1) << through.err;
  EXPECT_NE(through.out.find("1 intersection, the first of edge 0 1 of pin and face 0 1 2 of floor"), std::string::npos)
      << through.out;
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "all.csv"));
  EXPECT_EQ(ask(scene("0"), "--check-start --json").json(),
            nlohmann::json::parse(R"({"free": false, "start_intersections": 1, "start_intersection":
                                      {"bodies": ["pin", "floor"], "edge": [0, 1], "face": [0, 1, 2]}})"));
  const Outcome above = ask(scene("3"), "--check-start");
  EXPECT_EQ(above.code, 0) << above.err;
  EXPECT_NE(above.out.find("START           no body that moves passes through another"), std::string::npos)
      << above.out;
  EXPECT_EQ(ask(scene("3"), "--check-start --json").json()["start_intersections"], 0);
}

// Bug: a body that moves within another one is "free, proven".
TEST_F(BodiesVerb, BodiesInsideOthersAreFoundIfAsked) {
  const auto scene = [](const std::string& height) {
    return R"({"meshes": {"block": {"points": [[-1,-1,-1],[3,-1,-1],[-1,3,-1],[-1,-1,3]],
                                    "faces": [[0,2,1],[0,1,3],[1,2,3],[2,0,3]]},
                          "pin": {"points": [[-0.5,-0.5,-0.5],[-0.5,-0.5,0]], "edges": [[0,1]]}},
               "bodies": [{"name": "block", "mesh": "block"},
                          {"name": "pin", "mesh": "pin", "poses": [{"position": [0,0,)" +
           height + R"(]}, {"position": [0.1,0,)" + height + R"(]}]}]})";
  };
  EXPECT_EQ(ask(scene("0"), "--check-start").code, 0);
  const Outcome inside = ask(scene("0"), "--check-overlap");
  EXPECT_EQ(inside.code, 1) << inside.err;
  EXPECT_NE(inside.out.find("START           a body is inside another one; nothing else was tested"), std::string::npos)
      << inside.out;
  EXPECT_EQ(ask(scene("0"), "--check-overlap --json").json(),
            nlohmann::json::parse(R"({"free": false, "start_intersections": 0, "start_overlaps": true})"));
  const Outcome above = ask(scene("9"), "--check-overlap");
  EXPECT_EQ(above.code, 0) << above.err;
  EXPECT_NE(above.out.find("or is inside one"), std::string::npos) << above.out;
  EXPECT_EQ(ask(scene("9"), "--check-overlap --json").json()["start_overlaps"], false);
}

// Bug: half a file answers as if the rest were at the origin; a sentence that does not say where.
TEST_F(BodiesVerb, WhatCannotBeUsedIsRefusedWithItsPlace) {
  folder_.write("ball.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  folder_.write("other.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 3 2\n");
  const std::string moving = R"("poses": [{}, {"position": [0,0,1]}])";
  const std::pair<std::string, const char*> cases[] = {
      {"{\n\"bodies\": [}", "scene.json: line 2: is not JSON"},
      {R"({"bodies": [], "bodies": []})", "the key 'bodies' stands twice"},
      {R"({"bodies": [{"mesh": "a", "mass": 1e999}]})", "a number beyond all doubles"},
      {std::string(100, '['), "nests deeper than 64 levels"},
      {"[]", "is not an object"},
      {"{}", "bodies: is missing"},
      {R"({"bodies": []})", "bodies: no body moves"},
      {R"({"bodies": {}})", "bodies: is not an array: give a list of bodies"},
      {R"({"body": []})", "there is no key 'body': the keys are meshes, bodies, may_not_touch"},
      {bodies_of(R"({"name": "x"})"), "bodies[0].mesh: is missing"},
      {bodies_of(R"({"mesh": "floor"}, {"mesh": "point"})"), "bodies: no body moves"},
      {bodies_of(R"({"mesh": "absent.ply"})"), "bodies[0].mesh: absent.ply: cannot be read"},
      {bodies_of(R"({"mesh": 7})"), "bodies[0].mesh: is not text"},
      {bodies_of(R"({"mesh": "floor", "velocity": [1,0,0]})"), "bodies[0]: there is no key 'velocity'"},
      {bodies_of(R"({"name": "a", "mesh": "floor"}, {"name": "a", "mesh": "point"})"), "another body is called 'a'"},
      {with_floor(R"({"mesh": "point", "pose": {}, )" + moving + "}"), "bodies[1]: has several of"},
      {with_floor(R"({"mesh": "point", "poses": [{}]})"), "bodies[1].poses: has 1: a body that moves has two"},
      {with_floor(R"({"mesh": "point", )" + moving + R"(}, {"mesh": "point", "poses": [{},{},{}]})"),
       "bodies[2].poses: has 3, but a body above has 2"},
      {with_floor(R"({"mesh": "point", "poses": [{}, {"quaternion": [1,1,0,0]}]})"), "bodies[1].poses[1].quaternion: "},
      {with_floor(R"({"mesh": "point", "poses": [{}, {"quaternion": [1,0,0]}]})"), "is not an array of 4 numbers"},
      {with_floor(R"({"mesh": "point", "poses": [{}, {"rotation": [0,0,0], "quaternion": [1,0,0,0]}]})"),
       "bodies[1].poses[1]: has a rotation and a quaternion"},
      {with_floor(R"({"mesh": "point", "poses": [{}, {"rotation": [0,"0",0]}]})"),
       "poses[1].rotation: holds something"},
      {with_floor(R"({"mesh": "point", "turn": "linear", "poses": [{}, {"quaternion": [1,0,0,0]}]})"),
       "bodies[1].poses[1]: turn 'linear' is of rotation vectors"},
      {with_floor(R"({"mesh": "point", "turn": "fast", )" + moving + "}"), "bodies[1].turn: is neither shorter nor"},
      {with_floor(R"({"mesh": "point", "turn": "linear"})"), "bodies[1].turn: is of bodies with 'poses' alone"},
      {with_floor(R"({"mesh": "point", "frames": ["ball.obj", "ball.obj"]})"), "bodies[1]: has a mesh and frames"},
      {with_floor(R"({"frames": ["ball.obj"]})"), "bodies[1].frames: has 1"},
      {with_floor(R"({"frames": ["ball.obj", "none.obj"]})"), "bodies[1].frames: none.obj: "},
      {R"({"bodies": [{"frames": ["ball.obj", "other.obj"]}]})", "other.obj: "},
      {with_floor(R"({"frames": ["ball.obj", "other.obj", "ball.obj"]})"),
       "bodies[1].frames: frames are taken in natural"},
      {with_floor(R"({"frames": []})"), "bodies[1].frames: has no frame"},
      {R"({"meshes": {"m": {"points": [[0,0,0]], "faces": [[0,0]]}}, "bodies": [{"mesh": "m"}]})",
       "meshes.m.faces[0]: has 2 vertices"},
      {R"({"meshes": {"m": {"points": [[0,0,0]], "faces": [[0,1,2]]}}, "bodies": [{"mesh": "m"}]})", "meshes.m: "},
      {R"({"meshes": {"m": {"points": [[0,0,0]], "faces": [[0,-1,0]]}}, "bodies": [{"mesh": "m"}]})",
       "meshes.m.faces[0][1]: is not an index"},
      {R"({"meshes": {"m": {"points": [[0,0,0]]}}, "bodies": [{"mesh": "m"}]})", "meshes.m: "},
      {with_floor(R"({"mesh": "floor", )" + moving + "}"), "meshes.point: no body has this mesh"},
      {"{" + kMeshes +
           R"("may_not_touch": [["p", "q"]], "bodies": [{"name": "p", "mesh": "floor"},{"mesh": "point", )" + moving +
           "}]}",
       "may_not_touch[0][1]: no body is called 'q'"},
  };
  for (const auto& [scene, says] : cases) {
    folder_.write("scene.json", scene);
    expect_refused("bodies scene.json", says);
  }
}

// Bug: the page shows the chord, on which nothing touches, and not the curve, which takes many frames.
TEST_F(BodiesVerb, PageShowsTheCurve) {
  const auto page_of = [&](const std::string& scene, int code) {
    EXPECT_EQ(ask(scene, "--out rod.html").code, code);
    return bytes_of_file(folder_.path() / "rod.html");
  };
  std::string scene = bytes_of_file(TAMIS_BODIES_EXAMPLE);
  const std::string curved = page_of(scene, 1);
  scene.replace(scene.find("[0, 0, 4.9]"), 11, "[0, 0, 1.9]");
  const std::string at_rest = page_of(scene, 0);
  EXPECT_TRUE(curved.starts_with("<!doctype html>"));
  EXPECT_EQ(curved.find("<!--SCENE-->"), std::string::npos) << "holds no scene";
  EXPECT_GT(curved.size(), at_rest.size() + 8 * 50) << "eight frames more";
}

// Bug: a table that stands where the scene stood.
TEST_F(BodiesVerb, InputsAreNotOverwritten) {
  const std::string example = bytes_of_file(TAMIS_BODIES_EXAMPLE);
  EXPECT_EQ(ask(example, "--out scene.json").code, 2);
  EXPECT_EQ(ask(example, "--out contacts.ply").code, 2);
  EXPECT_EQ(bytes_of_file(folder_.path() / "scene.json"), example);
}

}  // namespace
}  // namespace tamis::test
