// Writes PLY in every encoding, value by value; written for the tests, it shares nothing with the reader.
#pragma once
#include <algorithm>
#include <bit>
#include <cstdint>
#include <sstream>
#include <string>

namespace tamis::test {

enum class Encoding { ascii, little, big };

inline const char* name_of(Encoding encoding) {
  return encoding == Encoding::ascii    ? "ascii"
         : encoding == Encoding::little ? "binary_little_endian"
                                        : "binary_big_endian";
}

class PlyBuilder {
 public:
  explicit PlyBuilder(Encoding encoding) : encoding_(encoding) {
    text_ << "ply\nformat " << name_of(encoding) << " 1.0\n";
    text_.precision(17);
  }
  PlyBuilder& header(const std::string& line) {
    text_ << line << '\n';
    return *this;
  }
  PlyBuilder& end_header() { return header("end_header"); }

  /// A value of a type by its PLY name.
  PlyBuilder& value(const std::string& type, double number) {
    if (type == "char" || type == "int8") return put<std::int8_t>(number);
    if (type == "uchar" || type == "uint8") return put<std::uint8_t>(number);
    if (type == "short" || type == "int16") return put<std::int16_t>(number);
    if (type == "ushort" || type == "uint16") return put<std::uint16_t>(number);
    if (type == "int" || type == "int32") return put<std::int32_t>(number);
    if (type == "uint" || type == "uint32") return put<std::uint32_t>(number);
    if (type == "float" || type == "float32") return put<float>(number);
    return put<double>(number);
  }
  PlyBuilder& end_row() {
    if (encoding_ == Encoding::ascii) text_ << '\n';
    return *this;
  }
  std::string text() const { return text_.str(); }

 private:
  template <class T>
  PlyBuilder& put(double number) {
    const T value = static_cast<T>(number);
    if (encoding_ == Encoding::ascii) {
      text_ << static_cast<double>(value) << ' ';
      return *this;
    }
    std::string bytes(reinterpret_cast<const char*>(&value), sizeof(T));
    const bool is_native = (encoding_ == Encoding::little) == (std::endian::native == std::endian::little);
    if (!is_native) std::reverse(bytes.begin(), bytes.end());
    text_ << bytes;
    return *this;
  }

  Encoding encoding_;
  std::ostringstream text_;
};

/// Four vertices and two triangles, doubles and ints.
inline std::string two_triangles(Encoding encoding) {
  PlyBuilder ply(encoding);
  ply.header("element vertex 4").header("property double x").header("property double y").header("property double z");
  ply.header("element face 2").header("property list uchar int vertex_indices").end_header();
  for (const double x : {0.1, 1.0 / 3, -2.5e-300, 1e300})
    ply.value("double", x).value("double", 2 * x).value("double", -x).end_row();
  for (const int corner : {1, 0}) ply.value("uchar", 3).value("int", corner).value("int", 2).value("int", 3).end_row();
  return ply.text();
}

}  // namespace tamis::test
