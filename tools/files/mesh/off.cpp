#include "files/mesh/off.hpp"

#include <limits>

#include "files/error.hpp"
#include "files/mesh/mesh_builder.hpp"
#include "files/text.hpp"

namespace tamis::io {
namespace {

constexpr std::string_view kKeyword = "OFF";

/// "OFF", before it perhaps ST, C and N: textures, colours and normals behind the coordinates.
bool is_keyword(std::string_view word) {
  if (!word.ends_with(kKeyword)) return false;
  word.remove_suffix(kKeyword.size());
  for (const std::string_view prefix : {"ST", "C", "N"})
    if (word.starts_with(prefix)) word.remove_prefix(prefix.size());
  return word.empty();
}

std::string_view without_comment(std::string_view line) { return line.substr(0, line.find('#')); }

class OffParser {
 public:
  OffParser(std::string_view bytes, const std::string& name) : bytes_(bytes), lines_(bytes), name_(name), mesh_(name) {}

  MeshFile parse() {
    parse_keyword();
    const auto vertices = count("vertices"), faces = count("faces");
    if (vertices > std::numeric_limits<Index>::max())
      fail("more vertices than a 32-bit index can name: split the mesh");
    vertices_ = static_cast<Index>(vertices);
    for (std::int64_t i = 0; i < vertices; ++i) add_vertex();
    for (std::int64_t i = 0; i < faces; ++i) add_face();
    if (next_line()) fail("the file holds more than its counts say: correct the counts");
    note_open_end(bytes_, mesh_);
    return mesh_.finish();
  }

 private:
  /// The keyword may be missing; the counts may follow it on its line.
  void parse_keyword() {
    require_line();
    std::string_view rest = rest_;
    const std::string_view word = take_word(rest);
    if (word.ends_with(kKeyword) && !is_keyword(word))
      fail(fmt::format("{} has points of other dimensions: write OFF", in_quotes(word)));
    if (!is_keyword(word)) return;
    rest_ = rest;
    std::string_view next = rest;
    if (take_word(next) == "BINARY") fail("binary OFF is not read: write it as text");
    if (next.empty()) require_line();
  }

  std::int64_t count(const char* what) {
    const std::string_view word = take_word(rest_);
    const auto value = to_integer<std::int64_t>(word);
    if (!value || *value < 0) fail(fmt::format("{} is not a number of {}: correct the line", in_quotes(word), what));
    return *value;
  }

  void add_vertex() {
    require_line();
    const Point p = take_point(rest_, [&](const std::string& what) { fail(what); });
    mesh_.add_vertex(p, [&] { return fmt::format("line {}", lines_.number()); });
  }

  void add_face() {
    require_line();
    corners_.clear();
    for (std::int64_t left = count("corners"); left > 0; --left) corners_.push_back(index());
    if (corners_.empty()) fail("a face without corners: correct the line");
    if (corners_.size() == 1) return mesh_.add_loose_point(corners_[0]);
    if (corners_.size() == 2) return mesh_.add_loose_edge({corners_[0], corners_[1]});
    mesh_.add_polygon(corners_);
  }

  Index index() {
    const std::string_view word = take_word(rest_);
    const auto value = to_integer<Index>(word);
    if (!value || *value < 0 || *value >= vertices_)
      fail(
          fmt::format("{} is not a vertex index, these are 0 to {}: correct the line", in_quotes(word), vertices_ - 1));
    return *value;
  }

  /// Steps to the next line that holds something.
  bool next_line() {
    while (lines_.next()) {
      rest_ = without_comment(lines_.line());
      std::string_view words = rest_;
      if (!take_word(words).empty()) return true;
    }
    return false;
  }

  void require_line() {
    if (!next_line()) fail("the file ends here: it was cut short, write or copy it again");
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw FileError(name_, fmt::format("line {}", lines_.number()), what);
  }

  std::string_view bytes_;
  Lines lines_;
  std::string_view rest_;
  const std::string& name_;
  Index vertices_ = 0;
  std::vector<Index> corners_;
  MeshBuilder mesh_;
};

}  // namespace

bool looks_like_off(std::string_view bytes) {
  Lines lines(bytes);
  while (lines.next()) {
    std::string_view rest = without_comment(lines.line());
    if (const std::string_view word = take_word(rest); !word.empty()) return is_keyword(word);
  }
  return false;
}

MeshFile parse_off(std::string_view bytes, const std::string& name) { return OffParser(bytes, name).parse(); }

}  // namespace tamis::io
