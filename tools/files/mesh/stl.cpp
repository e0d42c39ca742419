#include "files/mesh/stl.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <map>

#include "files/error.hpp"
#include "files/mesh/mesh_builder.hpp"
#include "files/text.hpp"

namespace tamis::io {
namespace {

constexpr std::size_t kHeaderBytes = 80, kCountBytes = 4, kTriangleBytes = 50, kNormalBytes = 12, kNumberBytes = 4;

std::uint32_t word_at(std::string_view bytes, std::size_t at) {
  std::uint32_t word = 0;
  for (std::size_t i = 0; i < kNumberBytes; ++i)
    word |= std::uint32_t{static_cast<unsigned char>(bytes[at + i])} << (8 * i);
  return word;
}

/// The size that the count of a binary file announces; 0 if there is no count.
std::uint64_t announced_size(std::string_view bytes) {
  if (bytes.size() < kHeaderBytes + kCountBytes) return 0;
  return kHeaderBytes + kCountBytes + std::uint64_t{word_at(bytes, kHeaderBytes)} * kTriangleBytes;
}

std::string in_small_letters(std::string_view word) {
  std::string text(word);
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

/// Makes one vertex of all corners at one place.
class Corners {
 public:
  explicit Corners(MeshBuilder& mesh) : mesh_(mesh) {}

  template <class Where>
  Index at(Point p, const Where& where) {
    for (double& x : p) x = x == 0 ? 0 : x;  // -0 is the same place as 0
    const auto [known, is_new] = vertices_.emplace(std::bit_cast<Bits>(p), static_cast<Index>(vertices_.size()));
    if (is_new) mesh_.add_vertex(p, where);
    return known->second;
  }

 private:
  using Bits = std::array<std::uint64_t, 3>;
  MeshBuilder& mesh_;
  std::map<Bits, Index> vertices_;
};

MeshFile parse_binary(std::string_view bytes, const std::string& name) {
  if (bytes.size() < announced_size(bytes) || bytes.size() < kHeaderBytes + kCountBytes)
    throw FileError(name, "", "the file is shorter than its header says: it was cut short, write or copy it again");
  if (bytes.size() > announced_size(bytes))
    throw FileError(name, "", "the file is longer than its header says: write it again");
  MeshBuilder mesh(name);
  mesh.set_floats();
  Corners corners(mesh);
  const std::uint32_t count = word_at(bytes, kHeaderBytes);
  for (std::uint32_t i = 0; i < count; ++i) {
    std::size_t at = kHeaderBytes + kCountBytes + i * kTriangleBytes + kNormalBytes;
    Face face;
    for (Index& corner : face) {
      Point p;
      for (double& x : p) x = double{std::bit_cast<float>(word_at(bytes, std::exchange(at, at + kNumberBytes)))};
      corner = corners.at(p, [&] { return fmt::format("triangle {}", i); });
    }
    mesh.add_polygon(face);
  }
  return mesh.finish();
}

class AsciiParser {
 public:
  AsciiParser(std::string_view bytes, const std::string& name)
      : bytes_(bytes), name_(name), lines_(bytes), mesh_(name), corners_(mesh_) {}

  MeshFile parse() {
    while (lines_.next()) {
      rest_ = lines_.line();
      while (take_statement()) {
      }
    }
    if (!loop_.empty()) fail("the file ends inside a facet: it was cut short, write or copy it again");
    note_open_end(bytes_, mesh_);
    return mesh_.finish();
  }

 private:
  /// False at the end of the line.
  bool take_statement() {
    const std::string word = in_small_letters(take_word(rest_));
    if (word == "vertex")
      add_corner();
    else if (word == "endloop")
      end_loop();
    else if (word == "facet")
      for (int i = 0; i < 4; ++i) take_word(rest_);  // the normal
    else if (word == "solid" || word == "endsolid")
      rest_ = {};  // a name
    else if (word != "outer" && word != "loop" && word != "endfacet" && !word.empty())
      fail(fmt::format("{} is not a word of STL: correct the line", in_quotes(word)));
    return !word.empty();
  }

  void add_corner() {
    const Point p = take_point(rest_, [&](const std::string& what) { fail(what); });
    loop_.push_back(corners_.at(p, [&] { return fmt::format("line {}", lines_.number()); }));
  }

  void end_loop() {
    if (loop_.size() < 3) fail("a facet needs three vertices or more: correct the file");
    mesh_.add_polygon(loop_);
    loop_.clear();
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw FileError(name_, fmt::format("line {}", lines_.number()), what);
  }

  std::string_view bytes_;
  const std::string& name_;
  Lines lines_;
  std::string_view rest_;
  MeshBuilder mesh_;
  Corners corners_;
  std::vector<Index> loop_;
};

}  // namespace

bool looks_like_stl(std::string_view bytes) {
  constexpr std::size_t kHead = 512;
  return bytes.starts_with("solid") && bytes.size() != announced_size(bytes) &&
         in_small_letters(bytes.substr(0, kHead)).find("facet") != std::string::npos;
}

MeshFile parse_stl(std::string_view bytes, const std::string& name) {
  // Headers of binary files may begin with "solid", too; a zero byte follows in the header or in the count.
  const bool is_text = bytes.substr(0, kHeaderBytes + kCountBytes).find('\0') == std::string_view::npos;
  const bool is_ascii = is_text && in_small_letters(bytes.substr(0, 5)) == "solid";
  return is_ascii ? AsciiParser(bytes, name).parse() : parse_binary(bytes, name);
}

}  // namespace tamis::io
