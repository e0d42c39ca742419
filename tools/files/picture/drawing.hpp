// Finds what a ray meets: surfaces, rods and points. Contacts have a Drawing of their own.
#pragma once
#include <memory>
#include <optional>
#include <span>

#include "tamis/mesh.hpp"
#include "tamis/step.hpp"

namespace tamis::io {

/// Single precision, in which rays are traced: pictures show, they decide nothing.
using Vector = std::array<float, 3>;

inline Vector operator+(const Vector& a, const Vector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Vector operator-(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Vector operator*(float s, const Vector& a) { return {s * a[0], s * a[1], s * a[2]}; }
inline float dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector cross(const Vector& a, const Vector& b);
/// Of unit length.
Vector unit(const Vector& a);

struct Ray {
  Vector origin;
  Vector direction;  ///< of unit length
  float nearest = 0;
};

struct Hit {
  float distance = 0;
  Vector normal{};  ///< of unit length, on the outside of what was hit
  enum class Shape { triangle, rod, point } shape = Shape::triangle;
  std::size_t element = 0;  ///< its place among those of its shape
};

/// Things that rays meet. Drawn once, then asked by any number of threads.
class Drawing {
 public:
  Drawing();
  ~Drawing();
  Drawing(const Drawing&) = delete;
  Drawing& operator=(const Drawing&) = delete;

  void add_triangles(std::span<const Vector> points, std::span<const Face> faces);
  void add_rods(std::span<const Vector> points, std::span<const Edge> rods, float radius);
  void add_points(std::span<const Vector> points, float radius);
  /// After this call nothing may be added.
  void finish();

  /// The first thing that the ray meets.
  std::optional<Hit> first_hit(const Ray& ray) const;
  /// Does the ray meet anything within the distance `reach`?
  bool meets_any(const Ray& ray, float reach) const;

 private:
  struct Handles;
  std::unique_ptr<Handles> handles_;
};

}  // namespace tamis::io
