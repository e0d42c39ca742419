// The steps that `compare` tries: two frames of a file, or two sheets of its own.
#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

struct Scene {
  Eigen::MatrixXd start, end;
  Eigen::MatrixXi faces, edges;
};

[[noreturn]] inline void fail(const std::string& why) {
  std::fprintf(stderr, "compare: %s\n", why.c_str());
  std::exit(1);
}

/// Two sheets of n x n vertices; the upper one, a wave, falls through the lower one.
inline Scene sheets(int n) {
  Scene scene;
  scene.start.resize(2 * n * n, 3);
  scene.faces.resize(4 * (n - 1) * (n - 1), 3);
  int face = 0;
  for (int sheet = 0; sheet < 2; ++sheet)
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        const int v = (sheet * n + i) * n + j;
        const double x = double(i) / n + 0.003 * sheet, y = double(j) / n + 0.002 * sheet;
        scene.start.row(v) << x, y, sheet * (0.1 + 0.02 * std::sin(20 * x) * std::sin(17 * y));
        if (i + 1 == n || j + 1 == n) continue;
        scene.faces.row(face++) << v, v + n, v + 1;
        scene.faces.row(face++) << v + 1, v + n, v + n + 1;
      }
  scene.end = scene.start;
  scene.end.bottomRows(n * n).col(2).array() -= 0.2;
  return scene;
}

/// A binary PLY file: its positions, in floats or doubles, and then its triangles.
class PlyFile {
 public:
  explicit PlyFile(const char* name) : name_(name) {
    std::ifstream file(name, std::ios::binary);
    std::string line, word, element;
    while (std::getline(file, line) && line.substr(0, 10) != "end_header") {
      std::istringstream words(line);
      words >> word;
      if (word == "format") words >> word, swaps_ = word == "binary_big_endian", is_binary_ = word != "ascii";
      if (word == "element") words >> element >> (element == "vertex" ? vertices_ : faces_);
      if (word == "property" && element == "vertex") words >> word, is_double_ = word == "double", ++columns_;
    }
    bytes_.assign(std::istreambuf_iterator<char>(file), {});
    if (!is_binary_ || columns_ != 3 || bytes_.size() != 3 * vertices_ * (is_double_ ? 8 : 4) + 13 * faces_)
      fail(name_ + " is not such a file: give a binary PLY with x y z and triangles, and nothing else");
  }

  Scene scene() {
    Scene scene;
    scene.start.resize(int(vertices_), 3);
    scene.faces.resize(int(faces_), 3);
    for (auto x : scene.start.rowwise())
      for (double& coordinate : x) coordinate = is_double_ ? next<double>() : next<float>();
    for (auto face : scene.faces.rowwise()) {
      if (bytes_[at_++] != 3) fail(name_ + " has a face that is no triangle");
      for (int& vertex : face) vertex = next<std::int32_t>();
    }
    return scene;
  }

 private:
  template <class Number>
  Number next() {
    char bytes[sizeof(Number)];
    std::copy_n(bytes_.data() + at_, sizeof(Number), bytes);
    if (swaps_) std::reverse(bytes, bytes + sizeof(Number));
    at_ += sizeof(Number);
    Number number;
    std::memcpy(&number, bytes, sizeof(Number));
    return number;
  }

  std::string name_, bytes_;
  std::size_t vertices_ = 0, faces_ = 0, at_ = 0;
  int columns_ = 0;
  bool swaps_ = false, is_binary_ = false, is_double_ = false;
};

/// The step from one file's positions to the other's.
inline Scene step_between(const char* start, const char* end) {
  Scene scene = PlyFile(start).scene();
  const Scene last = PlyFile(end).scene();
  if (last.faces != scene.faces) fail(std::string(end) + " has other triangles than " + start);
  scene.end = last.start;
  return scene;
}
