// Methods by name: contacts and bench of tamis-lab; and what the evaluation is refused.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "command/tests/command.hpp"

namespace tamis::test {
namespace {

// Bug: a method that is not used, or answers differently.
TEST(ContactsByMethod, AreThoseOfTheLibrary) {
  const CommandFolder folder;
  folder.write_fall();
  for (const char* method : {"tamis", "paper", "brute", "paper-sat"}) {
    const Outcome outcome =
        folder.run(std::string("contacts above.obj below.obj --bounding-volume aabb --json --method ") + method);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.json()["contacts"]["vf"], 1) << method;
    const auto stages = outcome.json()["stages"];
    const bool is_sat = std::any_of(stages.begin(), stages.end(), [](const auto& s) { return s["name"] == "sat"; });
    EXPECT_EQ(is_sat, std::string(method) == "paper-sat");
  }
}

// Bug: methods that are timed though they answer differently, or are not what the row says.
TEST(BenchOfMethods, HasARowForEachAndAllAgree) {
  const CommandFolder folder;
  const Outcome outcome = folder.run(
      "bench --scene folded-cloth --triangles 500 --method tamis,paper,brute --question contacts --cold 1 --repeat 1 "
      "--json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto json = outcome.json();
  EXPECT_TRUE(json["answers_agree"]);
  std::set<std::string> methods;
  for (const auto& row : json["rows"]) methods.insert(row["method"].get<std::string>());
  EXPECT_EQ(methods, (std::set<std::string>{"tamis", "paper", "brute"}));
}

// Bug: a volume that is read and not used (the nodes that a traversal visits show it), or that changes the answer.
TEST(BenchOfMethods, TakesABoundingVolumeForThePapersHierarchy) {
  const CommandFolder folder;
  const Outcome outcome = folder.run(
      "bench --scene folded-cloth --triangles 1000 --method paper --question contacts --cold 1 --repeat 1 --json "
      "--bounding-volume sphere,aabb,obb,16-dop,18-dop,26-dop");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto json = outcome.json();
  std::set<std::uint64_t> visited;
  for (const auto& row : json["rows"]) visited.insert(row["nodes_visited"].get<std::uint64_t>());
  EXPECT_EQ(visited.size(), 6u);
}

// Bug: hours of work before a wrong option is told.
TEST(LabCommand, RefusesNamesThatItDoesNotKnow) {
  const CommandFolder folder;
  folder.write_fall();
  folder.write("file", "");
  const std::pair<const char*, const char*> cases[] = {
      {"contacts above.obj absent.obj --method fast", "'fast'"},
      {"contacts above.obj absent.obj --bounding-volume egg", "'egg'"},
      {"bench --scene soup --method fast", "'fast'"},
      {"bench --scene soup --bounding-volume egg", "'egg'"},
      {"queries absent --min-separation ''", "--min-separation"},
      {"paper --quick --out laboratory --length ''", "--length"},
      {"paper --quick --out file", "file: the folder cannot be made"},
      {"paper --quick --out laboratory --frames ball=absent", "absent: no such file"},
      {"paper --quick --out laboratory --frames above.obj", "--frames above.obj names no scene"},
      {"paper --quick --out laboratory --scenes airbag --steps moon=3", "--steps moon=3 names a scene"},
  };
  for (const auto& [arguments, says] : cases) {
    const Outcome outcome = folder.run(arguments);
    EXPECT_EQ(outcome.code, 2) << arguments;
    EXPECT_NE(outcome.err.find(says), std::string::npos) << arguments << '\n' << outcome.err;
    EXPECT_TRUE(outcome.out.empty()) << arguments;
  }
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "laboratory"));
}

// Bug: a verb without examples, or help that counts as an error.
TEST(LabCommand, HasHelpWithExamples) {
  const CommandFolder folder;
  for (const std::string verb : {"contacts", "bench", "paper", "queries"}) {
    const Outcome outcome = folder.run(verb + " --help");
    EXPECT_EQ(outcome.code, 0) << verb;
    EXPECT_NE(outcome.out.find("Examples:\n  tamis-lab " + verb), std::string::npos) << verb;
  }
  EXPECT_EQ(folder.run("--version").code, 0);
}

// Bug: a report in the place of a frame.
TEST(PaperVerb, NeverReplacesItsFrames) {
  const CommandFolder folder;
  const auto& here = folder.path();
  std::filesystem::create_directory(here / "laboratory");
  folder.write_frame("fall/f1.obj", 1);
  folder.write_frame("fall/f2.obj", 0.5);
  for (const char* name : {"report.md", "table1.csv", "stages.csv", "fig4.png"}) {
    std::filesystem::create_symlink(here / "fall/f2.obj", here / "laboratory" / name);
    const Outcome outcome = folder.run("paper --scenes none --frames fall=fall --out laboratory");
    EXPECT_EQ(outcome.code, 2) << name;
    EXPECT_NE(outcome.err.find("overwrite an input"), std::string::npos) << outcome.err;
    std::filesystem::remove(here / "laboratory" / name);
  }
}

}  // namespace
}  // namespace tamis::test
