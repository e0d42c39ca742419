#include "files/mesh/wildcards.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "support/temporary_folder.hpp"

namespace tamis::io {
namespace {

bool is_match(std::string_view pattern, std::string_view name) { return matches(pattern, name, Brackets::are_sets); }

TEST(Wildcards, MatchWholeNames) {
  for (const auto& [pattern, name] :
       {std::pair{"", ""}, std::pair{"a", "a"}, std::pair{"*", ""}, std::pair{"*", "abc"}, std::pair{"a*c", "abbc"},
        std::pair{"*.ply", "a.ply.ply"}, std::pair{"a?c", "abc"}, std::pair{"*a*b*", "xaxxbx"}, std::pair{"\\*", "*"},
        std::pair{"a\\", "a\\"}, std::pair{"\\[a]", "[a]"}})
    EXPECT_TRUE(is_match(pattern, name)) << pattern << " " << name;
  for (const auto& [pattern, name] :
       {std::pair{"", "a"}, std::pair{"a", ""}, std::pair{"a", "ab"}, std::pair{"?", ""}, std::pair{"a*c", "abcd"},
        std::pair{"*ab*ab", "ab"}, std::pair{"\\*", "a"}, std::pair{"*.ply", "a.PLY"}})
    EXPECT_FALSE(is_match(pattern, name)) << pattern << " " << name;
}

TEST(Wildcards, BracketsAreSets) {
  for (const auto& [pattern, name] : {std::pair{"[abc]", "b"}, std::pair{"[a-c]", "b"}, std::pair{"[!a-c]", "d"},
                                      std::pair{"[^a]", "b"}, std::pair{"[]]", "]"}, std::pair{"[!]]", "a"},
                                      std::pair{"[a-]", "-"}, std::pair{"f[0-9]*", "f10.ply"}, std::pair{"[a", "[a"}})
    EXPECT_TRUE(is_match(pattern, name)) << pattern << " " << name;
  for (const auto& [pattern, name] : {std::pair{"[abc]", "d"}, std::pair{"[!a-c]", "b"}, std::pair{"[a-c]", "[a-c]"},
                                      std::pair{"[]]", "[]]"}, std::pair{"[a]", ""}})
    EXPECT_FALSE(is_match(pattern, name)) << pattern << " " << name;
  EXPECT_TRUE(matches("a[1]*", "a[1].ply", Brackets::are_plain));
  EXPECT_FALSE(matches("a[1]*", "a1.ply", Brackets::are_plain));
}

// Bug: each star tries all that the stars before it took: a line of stars takes years.
TEST(Wildcards, ManyStarsTakeNoTime) {
  std::string pattern;
  for (int i = 0; i < 100; ++i) pattern += "*a";
  EXPECT_FALSE(is_match(pattern + "b", std::string(250, 'a')));
}

// Bug: hidden files, or those of other folders, are taken for frames.
TEST(Wildcards, EachPartOfAPathIsAPattern) {
  const test::TemporaryFolder folder;
  for (const char* name : {"run1/a.ply", "run1/.b.ply", "run2/a.ply", "other/a.ply", "run3.ply"})
    folder.write(name, "x");
  const auto found = [&](const char* pattern) {
    std::vector<std::string> names;
    for (const auto& path : paths_matching(folder.path(), pattern, Brackets::are_sets))
      names.push_back(path.lexically_relative(folder.path()).generic_string());
    std::sort(names.begin(), names.end());
    return names;
  };
  using Names = std::vector<std::string>;
  EXPECT_EQ(found("run*/*.ply"), (Names{"run1/a.ply", "run2/a.ply"}));
  EXPECT_EQ(found("run*/a.ply"), (Names{"run1/a.ply", "run2/a.ply"}));
  EXPECT_EQ(found("run1/.*"), Names{"run1/.b.ply"});
  EXPECT_EQ(found("run?"), (Names{"run1", "run2"}));
  EXPECT_EQ(found("none/*"), Names{});
}

}  // namespace
}  // namespace tamis::io
