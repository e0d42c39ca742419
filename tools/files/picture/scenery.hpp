// A step at one time, drawn: the mesh, and the contacts of the step; or a pose with its intersections.
#pragma once
#include <array>
#include <vector>

#include "files/extent.hpp"
#include "files/picture/camera.hpp"
#include "files/picture/picture.hpp"
#include "files/picture/shading.hpp"

namespace tamis::io {

/// Coordinates are relative to the middle of the scene, in units of half its longest side.
class Scenery {
 public:
  Scenery(const Recording& recording, const PictureOptions& options);

  /// What one sees at (x, y) of the picture, as Camera::sight has it; `turn` and `part` as of sky_at().
  Light seen_at(float x, float y, float turn, std::size_t part) const;

 private:
  Vector placed(const Point& point) const;
  std::vector<Vector> placed_vertices(const Mesh& mesh) const;
  void draw_mesh(const Mesh& mesh);
  void draw_contacts(const Recording& recording);
  void draw_ball(const Point& point, double time);

  FirstStep step_;
  double time_;
  Extent extent_;
  std::vector<Vector> vertices_;  ///< unused ones stand in the middle
  Camera camera_;
  Drawing surfaces_;
  Drawing contacts_;
  std::array<std::vector<Light>, 3> colours_;  ///< of the drawn elements, by Hit::Shape
  std::vector<Vector> contact_places_;
  std::vector<Light> contact_colours_;
};

}  // namespace tamis::io
