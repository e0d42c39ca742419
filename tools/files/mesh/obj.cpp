#include "files/mesh/obj.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "files/error.hpp"
#include "files/mesh/mesh_builder.hpp"
#include "files/text.hpp"

namespace tamis::io {
namespace {

/// Words that say nothing about vertices and faces: texture, normals, groups, materials, display, and what belongs to
/// free-form curves and surfaces, which have words of their own.
constexpr std::array<std::string_view, 30> kPassedOver{
    "vt",     "vn",   "vp",    "g",        "o",        "s",          "mg",        "usemtl", "mtllib", "usemap",
    "maplib", "lod",  "bevel", "c_interp", "d_interp", "shadow_obj", "trace_obj", "cstype", "deg",    "bmat",
    "step",   "parm", "trim",  "hole",     "scrv",     "sp",         "end",       "con",    "ctech",  "stech"};
/// Free-form curves and surfaces, and other files: what they hold is not in the mesh.
constexpr std::array<std::string_view, 9> kSurface{"curv", "curv2", "surf", "bsp", "bzp", "cdc", "cdp", "res", "call"};

/// Lines that were skipped: how many, and the first.
struct Skipped {
  std::size_t count = 0, first_line = 0;
  std::string first_word;

  void add(std::string_view word, std::size_t line) {
    if (count++ > 0) return;
    first_word = in_quotes(word);
    first_line = line;
  }
  std::string text() const {
    return fmt::format("{} {} skipped, the first in line {}: {}", count, count == 1 ? "line was" : "lines were",
                       first_line, first_word);
  }
};

template <std::size_t n>
bool contains(const std::array<std::string_view, n>& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

bool has_comment(std::string_view line) {
  for (std::string_view word = take_word(line); !word.empty(); word = take_word(line))
    if (word[0] == '#') return true;
  return false;
}

/// Does the next line continue this one? Not if the backslash ends a comment, as in the name of a folder.
bool goes_on(std::string_view line) { return line.ends_with('\\') && !has_comment(line); }

class ObjParser {
 public:
  ObjParser(std::string_view bytes, const std::string& name) : bytes_(bytes), lines_(bytes), name_(name), mesh_(name) {}

  MeshFile parse() {
    while (next_line()) {
      const std::string_view keyword = take_word(rest_);
      if (!keyword.empty() && keyword[0] != '#') parse_line(keyword);
    }
    // A face may name vertices that follow it, so only now is it known whether they exist.
    if (largest_index_ >= vertex_count())
      throw FileError(name_, fmt::format("line {}", largest_index_line_),
                      fmt::format("vertex {} is named, but the file has only {} vertices: correct the file",
                                  largest_index_ + 1, vertex_count()));
    note_open_end(bytes_, mesh_);
    if (surface_.count > 0)
      mesh_.add_note("a part of the surface is missing, as free-form curves, surfaces and other files are not read: " +
                     surface_.text());
    if (unknown_.count > 0) mesh_.add_note("of words that OBJ does not have, " + unknown_.text());
    return mesh_.finish();
  }

 private:
  /// A line that ends in a backslash goes on in the next one.
  bool next_line() {
    if (!lines_.next()) return false;
    rest_ = lines_.line();
    if (!goes_on(rest_)) return true;
    joined_ = rest_;
    while (goes_on(lines_.line())) {
      joined_.back() = ' ';
      if (!lines_.next()) break;
      joined_ += lines_.line();
    }
    rest_ = joined_;
    return true;
  }

  void parse_line(std::string_view keyword) {
    if (keyword == "v")
      add_vertex();
    else if (keyword == "f" || keyword == "fo")  // until version 3 of OBJ "fo" is a face
      add_face();
    else if (keyword == "l")
      add_line();
    else if (keyword == "p")
      add_points();
    else if (contains(kSurface, keyword))
      surface_.add(keyword, lines_.number());
    else if (!contains(kPassedOver, keyword))
      unknown_.add(keyword, lines_.number());
  }

  void add_vertex() {
    if (vertex_count() == std::numeric_limits<Index>::max())
      fail("more vertices than a 32-bit index can name: split the mesh");
    Point p;
    for (double& coordinate : p) {
      const std::string_view word = take_word(rest_);
      if (word.empty()) fail("a vertex needs three coordinates: correct the line");
      coordinate = number(word);
    }
    pass_over_numbers();
    mesh_.add_vertex(p, [&] { return fmt::format("line {}", lines_.number()); });
  }

  double number(std::string_view word) const {
    const auto value = to_double(word);
    if (!value) fail(fmt::format("{} is not a number: correct the line", in_quotes(word)));
    return *value;
  }

  /// A weight or a colour may follow the coordinates. Anything else may be a statement whose line end is lost.
  void pass_over_numbers() {
    for (std::string_view word = take_word(rest_); !word.empty() && word[0] != '#'; word = take_word(rest_))
      number(word);
  }

  void add_face() {
    read_indices();
    if (indices_.size() < 3) fail("a face needs three corners or more: correct the line");
    mesh_.add_polygon(indices_);
  }

  void add_line() {
    read_indices();
    if (indices_.size() < 2) fail("a line needs two vertices or more: correct the line");
    for (std::size_t i = 1; i < indices_.size(); ++i) mesh_.add_loose_edge({indices_[i - 1], indices_[i]});
  }

  void add_points() {
    read_indices();
    for (const Index v : indices_) mesh_.add_loose_point(v);
  }

  void read_indices() {
    indices_.clear();
    for (std::string_view word = take_word(rest_); !word.empty(); word = take_word(rest_))
      if (word[0] == '#')
        return;
      else
        indices_.push_back(index(word));
  }

  /// OBJ counts from 1; the texture and normal after a slash do not matter.
  Index index(std::string_view word) {
    const auto number = to_integer<std::int64_t>(word.substr(0, word.find('/')));
    if (!number || *number == 0 || *number < -vertex_count() || *number > std::numeric_limits<Index>::max())
      fail(fmt::format("{} names no vertex: correct the index (it counts from 1, or back from -1)", in_quotes(word)));
    const std::int64_t index = *number > 0 ? *number - 1 : vertex_count() + *number;
    if (index > largest_index_) {
      largest_index_ = index;
      largest_index_line_ = lines_.number();
    }
    return static_cast<Index>(index);
  }

  std::int64_t vertex_count() const { return static_cast<std::int64_t>(mesh_.vertex_count()); }

  [[noreturn]] void fail(const std::string& what) const {
    throw FileError(name_, fmt::format("line {}", lines_.number()), what);
  }

  std::string_view bytes_;
  Lines lines_;
  std::string joined_;
  std::string_view rest_;
  const std::string& name_;
  std::vector<Index> indices_;
  std::int64_t largest_index_ = -1;
  std::size_t largest_index_line_ = 0;
  Skipped surface_, unknown_;
  MeshBuilder mesh_;
};

}  // namespace

MeshFile parse_obj(std::string_view bytes, const std::string& name) { return ObjParser(bytes, name).parse(); }

}  // namespace tamis::io
