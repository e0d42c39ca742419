// tamis-mpi under mpirun, as a user would run it: its answers are tamis', its errors one sentence, its files complete
// or not there.
#include "command/tests/command.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <string>

#include "files/mesh/mesh_file.hpp"
#include "files/mesh/ply.hpp"
#include "scenes/scene_list.hpp"
#include "support/test_data.hpp"
#include "support/test_names.hpp"

namespace tamis::test {
namespace {

class MpiFolder : public CommandFolder {
 public:
  /// tamis-mpi on so many ranks; seconds on an idle machine, and what hangs is ended after five minutes.
  Outcome run_ranks(int ranks, const std::string& arguments) const {
    const std::string command = "timeout 300 " TAMIS_MPIRUN " -n " + std::to_string(ranks) +
                                " '" TAMIS_MPI_COMMAND "' " + arguments + " >mpi.out 2>mpi.err </dev/null";
    const int status = std::system((in_folder() + command).c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, bytes_of_file((path() / "mpi.out").string()),
            bytes_of_file((path() / "mpi.err").string())};
  }

  /// What stands before a command. Open MPI's own folder is in this one: that in /tmp, which all share, may be removed
  /// by one run while another is about to make it, which then ends.
  std::string in_folder() const {
    const std::string quoted = "'" + path().string() + "'";
    return "cd " + quoted + "; export TMPDIR=" + quoted + "; ";
  }

  std::string bytes_of(const std::string& name) const { return bytes_of_file((path() / name).string()); }

  /// start.ply and end.ply; they are OBJ where there are loose points, which PLY has no place for.
  void write_scene(const scenes::Scene& scene) const {
    for (const auto& [name, positions] : {std::pair{"start.ply", scene.start}, std::pair{"end.ply", scene.end}})
      if (scene.loose_points.empty())
        io::write_ply(path() / name, {positions, scene.faces, scene.loose_edges, {}, {}});
      else
        write(std::string(name) + ".obj", obj_of(scene, positions));
  }

  static std::string obj_of(const scenes::Scene& scene, const std::vector<Point>& positions) {
    std::string text;
    for (const Point& p : positions) text += fmt::format("v {} {} {}\n", p[0], p[1], p[2]);
    for (const Face& f : scene.faces) text += fmt::format("f {} {} {}\n", f[0] + 1, f[1] + 1, f[2] + 1);
    for (const Edge& e : scene.loose_edges) text += fmt::format("l {} {}\n", e[0] + 1, e[1] + 1);
    for (const Index v : scene.loose_points) text += fmt::format("p {}\n", v + 1);
    return text;
  }

  /// The lines of a text that name contacts and times, not what they cost.
  static std::string answer_in(const std::string& text) {
    std::string answer;
    for (std::size_t at = 0, end; at < text.size(); at = end + 1) {
      end = std::min(text.find('\n', at), text.size());
      const std::string line = text.substr(at, end - at);
      for (const char* head : {"contacts", "first", "between", "step", "largest", "free", "not free"})
        if (line.starts_with(head)) answer += line + "\n";
    }
    return answer;
  }

