#include "files/mesh/frames.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "files/tests/messages.hpp"
#include "support/temporary_folder.hpp"

namespace tamis::io {
namespace {

// Bug: frame10 before frame2; numbers too long for an integer; an order that depends on the input's.
TEST(Frames, NumbersInNamesCompareAsNumbers) {
  const std::vector<std::string_view> ordered{
      "", "a", "a2", "a02", "a10", "a99999999999999999999999", "a100000000000000000000000", "b1c2", "b1c10", "b2c1"};
  for (std::size_t i = 0; i < ordered.size(); ++i)
    for (std::size_t j = 0; j < ordered.size(); ++j) {
      const bool is_swapped_zero =
          (ordered[i] == "a2" && ordered[j] == "a02") || (ordered[i] == "a02" && ordered[j] == "a2");
      if (is_swapped_zero)
        EXPECT_NE(natural_less(ordered[i], ordered[j]), natural_less(ordered[j], ordered[i]));
      else
        EXPECT_EQ(natural_less(ordered[i], ordered[j]), i < j) << ordered[i] << " " << ordered[j];
    }
}

std::vector<std::string> names_of(const std::vector<std::filesystem::path>& files) {
  std::vector<std::string> names;
  for (const auto& file : files) names.push_back(file.filename().string());
  return names;
}

class FrameFiles : public testing::Test {
 protected:
  FrameFiles() {
    for (const char* name : {"f10.ply", "f2.PLY", "f1.obj", "notes.txt", "truth.csv", "odd[1].ply"})
      folder_.write(name, "x");
    std::filesystem::create_directory(folder_.path() / "f3.ply");
  }
  std::string in_folder(const std::string& name) const { return (folder_.path() / name).string(); }
  test::TemporaryFolder folder_;
};

// Bug: other files or folders are taken for frames.
TEST_F(FrameFiles, AFolderGivesItsMeshesInNaturalOrder) {
  EXPECT_EQ(names_of(frame_files({folder_.path().string()})),
            (std::vector<std::string>{"f1.obj", "f2.PLY", "f10.ply", "odd[1].ply"}));
}

// Bug: the shell's alphabetical order survives.
TEST_F(FrameFiles, ListsAndPatternsGiveNaturalOrder) {
  const std::vector<std::string> expected{"f2.PLY", "f10.ply"};
  EXPECT_EQ(names_of(frame_files({in_folder("f10.ply"), in_folder("f2.PLY")})), expected);
  EXPECT_EQ(names_of(frame_files({in_folder("f[12]*.[pP]*")})), expected);
}

// Bug: an order that was given, or that decimals and signs mean, is changed in silence: another motion is asked about.
TEST_F(FrameFiles, WhatBecomesOfAnOrderIsSaid) {
  const std::string one = in_folder("f1.obj"), two = in_folder("f2.PLY"), ten = in_folder("f10.ply");
  EXPECT_TRUE(has_own_order({two, one, two}));
  EXPECT_TRUE(has_own_order({one, ten, two, one}));
  EXPECT_FALSE(has_own_order({one, two, ten}));
  EXPECT_FALSE(has_own_order({one, ten, two})) << "as a shell has it";
  EXPECT_FALSE(has_own_order({two, one})) << "two stay as they are given";
  EXPECT_NE(doubt_about_order("s_0.5.obj", "s_0.25.obj"), "");
  EXPECT_NE(doubt_about_order("a/s_-1.obj", "a/s_-2.obj"), "");
  EXPECT_NE(doubt_about_order("-1.obj", "-2.obj"), "");
  for (const auto& [before, file] :
       {std::pair{"s_0.25.obj", "s_0.5.obj"}, std::pair{"s-1.obj", "s-2.obj"}, std::pair{"s_9.obj", "s_10.obj"},
        std::pair{"a9.obj", "b1.obj"}, std::pair{"s.0001.obj", "s.0002.obj"}, std::pair{"s.obj", "s1.obj"}})
    EXPECT_EQ(doubt_about_order(before, file), "") << file;
}

TEST_F(FrameFiles, ANameThatExistsIsNoPattern) {
  EXPECT_EQ(names_of(frame_files({in_folder("odd[1].ply")})), (std::vector<std::string>{"odd[1].ply"}));
}

// Bug: one that leads to itself ends in a sentence about memory and threads, and none of its name.
TEST_F(FrameFiles, ALinkThatLeadsNowhereIsForTheReaderToRefuse) {
  std::error_code error;
  std::filesystem::create_symlink("f4.ply", folder_.path() / "f4.ply", error);
  if (error) GTEST_SKIP() << "links cannot be made here: " << error.message();
  EXPECT_EQ(names_of(frame_files({folder_.path().string()}))[2], "f4.ply");
}

TEST_F(FrameFiles, NothingFoundIsAnError) {
  const test::TemporaryFolder empty;
  test::file_error(empty.path().string(), [&] { frame_files({empty.path().string()}); });
  test::file_error(in_folder("g*.ply"), [&] { frame_files({in_folder("g*.ply")}); });
}

}  // namespace
}  // namespace tamis::io
