// Nodes of a glTF scene whose points move from one place to another while a weight goes from 0 to 1.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "files/output/glb_buffer.hpp"
#include "tamis/mesh.hpp"
#include "tamis/step.hpp"

namespace tamis::io {

/// Points at both ends of the step.
struct MovingPoints {
  std::vector<Point> start;
  std::vector<Point> end;
};

/// What a primitive is made of, as glTF numbers it.
enum class GlbMode { points = 0, lines = 1, triangles = 4 };

using Colour = std::array<std::uint8_t, 4>;

class GlbScene {
 public:
  /// Positions are written relative to `middle`, where floats are finest.
  explicit GlbScene(const Point& middle) : middle_(middle) {}

  /// Adds points at t=0 and their displacements; returns the JSON from which primitives are made.
  Json add_motion(const MovingPoints& points);
  /// Adds nothing if there are no indices.
  void add_indexed(Json& primitives, Json motion, GlbMode mode, std::span<const Index> indices);
  void add_coloured(Json& primitives, Json motion, GlbMode mode, std::span<const Colour> colours);
  /// `extras`: null for none.
  void add_node(const char* name, Json primitives, Json extras);
  /// The whole file, with an animation of one second.
  std::string file();

 private:
  Point middle_;
  GlbBuffer buffer_;
  Json meshes_ = Json::array();
  Json nodes_ = Json::array();
};

}  // namespace tamis::io
