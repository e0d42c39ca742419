#include "files/mesh/ply_header.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "files/error.hpp"
#include "files/text.hpp"

namespace tamis::io {
namespace {

struct ScalarName {
  std::string_view old_name;
  std::string_view new_name;
  PlyScalar type;
  std::size_t size;
};

constexpr std::array<ScalarName, 8> kScalars{{{"char", "int8", PlyScalar::int8, 1},
                                              {"uchar", "uint8", PlyScalar::uint8, 1},
                                              {"short", "int16", PlyScalar::int16, 2},
                                              {"ushort", "uint16", PlyScalar::uint16, 2},
                                              {"int", "int32", PlyScalar::int32, 4},
                                              {"uint", "uint32", PlyScalar::uint32, 4},
                                              {"float", "float32", PlyScalar::float32, 4},
                                              {"double", "float64", PlyScalar::float64, 8}}};

class HeaderParser {
 public:
  HeaderParser(std::string_view bytes, const std::string& name) : bytes_(bytes), lines_(bytes), name_(name) {}

  PlyHeader parse() {
    lines_.next();
    if (lines_.line() != "ply") fail("a PLY file starts with the line 'ply': write it again");
    while (lines_.next()) {
      std::string_view rest = lines_.line();
      const std::string_view keyword = take_word(rest);
      if (keyword == "end_header") return finish();
      parse_line(keyword, rest);
    }
    fail("the header has no end_header: the file was cut short, write or copy it again");
  }

 private:
  void parse_line(std::string_view keyword, std::string_view rest) {
    if (keyword == "format")
      parse_format(rest);
    else if (keyword == "element")
      parse_element(rest);
    else if (keyword == "property")
      parse_property(rest);
    else if (keyword != "comment" && keyword != "obj_info" && !keyword.empty())
      fail(fmt::format("{} is not a word of a PLY header: correct the header", in_quotes(keyword)));
  }

  void parse_format(std::string_view rest) {
    if (has_format_) fail("the header has two format lines: remove one");
    const std::string_view format = take_word(rest);
    if (format == "ascii")
      header_.encoding = PlyEncoding::ascii;
    else if (format == "binary_little_endian")
      header_.encoding = PlyEncoding::little_endian;
    else if (format == "binary_big_endian")
      header_.encoding = PlyEncoding::big_endian;
    else
      fail(fmt::format("unknown format {}: write ascii, binary_little_endian or binary_big_endian", in_quotes(format)));
    if (take_word(rest) != "1.0") fail("unknown version of PLY: write version 1.0");
    has_format_ = true;
  }

  void parse_element(std::string_view rest) {
    PlyElement element;
    element.name = take_word(rest);
    element.line = lines_.number();
    const std::string_view word = take_word(rest);
    const auto count = to_integer<std::uint64_t>(word);
    if (!count || !take_word(rest).empty())
      fail("an element needs a name and a count, as in 'element vertex 8': correct the header");
    element.count = *count;
    for (const PlyElement& other : header_.elements)
      if (other.name == element.name)
        fail(fmt::format("element {} stands twice: correct the header", in_quotes(element.name)));
    header_.elements.push_back(std::move(element));
  }

  void parse_property(std::string_view rest) {
    if (header_.elements.empty()) fail("a property before any element: correct the header");
    PlyProperty property;
    std::string_view type = take_word(rest);
    property.is_list = type == "list";
    if (property.is_list) {
      property.count_type = scalar(take_word(rest));
      if (property.count_type >= PlyScalar::float32) fail("a list's length must be of an integer type: write uchar");
      type = take_word(rest);
    }
    property.type = scalar(type);
    property.name = take_word(rest);
    if (property.name.empty()) fail("a property without a name: correct the header");
    header_.elements.back().properties.push_back(std::move(property));
  }

  PlyScalar scalar(std::string_view word) const {
    for (const ScalarName& s : kScalars)
      if (word == s.old_name || word == s.new_name) return s.type;
    fail(fmt::format("{} is not a type of PLY: write char, uchar, short, ushort, int, uint, float or double",
                     in_quotes(word)));
  }

  PlyHeader finish() {
    if (!has_format_) fail("the header has no format line: add one, as in 'format ascii 1.0'");
    for (const PlyElement& element : header_.elements)
      if (element.properties.empty())
        throw FileError(name_, fmt::format("line {}", element.line),
                        fmt::format("element {} has no property: correct the header", in_quotes(element.name)));
    header_.bytes = bytes_.size() - lines_.rest().size();
    header_.lines = lines_.number();
    return std::move(header_);
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw FileError(name_, fmt::format("line {}", std::max<std::size_t>(lines_.number(), 1)), what);
  }

  std::string_view bytes_;
  Lines lines_;
  const std::string& name_;
  PlyHeader header_;
  bool has_format_ = false;
};

}  // namespace

std::size_t size_of(PlyScalar type) { return kScalars[static_cast<std::size_t>(type)].size; }

PlyHeader parse_ply_header(std::string_view bytes, const std::string& name) {
  return HeaderParser(bytes, name).parse();
}

}  // namespace tamis::io
