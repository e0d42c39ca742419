#include "files/mesh/mesh_formats.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "files/tests/messages.hpp"
#include "support/temporary_folder.hpp"

namespace tamis::io {
namespace {

std::filesystem::path in_project(const std::string& path) { return std::filesystem::path(TAMIS_SOURCE) / path; }

// Bug: a format is read that is not documented, or that no fuzzer and no attack on the command tries.
TEST(MeshFormats, EachIsDocumentedFuzzedAndAttacked) {
  const std::string page = test::bytes_of_file(in_project("docs/files-and-command.md"));
  const std::string attacks = test::bytes_of_file(in_project("tools/command/tests/hostile/attack_files.py"));
  for (const MeshFormat& format : mesh_formats()) {
    const std::string name(format.name), extension(format.extension), target = extension.substr(1);
    EXPECT_TRUE(test::contains(page, "**" + name + "**")) << "describe it in docs/files-and-command.md, Mesh files";
    EXPECT_TRUE(exists(in_project("tests/fuzz/" + target + "_fuzz.cpp"))) << "make this target";
    EXPECT_TRUE(exists(in_project("tests/fuzz/corpus/" + target))) << "make this folder of inputs for the target";
    EXPECT_TRUE(test::contains(attacks, extension + "\""))
        << "add a file of it to MESHES in tools/command/tests/hostile/attack_files.py";
  }
}

// Bug: a file in a folder of frames is left out because its name is in capitals, or a table of contacts is taken for
// one.
TEST(MeshFormats, ExtensionsAreKnownInAnyCase) {
  for (const MeshFormat& format : mesh_formats()) EXPECT_TRUE(is_mesh_name("a" + std::string(format.extension)));
  EXPECT_TRUE(is_mesh_name("a.PLY"));
  EXPECT_FALSE(is_mesh_name("a.csv"));
  EXPECT_FALSE(is_mesh_name("ply"));
}

// Bug: the help names formats that are not read, or lacks one.
TEST(MeshFormats, NamesAreListed) {
  const std::string names = mesh_format_names();
  for (const MeshFormat& format : mesh_formats()) EXPECT_TRUE(test::contains(names, std::string(format.name))) << names;
  EXPECT_TRUE(test::contains(names, " or ")) << names;
}

}  // namespace
}  // namespace tamis::io