  void expect_same_csv(int ranks, const std::string& frames) const {
    const Outcome one = run("contacts " + frames + " --out one.csv");
    ASSERT_EQ(one.code, 0) << one.err;
    const Outcome many = run_ranks(ranks, "contacts " + frames + " --out many.csv");
    ASSERT_EQ(many.code, 0) << many.err;
    EXPECT_EQ(answer_in(one.out).substr(0, 200), answer_in(many.out).substr(0, 200));
    EXPECT_TRUE(bytes_of("one.csv") == bytes_of("many.csv"));
  }
};

class MpiCommand : public testing::Test {
 protected:
  MpiFolder folder_;
};

class MpiCommandOnScenes : public testing::TestWithParam<scenes::Recipe> {};

TEST_P(MpiCommandOnScenes, WritesTheBytesThatTamisWrites) {
  const MpiFolder folder;
  const scenes::Scene scene = GetParam().make(500, 1);
  folder.write_scene(scene);
  folder.expect_same_csv(4, scene.loose_points.empty() ? "start.ply end.ply" : "start.ply.obj end.ply.obj");
}

INSTANTIATE_TEST_SUITE_P(Scenes, MpiCommandOnScenes,
                         testing::ValuesIn(scenes::recipes().begin(), scenes::recipes().end()), scene_test_name);

TEST_F(MpiCommand, WritesTheBytesThatTamisWritesOfRecordedFrames) {
  const auto data = data_folder();
  if (data.empty()) GTEST_SKIP() << kNoData;
  const auto frames = data / "frames" / "cloth-funnel";
  folder_.expect_same_csv(3, (frames / "227.ply").string() + " " + (frames / "228.ply").string());
}

TEST_F(MpiCommand, ReadsFilesThatCannotBeCutInParts) {
  folder_.write_fall();
  folder_.expect_same_csv(2, "above.obj below.obj");
  const Outcome many = folder_.run_ranks(3, "contacts above.obj below.obj --scale 0.5 --json");
  ASSERT_EQ(many.code, 0) << many.err;
  EXPECT_EQ(many.json()["contacts"]["vf"], 1);
  EXPECT_EQ(many.json()["ranks"].size(), 3);
}

TEST_F(MpiCommand, StepAndFreeAnswerAsTamisDoes) {
  folder_.write_scene(scenes::scene_by_name("colliding-bodies", 600, 1));
  for (const std::string verb : {"earliest", "safe-step --keep 0.2", "is-free"}) {
    const Outcome one = folder_.run(verb + " start.ply end.ply"),
                  many = folder_.run_ranks(3, verb + " start.ply end.ply");
    EXPECT_EQ(one.code, many.code) << verb;
    EXPECT_FALSE(MpiFolder::answer_in(one.out).empty());
    EXPECT_EQ(MpiFolder::answer_in(one.out), MpiFolder::answer_in(many.out));
  }
}

TEST_F(MpiCommand, ASequenceIsInOrderWhoeverAskedIt) {
  folder_.write_fall();
  const std::string frames = "sequence above.obj below.obj lower.obj --substeps 3 --json";
  EXPECT_EQ(folder_.run(frames).code, 1);
  EXPECT_EQ(folder_.run_ranks(2, frames).code, 1);
  auto one = folder_.run(frames).json(), many = folder_.run_ranks(2, frames).json();
  ASSERT_EQ(one["steps"].size(), many["steps"].size());
  for (auto* json : {&one, &many})
    for (auto& step : (*json)["steps"]) step.erase("seconds"), step.erase("rebuilt");
  EXPECT_EQ(one["steps"], many["steps"]);
  EXPECT_EQ(one["contacts"], many["contacts"]);
}

TEST_F(MpiCommand, AFrameThatFailsIsNamed) {
  folder_.write_fall();
  folder_.write("frame9.obj", "v 0 0 nonsense\n");
  const Outcome many = folder_.run_ranks(3, "sequence above.obj below.obj lower.obj frame9.obj");
  EXPECT_EQ(many.code, 2);
  EXPECT_NE(many.err.find("frame9.obj"), std::string::npos) << many.err;
}

TEST_F(MpiCommand, ErrorsAreOneSentenceOfOneRank) {
  folder_.write_fall();
  for (const auto& [arguments, sentence] :
       {std::pair{"contacts above.obj none.obj", "none.obj"},
        std::pair{"contacts above.obj below.obj --out no/such/folder.csv", "no/such/folder.csv"},
        std::pair{"contacts above.obj below.obj --out page.html", "let the name end in .csv"},
        std::pair{"contact above.obj below.obj", "no verb is called 'contact'"}}) {
    const Outcome many = folder_.run_ranks(3, arguments);
    EXPECT_EQ(many.code, 2) << arguments;
    const std::size_t first = many.err.find("tamis: ");
    ASSERT_NE(first, std::string::npos) << many.err;
    EXPECT_EQ(many.err.find("tamis: ", first + 1), std::string::npos) << many.err;
    EXPECT_NE(many.err.find(sentence), std::string::npos) << many.err;
  }
}

// One rank is killed in the middle: mpirun ends the others, and no file is left, whole or half.
TEST_F(MpiCommand, ARankThatDiesLeavesNoFile) {
  folder_.write_scene(scenes::scene_by_name("folded-cloth", 20000, 1));
  const std::string kill_one =
      "(sleep 3; for p in /proc/[0-9]*; do if (tr '\\0' ' ' <$p/cmdline) 2>/dev/null | grep -q '^" TAMIS_MPI_COMMAND
      " contacts start.ply end.ply --out dead.csv'; then kill -9 ${p#/proc/}; break; fi; done) & ";
  const std::string command = folder_.in_folder() + kill_one +
                              "timeout 300 " TAMIS_MPIRUN " -n 3 '" TAMIS_MPI_COMMAND
                              "' contacts start.ply end.ply --out dead.csv --repeat 1000000 "
                              ">/dev/null 2>&1";
  const int status = std::system(command.c_str());
  constexpr int kKilled = 128 + SIGKILL;  // as mpirun passes it on
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), kKilled) << "124: the others waited for ever; 2: it was not killed";
  for (const auto& entry : std::filesystem::directory_iterator(folder_.path()))
    EXPECT_EQ(entry.path().filename().string().find("dead"), std::string::npos) << entry.path();
}

}  // namespace
}  // namespace tamis::test
