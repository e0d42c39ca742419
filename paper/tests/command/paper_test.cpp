// The paper's evaluation at a very small size.
#include <gtest/gtest.h>

#include <sstream>

#include "command/tests/command.hpp"

namespace tamis::test {
namespace {

std::vector<std::string> cells_of(const std::string& line) {
  std::istringstream text(line);
  std::vector<std::string> cells;
  for (std::string cell; std::getline(text, cell, ',');) cells.push_back(cell);
  return cells;
}

/// `tamis-lab paper` with these arguments; pictures, which take seconds, have tests of their own.
Outcome evaluate(const CommandFolder& folder, const std::string& arguments) {
  std::filesystem::permissions(folder.write("bin/python3", "#!/bin/sh\nexit 0\n"), std::filesystem::perms(0755));
  return folder.run("paper " + arguments, "", "", "PATH=$PWD/bin:$PATH");
}

// Bug: a method misses contacts; methods, steps or files are left out.
TEST(PaperVerb, MethodsAgreeAndEveryFileIsThere) {
  const CommandFolder folder;
  const Outcome outcome = evaluate(folder, "--quick --scenes funnel --length 4 --out laboratory");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  for (const char* file : {"report.md", "stages.csv"})
    EXPECT_FALSE(bytes_of_file(folder.path() / "laboratory" / file).empty()) << file;
  std::istringstream table(bytes_of_file(folder.path() / "laboratory/table1.csv"));
  std::string line;
  std::getline(table, line);
  const std::vector<std::string> head = cells_of(line);
  ASSERT_EQ(head.size(), 12u);
  int rows = 0;
  for (; std::getline(table, line); ++rows) {
    const std::vector<std::string> cells = cells_of(line);
    ASSERT_EQ(cells.size(), head.size());
    EXPECT_EQ(cells[4], cells[1] == "1x" ? "4" : "1") << line;
    EXPECT_EQ(cells[11], "0") << line;
  }
  EXPECT_GE(rows, 2 * 8);
}

// Bug: a sample of steps that is not spread over the scene, or is taken for the whole of it.
TEST(PaperVerb, RunsASampleOfTheStepsAndSaysSo) {
  CommandFolder folder;
  for (int i = 0; i < 7; ++i) folder.write_frame("fall/f" + std::to_string(i) + ".obj", i == 4 ? 1.0 : 3.0);
  const Outcome outcome = evaluate(folder, "--scenes none --frames fall=fall --steps fall=3 --out laboratory");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const std::string table = bytes_of_file(folder.path() / "laboratory/table1.csv");
  EXPECT_NE(table.find("fall,1x,0,1,3,6,tamis"), std::string::npos) << table;
  EXPECT_NE(table.find("fall,3x,0,1,2,2,tamis"), std::string::npos) << table;
  const std::string report = bytes_of_file(folder.path() / "laboratory/report.md");
  EXPECT_NE(report.find("| 3 of 6 |"), std::string::npos) << report;
  EXPECT_NE(report.find("`fall`: at most 3 steps"), std::string::npos);
}

// Bug: a step of two frames is not stretched at 3x; the contact beyond the end stays unseen.
TEST(PaperVerb, TwoFramesAreStretched) {
  CommandFolder folder;
  folder.write_frame("fall/f1.obj", 1);
  folder.write_frame("fall/f2.obj", 0.5);
  const Outcome outcome = evaluate(folder, "--scenes none --frames fall=fall --out laboratory");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const std::string table = bytes_of_file(folder.path() / "laboratory/table1.csv");
  EXPECT_NE(table.find("fall,1x,0,1,1,1,tamis"), std::string::npos) << table;
  EXPECT_NE(table.find("fall,3x,1,1,1,1,tamis"), std::string::npos) << table;
  EXPECT_NE(bytes_of_file(folder.path() / "laboratory/report.md").find("fall 3x (stretched)"), std::string::npos);
  EXPECT_NE(outcome.out.find("sets agree"), std::string::npos);
}

// Bug: rows that are lost, changed or measured again by a run that goes on.
TEST(PaperVerb, AnInterruptedRunGoesOnWithTheRowsItHas) {
  CommandFolder folder;
  folder.write_frame("fall/f1.obj", 1);
  folder.write_frame("fall/f2.obj", -0.5);
  const std::string command = "--scenes none --frames fall=fall --out laboratory ";
  ASSERT_EQ(evaluate(folder, command).code, 0);
  const auto file = [&](const char* name) { return bytes_of_file(folder.path() / "laboratory" / name); };
  const std::string table = file("table1.csv"), stages = file("stages.csv"), report = file("report.md");
  folder.write("laboratory/report.md", "");
  const Outcome outcome = evaluate(folder, command + "--resume --frames again=fall");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(file("table1.csv").starts_with(table));  // times too: nothing was measured again
  EXPECT_TRUE(file("stages.csv").starts_with(stages));
  EXPECT_NE(file("report.md").find("| again 1x |"), std::string::npos);
  folder.write("laboratory/table1.csv", "scene,step\nfall,twice\n");
  const Outcome broken = evaluate(folder, command + "--resume");
  EXPECT_EQ(broken.code, 2);
  EXPECT_NE(broken.err.find("table1.csv: line 2"), std::string::npos) << broken.err;
}

// Bug: rows of a scene whose stages the interrupted run had not written yet are read as if nothing had been left, and
// rows that an earlier run finished are dropped while the next one runs.
TEST(PaperVerb, AnInterruptionBetweenTheTablesLosesNothing) {
  CommandFolder folder;
  folder.write_frame("fall/f1.obj", 1);
  folder.write_frame("fall/f2.obj", -0.5);
  const std::string command = "--scenes none --frames fall=fall --out laboratory ";
  ASSERT_EQ(evaluate(folder, command).code, 0);
  const auto file = [&](const char* name) { return bytes_of_file(folder.path() / "laboratory" / name); };
  const std::string table = file("table1.csv"), stages = file("stages.csv");
  folder.write("laboratory/stages.csv", stages + "again,1x,tamis,boxes,1,1\n");  // no row of the table yet
  ASSERT_EQ(evaluate(folder, command + "--resume --frames again=fall").code, 0);
  EXPECT_TRUE(file("table1.csv").starts_with(table));
  EXPECT_EQ(file("stages.csv").find("again,1x,tamis,boxes,1,1\n"), std::string::npos);
  // The run fails at its first scene: what the earlier one had finished is still there.
  folder.write("broken/f1.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  folder.write("broken/f2.obj", "v 0 0 0\n");
  ASSERT_EQ(folder
                .run("paper --scenes none --frames new=fall --frames broken=broken --frames fall=fall --out laboratory "
                     "--resume")
                .code,
            2);
  EXPECT_NE(file("table1.csv").find("\nfall,3x,"), std::string::npos) << file("table1.csv");
}

TEST(PaperVerb, UnknownScenesAreRefused) {
  EXPECT_EQ(evaluate(CommandFolder(), "--scenes moon --out laboratory").code, 2);
  EXPECT_EQ(evaluate(CommandFolder(), "--scenes none --out laboratory").code, 2);
  for (const char* steps : {"3", "=3", "fall=0", "fall=few"})
    EXPECT_EQ(evaluate(CommandFolder(), std::string("--quick --out laboratory --steps ") + steps).code, 2) << steps;
}

}  // namespace
}  // namespace tamis::test
