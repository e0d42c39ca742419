// Whatever is wrong with the input: exit code 2, one sentence on stderr that names the culprit, nothing on stdout, no
// output file.
#include <gtest/gtest.h>

#include "command/tests/command.hpp"

namespace tamis::test {
namespace {

class BadInput : public FallTest {
 protected:
  BadInput() {
    folder_.write("notes.txt", "hello\n");
    folder_.write("empty.ply", "");
    folder_.write("nothing.obj", "# a comment\n");
    folder_.write("points.obj", "v 0 0 0\nv 1 0 0\n");
    folder_.write("nan.obj", "v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    folder_.write("range.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n");
    folder_.write("huge.ply",
                  "ply\nformat binary_little_endian 1.0\nelement vertex 1000000000000\nproperty double x\n"
                  "property double y\nproperty double z\nend_header\n" +
                      std::string(900, 'x'));
    folder_.write("cut.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n");
    folder_.write("fewer.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    folder_.write("other.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0.2 0.5 -2\nf 1 3 2\np 4\n");
    folder_.write("far.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1e308 0 1\nf 1 2 3\np 4\n");
    folder_.write("q/edge-edge/third.csv", "1,3,0,1,0,1,0\n");
    folder_.write("q.csv", "");
    folder_.write("one/frame.obj", bytes_of_file(folder_.path() / "above.obj"));
    std::filesystem::create_directory(folder_.path() / "hollow");
  }
};

TEST_F(BadInput, FilesThatCannotBeUsed) {
  const std::pair<const char*, const char*> cases[] = {
      {"absent.obj", "absent.obj: cannot be read"},
      {"hollow", "hollow: cannot be read"},
      {"notes.txt", "notes.txt: not PLY"},
      {"empty.ply", "empty.ply: the file is empty"},
      {"nothing.obj", "nothing.obj: no vertex"},
      {"points.obj", "points.obj: no face and no edge"},
      {"nan.obj", "nan.obj: line 1"},
      {"range.obj", "range.obj: line 4"},
      {"huge.ply", "huge.ply: line 3"},
      {"cut.ply", "cut.ply: line 4"},
  };
  for (const auto& [file, says] : cases) {
    expect_refused(std::string("info ") + file, says);
    for (const char* verb : {"contacts", "earliest"}) {
      expect_refused(std::string(verb) + " above.obj " + file, says);
      expect_refused(std::string(verb) + " " + file + " above.obj --json", says);
    }
    // It may be a pattern.
    expect_refused(std::string("is-free above.obj ") + file, std::string(file) + ": ");
    expect_refused(std::string("is-free ") + file + " above.obj --json", std::string(file) + ": ");
  }
}

TEST_F(BadInput, FramesThatDoNotBelongTogether) {
  for (const char* verb : {"contacts", "earliest", "is-free"}) {
    expect_refused(std::string(verb) + " above.obj fewer.obj", "fewer.obj: 3 vertices, but above.obj has 4");
    expect_refused(std::string(verb) + " above.obj other.obj", "other.obj: triangle 0");
  }
  expect_refused("sequence above.obj fewer.obj --json", "fewer.obj: 3 vertices");
}

TEST_F(BadInput, SequencesWithoutMotion) {
  expect_refused("sequence above.obj", "above.obj: a single frame");
  expect_refused("sequence one", "frame.obj: a single frame");
  expect_refused("sequence hollow", "hollow: no PLY");
  expect_refused("sequence 'z*.obj'", "z*.obj: no such file");
}

TEST_F(BadInput, NonsenseOptions) {
  const std::pair<const char*, const char*> cases[] = {
      {"--guarantee conservative", "contacts has no option --guarantee"},
      {"--isa mmx", "'mmx'"},
      {"--threads -1", "--threads"},
      {"--threads many", "--threads"},
      {"--threads 1000000", "--threads"},
      {"--repeat 0", "--repeat"},
      {"--repeat 1.5", "--repeat"},
      {"--scale nan", "--scale"},
      {"--scale -1", "--scale"},
      {"--scale inf", "--scale"},
      {"--scale", "--scale"},
      {"--min-separation -1", "--min-separation"},
      {"--min-separation nan", "--min-separation"},
      {"--what", "contacts has no option --what: see"},
      {"--min-seperation 1", "contacts has no option --min-seperation (--min-separation?): see"},
      {"--thread=2", "--thread (--threads?)"},
      {"--scale 1 --scale 2", "--scale is given twice"},
      {"--scale 1 --scale=1", "--scale is given twice"},
      {"third.obj", "third.obj"},
  };
  for (const auto& [option, says] : cases) expect_refused(std::string("contacts above.obj below.obj ") + option, says);
  expect_refused("contacts above.obj far.obj --scale 10", "a scale of 10 takes vertex 3");
  for (const char* fraction : {"nan", "-0.1", "1", "much"})
    expect_refused(std::string("safe-step absent.obj below.obj --keep ") + fraction, "--keep");
  expect_refused("--threads 1 contacts above.obj below.obj", "--threads comes before the verb");
  expect_refused("within above.obj --distance 1 --min-separation 1", "within has no option --min-separation");
  expect_refused("within above.obj --distance 1 --radius-of 1", "within has no option --radius-of");
  expect_refused("intersections above.obj --radius 1", "intersections has no option --radius");
  expect_refused("bench above.obj below.obj --seed 4", "--triangles and --seed are of generated scenes");
  expect_refused("contacts above.obj", "END");
  expect_refused("dance above.obj below.obj", "dance");
  expect_refused("", "--help");
}

// Bug: a failed run leaves an empty or half-written file, or destroys the one that was there.
TEST_F(BadInput, NoOutputFileIsLeft) {
  expect_refused("contacts above.obj nan.obj --out c.csv", "nan.obj");
  expect_refused("contacts above.obj below.obj --isa fast --out c.csv", "'fast'");
  expect_refused("contacts above.obj below.obj --out absent/c.csv", "absent/c.csv: cannot be written");
  expect_refused("contacts above.obj below.obj --out hollow", "hollow: cannot be written");
  expect_refused("contacts above.obj below.obj --out below.obj", "--out below.obj would overwrite an input");
  for (const auto& entry : std::filesystem::directory_iterator(folder_.path())) {
    EXPECT_NE(entry.path().extension(), ".csv.part");
    EXPECT_FALSE(entry.path().filename().string().starts_with("c.csv")) << entry.path();
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder_.path() / "hollow"));
}

// Bug: a name that promises another format is given what the verb writes.
TEST_F(BadInput, OutputsOfOneFormatAreNamedSo) {
  const std::pair<const char*, const char*> cases[] = {{"truncate above.obj below.obj --out t.obj", ".ply"},
                                                       {"within above.obj --distance 1 --out n.vtp", ".csv"},
                                                       {"within above.obj --distance 1 --out n.csv.gz", ".csv"},
                                                       {"intersections above.obj --out i.glb", ".csv or .html"},
                                                       {"bench above.obj below.obj --out b.html", ".csv"}};
  for (const auto& [command, format] : cases) {
    expect_refused(command, std::string(" here: let the name end in ") + format);
  }
  EXPECT_EQ(folder_.run("within above.obj --distance 1 --out n.CSV").code, 0);
  EXPECT_EQ(folder_.run("within above.obj --distance 1 --out n").code, 0) << "no extension promises nothing";
  EXPECT_EQ(folder_.run("within above.obj --distance 1 --out /dev/null").code, 0);
}

// Bug: hours of simulation before a wrong option is told.
TEST_F(BadInput, FoldersAndScenesAreLookedAtFirst) {
  folder_.write("file", "");
  expect_refused("scene cloth-ball --triangles 600 --frames 1 --out file", "file: the folder cannot be made");
  expect_refused("scene cloth-ball --triangles 600 --frames 1 --out frames --seed -1", "--seed");
  expect_refused("bench --scene soup --triangles 10 --seed -1", "--seed");
}

// Bug: the disk is full and the script that reads the result never learns of it.
TEST_F(BadInput, AnOutputThatCannotTakeTheResult) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  const Outcome outcome = folder_.run("info above.obj --json", "/dev/full");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.err.find("standard output"), std::string::npos) << outcome.err;
}

// Bug: of a hundred commands of a night, one had too little memory, and nothing says which.
TEST_F(BadInput, TooLittleMemoryNamesTheFile) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers need more memory than the limit";
#endif
  constexpr std::uintmax_t kSize = std::uintmax_t{1} << 33;  // a hole: it takes no room on the disk
  std::filesystem::resize_file(folder_.write("big.ply", "ply\n"), kSize);
  const Outcome outcome = folder_.run("info big.ply", "", "", "ulimit -v 1000000;");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(outcome.err, "tamis: info big.ply: not enough memory: use a smaller mesh or a larger machine\n");
}

}  // namespace
}  // namespace tamis::test
