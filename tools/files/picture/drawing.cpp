#include "files/picture/drawing.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <new>

#include "files/picture/embree.hpp"

namespace tamis::io {

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vector unit(const Vector& a) {
  const float length = std::sqrt(dot(a, a));
  return length > 0 ? (1 / length) * a : Vector{0, 0, 1};
}

namespace {

/// A point with the radius of the ball or rod around it, in Embree's layout.
struct Ball {
  float x, y, z, radius;
};

template <class Element>
Element* buffer(RTCGeometry geometry, RTCBufferType type, RTCFormat format, std::size_t count) {
  void* memory = rtcSetNewGeometryBuffer(geometry, type, 0, format, sizeof(Element), count);
  if (!memory) throw std::bad_alloc();
  return static_cast<Element*>(memory);
}

void set_balls(RTCGeometry geometry, std::span<const Vector> points, float radius) {
  Ball* to = buffer<Ball>(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, points.size());
  for (const Vector& p : points) *to++ = {p[0], p[1], p[2], radius};
}

RTCRay embree_ray(const Ray& ray, float farthest) {
  RTCRay r{};
  r.org_x = ray.origin[0];
  r.org_y = ray.origin[1];
  r.org_z = ray.origin[2];
  r.dir_x = ray.direction[0];
  r.dir_y = ray.direction[1];
  r.dir_z = ray.direction[2];
  r.tnear = ray.nearest;
  r.tfar = farthest;
  r.mask = std::numeric_limits<unsigned>::max();
  return r;
}

}  // namespace

struct Drawing::Handles {
  struct Release {
    void operator()(RTCDevice handle) const { rtcReleaseDevice(handle); }
    void operator()(RTCScene handle) const { rtcReleaseScene(handle); }
    void operator()(RTCGeometry handle) const { rtcReleaseGeometry(handle); }
  };
  template <class Handle>
  using Owned = std::unique_ptr<std::remove_pointer_t<Handle>, Release>;

  /// Adds the geometry that `fill` fills.
  template <class Fill>
  void add(RTCGeometryType type, Hit::Shape shape, const Fill& fill) {
    const Owned<RTCGeometry> geometry(rtcNewGeometry(device.get(), type));
    fill(geometry.get());
    rtcCommitGeometry(geometry.get());
    rtcAttachGeometryByID(scene.get(), geometry.get(), static_cast<unsigned>(shapes.size()));
    shapes.push_back(shape);
  }

  Owned<RTCDevice> device{rtcNewDevice(nullptr)};
  Owned<RTCScene> scene{rtcNewScene(device.get())};
  std::vector<Hit::Shape> shapes;  ///< of the geometries, by their numbers
};

Drawing::Drawing() : handles_(std::make_unique<Handles>()) {
  rtcSetSceneFlags(handles_->scene.get(), RTC_SCENE_FLAG_ROBUST);
}
Drawing::~Drawing() = default;

void Drawing::add_triangles(std::span<const Vector> points, std::span<const Face> faces) {
  if (faces.empty()) return;
  handles_->add(RTC_GEOMETRY_TYPE_TRIANGLE, Hit::Shape::triangle, [&](RTCGeometry geometry) {
    auto* vertices = buffer<Vector>(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, points.size());
    std::copy(points.begin(), points.end(), vertices);
    auto* corners = buffer<Face>(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, faces.size());
    std::copy(faces.begin(), faces.end(), corners);
  });
}

void Drawing::add_rods(std::span<const Vector> points, std::span<const Edge> rods, float radius) {
  if (rods.empty()) return;
  handles_->add(RTC_GEOMETRY_TYPE_ROUND_LINEAR_CURVE, Hit::Shape::rod, [&](RTCGeometry geometry) {
    std::vector<Vector> ends;
    auto* first = buffer<std::uint32_t>(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT, rods.size());
    for (const Edge& rod : rods) {
      *first++ = static_cast<std::uint32_t>(ends.size());
      for (const Index v : rod) ends.push_back(points[static_cast<std::size_t>(v)]);
    }
    set_balls(geometry, ends, radius);
  });
}

void Drawing::add_points(std::span<const Vector> points, float radius) {
  if (points.empty()) return;
  handles_->add(RTC_GEOMETRY_TYPE_SPHERE_POINT, Hit::Shape::point,
                [&](RTCGeometry geometry) { set_balls(geometry, points, radius); });
}

void Drawing::finish() { rtcCommitScene(handles_->scene.get()); }

std::optional<Hit> Drawing::first_hit(const Ray& ray) const {
  RTCRayHit found{embree_ray(ray, std::numeric_limits<float>::infinity()), {}};
  found.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  intersect(handles_->scene.get(), found);
  if (found.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
  return Hit{found.ray.tfar, unit({found.hit.Ng_x, found.hit.Ng_y, found.hit.Ng_z}), handles_->shapes[found.hit.geomID],
             found.hit.primID};
}

bool Drawing::meets_any(const Ray& ray, float reach) const {
  RTCRay r = embree_ray(ray, reach);
  occlude(handles_->scene.get(), r);
  return r.tfar < 0;  // how Embree says yes
}

}  // namespace tamis::io
