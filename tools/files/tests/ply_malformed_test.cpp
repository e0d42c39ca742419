#include <gtest/gtest.h>

#include "files/mesh/ply.hpp"
#include "files/tests/messages.hpp"
#include "files/tests/ply_builder.hpp"

namespace tamis::io {
namespace {

using test::Encoding;

std::string error_of_ply(const std::string& text) {
  return test::file_error("m.ply", [&] { parse_ply(text, "m.ply"); });
}

// Bug: a file that was cut short gives a smaller or garbled mesh, and contacts are missed in silence.
TEST(MalformedPly, NoPrefixOfABinaryFilePasses) {
  for (const Encoding encoding : {Encoding::little, Encoding::big}) {
    const std::string whole = test::two_triangles(encoding);
    for (std::size_t size = 0; size < whole.size(); ++size) error_of_ply(whole.substr(0, size));
  }
}

// In text, a cut inside the very last number cannot be told from a shorter number: a note says that the line is open.
TEST(MalformedPly, NoPrefixOfATextFilePassesWithoutAWord) {
  const std::string whole = test::two_triangles(Encoding::ascii);
  const std::size_t last_number = whole.rfind('3');
  for (std::size_t size = 0; size <= last_number; ++size) error_of_ply(whole.substr(0, size));
  for (std::size_t size = last_number + 1; size < whole.size(); ++size)
    EXPECT_FALSE(parse_ply(whole.substr(0, size), "m.ply").notes.empty());
}

// Bug: the body is longer than the header says and the rest is dropped in silence.
TEST(MalformedPly, RefusesMoreThanTheHeaderAnnounces) {
  EXPECT_TRUE(test::contains(error_of_ply(test::two_triangles(Encoding::ascii) + "3 0 1 2\n"), "line 16"));
  EXPECT_TRUE(test::contains(error_of_ply(test::two_triangles(Encoding::little) + "abc"), "more than its header"));
  EXPECT_NO_THROW(parse_ply(test::two_triangles(Encoding::little) + "\r\n", "m.ply"));
  EXPECT_NO_THROW(parse_ply(test::two_triangles(Encoding::ascii) + "\n \n", "m.ply"));
}

// Bug: memory is reserved for a count that the header invents, or the count overflows.
TEST(MalformedPly, RefusesHugeCountsBeforeTakingMemory) {
  for (const char* format : {"ascii", "binary_little_endian"})
    for (const char* count : {"1000000000000", "2000000000", "18446744073709551615", "18446744073709551616", "-1"}) {
      const std::string head = std::string("ply\nformat ") + format + " 1.0\n";
      const std::string xyz = "property double x\nproperty double y\nproperty double z\n";
      error_of_ply(head + "element vertex " + count + "\n" + xyz + "end_header\n0 0 0\n");
      error_of_ply(head + "element vertex 0\n" + xyz + "element face " + count +
                   "\nproperty list uchar int vertex_indices\nend_header\n3 0 0 0\n");
      error_of_ply(head + "element vertex 0\n" + xyz + "element other " + count +
                   "\nproperty list int int a\nend_header\n");
    }
  error_of_ply(
      "ply\nformat binary_little_endian 1.0\nelement vertex 0\nproperty char x\nproperty char y\nproperty char z\n"
      "element other 1\nproperty list uint char a\nend_header\n\xff\xff\xff\xff....");
}

const std::string kXyz = "property float x\nproperty float y\nproperty float z\n";

// Bug: any of these is accepted, or the message does not lead to the place.
TEST(MalformedPly, EachErrorNamesItsPlace) {
  const std::string v1 = "format ascii 1.0\nelement vertex 1\n" + kXyz;
  const std::string f1 = v1 + "element face 1\nproperty list uchar int vertex_indices\n";
  const std::string tail = "end_header\n";
  const struct {
    std::string header;
    std::string body;
    std::string says;
  } cases[] = {
      {"format ascii 1.0\nformat binary_little_endian 1.0\n" + tail, "", "line 3: the header has two format lines"},
      {"format ascii 2.0\n" + tail, "", "line 2: unknown version"},
      {"format text 1.0\n" + tail, "", "line 2: unknown format 'text'"},
      {"element vertex 1\n" + kXyz + tail, "0 0 0\n", "no format line"},
      {"format ascii 1.0\n" + tail, "", "no element 'vertex'"},
      {"format ascii 1.0\nelement vertex one\n" + tail, "", "line 3: an element needs"},
      {"format ascii 1.0\nelement vertex 1\n" + tail, "0\n", "line 3: element 'vertex' has no property"},
      {"format ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n" + tail, "0 0\n", "no property z"},
      {"format ascii 1.0\nelement vertex 1\n" + kXyz + "property float x\n" + tail, "0 0 0 0\n",
       "more than one property x"},
      {"format ascii 1.0\nelement vertex 1\nproperty real x\n" + tail, "0\n", "line 4: 'real' is not a type"},
      {"format ascii 1.0\nelement vertex 1\nproperty list float int x\n" + tail, "0\n", "line 4: a list's length"},
      {"format ascii 1.0\nproperty float x\n" + tail, "", "line 3: a property before any element"},
      {v1 + "element vertex 1\n" + tail, "", "stands twice"},
      {v1 + "nonsense\n" + tail, "0 0 0\n", "line 7: 'nonsense'"},
      {v1 + "element face 1\nproperty float area\n" + tail, "0 0 0\n1\n", "no list property vertex_indices"},
      {v1 + "element edge 1\nproperty int vertex1\n" + tail, "0 0 0\n1\n", "no property vertex2"},
      {v1 + tail, "0 0 zero\n", "line 8, 'vertex' 0: 'zero' is not a number"},
      {v1 + tail, "0 0 1.5.2\n", "is not a number"},
      {f1 + tail, "0 nan 0\n3 0 0 0\n", "'vertex' 0: coordinate y is not finite"},
      {f1 + tail, "0 0 -inf\n3 0 0 0\n", "coordinate z is not finite"},
      {f1 + tail, "1e999 0 0\n3 0 0 0\n", "coordinate x is not finite"},
      {v1 + tail, "0.5 0.5\n", "line 8, 'vertex' 0: the line ends too early"},
      {v1 + tail, "0 0 0 0\n", "the line holds more"},
      {f1 + tail, "0 0 0\n3 0 0 1\n", "line 11, 'face' 0: 1 is not a vertex index"},
      {f1 + tail, "0 0 0\n3 0 0 -1\n", "-1 is not a vertex index"},
      {f1 + tail, "0 0 0\n3 0 0 0.5\n", "0.5 is not a vertex index"},
      {f1 + tail, "0 0 0\n3 0 0 nan\n", "nan is not a vertex index"},
      {f1 + tail, "0 0 0\n2 0 0\n", "it has 2 corners"},
      {f1 + tail, "0 0 0\n-3 0 0 0\n", "a list cannot have this length"},
      {f1 + tail, "0 0 0\n2.5 0 0 0\n", "a list cannot have this length"},
      {f1 + tail, "0 0 0\n4 0 0 0\n", "the line ends too early"},
  };
  for (const auto& c : cases) {
    const std::string message = error_of_ply("ply\n" + c.header + c.body);
    EXPECT_TRUE(test::contains(message, c.says)) << message << "\nshould say: " << c.says;
  }
}

// Bug: binary rubbish from the file reaches the terminal, in full length.
TEST(MalformedPly, MessagesShowForeignWordsShortAndPrintable) {
  const std::string message =
      error_of_ply("ply\nformat ascii 1.0\n\x1b[31m" + std::string(1000, 'x') + "\nend_header\n");
  EXPECT_LT(message.size(), 200u);
  EXPECT_FALSE(test::contains(message, "\x1b"));
}

}  // namespace
}  // namespace tamis::io
