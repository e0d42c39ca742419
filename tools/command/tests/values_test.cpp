// What an option takes and what it refuses, before any file is read.
#include <gtest/gtest.h>

#include <thread>

#include "command/tests/command.hpp"

namespace tamis::test {
namespace {

class Values : public FallTest {};

constexpr const char* kStepVerbs[] = {"contacts", "earliest", "is-free"};

// Bug: a variable of the shell that is not set counts as 0, and 'tamis is-free' says "no contact, proven".
TEST_F(Values, AnEmptyNumberIsNoZero) {
  for (const std::string verb : kStepVerbs)
    for (const std::string option : {"--scale", "--min-separation", "--threads", "--repeat"}) {
      expect_refused(verb + " above.obj below.obj " + option + " ''", option);
      expect_refused(verb + " above.obj below.obj " + option + "= --json", option);
    }
  expect_refused("safe-step above.obj below.obj --keep ''", "--keep has an empty value");
  expect_refused("safe-step above.obj below.obj --keep=", "--keep");
  for (const std::string option : {"--scale", "--threads", "--min-separation", "--cold", "--warm-up", "--repeat"})
    expect_refused("bench above.obj below.obj " + option + " ''", option);
  for (const std::string option : {"--scale", "--min-separation"})
    expect_refused("sequence above.obj below.obj " + option + " ''", option);
  for (const std::string option : {"--frames", "--triangles", "--seed"})
    expect_refused("scene funnel --out frames " + option + " ''", option);
}

// Bug: the result is not where the script looks for it.
TEST_F(Values, AnEmptyNameIsNoAbsentOne) {
  expect_refused("contacts above.obj below.obj --out ''", "--out");
  expect_refused("contacts above.obj below.obj --out=", "--out");
  expect_refused("contacts above.obj ''", "an argument is empty");
  expect_refused("bench '' '' --scene soup --triangles 10", "an argument is empty");
  expect_refused("contacts above.obj below.obj --out --json", "--out");
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "--json"));
}

// Bug: 010 counts as eight, 0x10 as sixteen; text after a number is passed over.
TEST_F(Values, ANumberIsDecimalAndNothingElse) {
  for (const char* number : {"0x2", "2x", "1e0", "2.0", "'2 '", "' 2'", "many", "1,2", "99999999999999999999", "nan"})
    expect_refused(std::string("is-free above.obj below.obj --threads ") + number, "--threads");
  for (const char* number : {"0x1p3", "1e", "1e999", "nan", "-nan", "inf", "-1", "1'000", "1_0", "[1,2]"})
    expect_refused(std::string("is-free above.obj below.obj --scale \"") + number + "\"", "--scale");
  EXPECT_EQ(folder_.run("scene funnel --triangles 0600 --frames 0 --out frames").code, 0);
}

// Bug: empty places of a list are dropped, and the rows of a table with them.
TEST_F(Values, AListHasNoEmptyPlaces) {
  for (const char* list : {"1,,2", ",", "1,", ",1", "1,x"})
    expect_refused(std::string("bench above.obj below.obj --threads ") + list, "--threads");
  for (const char* list : {"free,,contacts", ",", "free,"})
    expect_refused(std::string("bench above.obj below.obj --question ") + list, "--question");
}

// Bug: a list takes the files behind it.
TEST_F(Values, AListEndsBeforeTheFiles) {
  const Outcome outcome =
      folder_.run("bench --question is-free,contacts --cold 1 --repeat 1 --json --scale 0.1,1 above.obj below.obj");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.json()["rows"].size(), 4u);
}

// Bug: a library below warns about threads on stderr, and the result speaks of a thousand that do not exist.
TEST_F(Values, ThreadsThatDoNotExistAreNotReported) {
  const unsigned processors = std::thread::hardware_concurrency();
  for (const char* verb : {"contacts above.obj below.obj", "sequence below.obj lower.obj"}) {
    const Outcome outcome = folder_.run(std::string(verb) + " --threads 1024 --json");
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.err, "") << verb;
    EXPECT_LE(outcome.json()["threads"], std::max(processors, 1U)) << verb;
  }
  const Outcome bench = folder_.run("bench above.obj below.obj --threads 1024 --cold 1 --repeat 1 --json");
  EXPECT_EQ(bench.err, "");
  EXPECT_LE(bench.json()["rows"][0]["threads"], std::max(processors, 1U));
}

// Bug: a path in brackets is taken apart as a list.
TEST_F(Values, APathInBracketsIsAPath) {
  folder_.write_frame("[a,b]/1.obj", 1);
  folder_.write_frame("[a,b]/2.obj", -2);
  const Outcome outcome = folder_.run("sequence '[a,b]' --json");
  ASSERT_EQ(outcome.code, 1) << outcome.err;
  EXPECT_EQ(outcome.json()["contacts"]["vf"], 1);
}

}  // namespace
}  // namespace tamis::test
