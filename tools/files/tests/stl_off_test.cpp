// STL and OFF.
#include <gtest/gtest.h>

#include <cstring>

#include "files/mesh/off.hpp"
#include "files/mesh/stl.hpp"
#include "files/tests/messages.hpp"

namespace tamis::io {
namespace {

const std::vector<Face> kSquare{{0, 1, 2}, {0, 2, 3}};
const std::vector<std::array<Point, 3>> kCorners{{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}},
                                                 {{{-0.0, 0, 0}, {1, 1, 0}, {0, 1, 0}}}};

std::string ascii_stl() {
  std::string text = "solid a square\n";
  for (const auto& triangle : kCorners) {
    text += " facet normal 0 0 1\n  outer loop\n";
    for (const Point& p : triangle) text += fmt::format("   vertex {} {} {}\n", p[0], p[1], p[2]);
    text += "  endloop\n endfacet\n";
  }
  return text + "endsolid a square\n";
}

std::string binary_stl() {
  std::string bytes = "solid, though it is binary";
  bytes.resize(80);
  bytes += std::string("\2\0\0\0", 4);
  for (const auto& triangle : kCorners) {
    bytes.append(12, '\0');
    for (const Point& p : triangle)
      for (const double x : p) {
        const auto number = static_cast<float>(x);
        std::array<char, 4> raw;
        std::memcpy(raw.data(), &number, 4);
        bytes.append(raw.data(), 4);
      }
    bytes.append(2, '\0');
  }
  return bytes;
}

// Bug: triangles of STL share no vertex, so every edge of a closed surface touches its neighbour.
TEST(Stl, CornersAtOnePlaceAreOneVertex) {
  for (const std::string& bytes : {ascii_stl(), binary_stl()}) {
    const MeshFile mesh = parse_stl(bytes, "m.stl");
    EXPECT_EQ(mesh.positions, (std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
    EXPECT_EQ(mesh.faces, kSquare);
    EXPECT_TRUE(mesh.notes.empty());
  }
  EXPECT_TRUE(looks_like_stl(ascii_stl()));
  EXPECT_FALSE(looks_like_stl(binary_stl()));
}

TEST(Stl, RefusesWhatIsCutOrWrong) {
  const std::string ascii = ascii_stl(), binary = binary_stl();
  const auto message = [](const std::string& bytes) {
    return test::file_error("m.stl", [&] { parse_stl(bytes, "m.stl"); });
  };
  for (std::size_t size = 30; size < binary.size(); ++size)
    EXPECT_THROW(parse_stl(binary.substr(0, size), "m.stl"), FileError) << size;
  EXPECT_TRUE(test::contains(message(binary + "x"), "longer than its header"));
  EXPECT_TRUE(test::contains(message(ascii.substr(0, ascii.find("endloop"))), "cut short"));
  EXPECT_TRUE(test::contains(message("solid\nfacet normal 0 0 1\nvertex 0 0 x\n"), "line 3: 'x' is not a number"));
  EXPECT_TRUE(test::contains(message("solid\nwhat\n"), "line 2: 'what' is not a word of STL"));
  EXPECT_TRUE(test::contains(message("solid\nvertex 0 0 0\nendloop\n"), "line 3: a facet needs three"));
}

// Bug: comments, colours, a missing keyword or polygons upset the reader.
TEST(Off, TakesWhatProgramsWrite) {
  const std::string rows = "0 0 0\n1 0 0\n1 1 0 # a corner\n\n0 1 0\n4 0 1 2 3 0.5 0.5 0.5\n2 0 1\n1 3\n";
  for (const char* head : {"OFF\n4 3 0\n", "OFF 4 3 0\n", "# made\nCOFF\n\n4 3 9\n", "4 3 0\n", "STCNOFF\n4 3 0\n"}) {
    const MeshFile mesh = parse_off(head + rows, "m.off");
    EXPECT_EQ(mesh.positions.size(), 4u);
    EXPECT_EQ(mesh.faces, kSquare) << head;
    EXPECT_EQ(mesh.loose_edges, (std::vector<Edge>{{0, 1}}));
    EXPECT_EQ(mesh.loose_points, (std::vector<Index>{3}));
  }
  EXPECT_TRUE(looks_like_off("# made\nNOFF\n"));
  EXPECT_FALSE(looks_like_off("4 3 0\n"));
}

TEST(Off, EachErrorNamesItsLine) {
  const std::string three = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n";
  const std::pair<std::string, std::string> cases[] = {
      {"4OFF\n1 0 0\n", "line 1: '4OFF' has points of other dimensions"},
      {"OFF BINARY\n", "line 1: binary OFF is not read"},
      {"OFF\n3 x 0\n", "line 2: 'x' is not a number of faces"},
      {"OFF\n3 1 0\n0 0\n", "line 3: '' is not a number"},
      {three + "3 0 1 3\n", "line 6: '3' is not a vertex index, these are 0 to 2"},
      {three, "line 5: the file ends here"},
      {three + "0\n", "line 6: a face without corners"},
      {three + "3 0 1 2\n3 0 1 2\n", "line 7: the file holds more"},
      {"OFF\n1 1 0\n0 nan 0\n1 0\n", "line 3: coordinate y is not finite"},
  };
  for (const auto& [text, says] : cases) {
    const std::string message = test::file_error("m.off", [&, &text = text] { parse_off(text, "m.off"); });
    EXPECT_TRUE(test::contains(message, says)) << message << "\nshould say: " << says;
  }
}

}  // namespace
}  // namespace tamis::io
