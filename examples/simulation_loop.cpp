#include <algorithm>
#include <cmath>
#include <cstdio>
#include <tamis/tamis.hpp>

using Vectors = std::vector<tamis::Point>;

constexpr int kSide = 12, kCloth = kSide * kSide;  // vertices of a cloth, which falls on a triangle
constexpr double kStep = 0.01, kSpring = 400, kThickness = 0.01;

double dot(const tamis::Point& a, const tamis::Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
tamis::Point sum(const tamis::Point& a, double s, const tamis::Point& b) {
  return {a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]};
}

/// Takes from the velocities what brings the pair together. Every mass is 1, but nothing moves the ground.
void respond(const tamis::Contact& c, Vectors& velocity) {
  const auto weights = tamis::weights_of(c.kind, c.u, c.v);
  double approach = 0, mobility = 0;
  for (int i = 0; i < 4 && c.vertices[i] >= 0; ++i) {
    approach += weights[i] * dot(velocity[c.vertices[i]], c.normal);
    if (c.vertices[i] < kCloth) mobility += weights[i] * weights[i];
  }
  if (approach >= 0 || mobility == 0) return;
  for (int i = 0; i < 4 && c.vertices[i] >= 0; ++i)
    if (tamis::Point& v = velocity[c.vertices[i]]; c.vertices[i] < kCloth)
      v = sum(v, -approach / mobility * weights[i], c.normal);
}

int main() {
  Vectors x;
  std::vector<tamis::Face> faces{{kCloth, kCloth + 1, kCloth + 2}};
  for (int v = 0; v < kCloth; ++v) {
    const int i = v / kSide, j = v % kSide;
    x.push_back({0.1 * i, 0.1 * j, 0.2 + 0.02 * i});
    if (i + 1 < kSide && j + 1 < kSide)
      faces.insert(faces.end(), {{v, v + kSide, v + 1}, {v + 1, v + kSide, v + kSide + 1}});
  }
  x.insert(x.end(), {{-9, -9, 0}, {9, -9, 0}, {0, 9, 0}});
  const Vectors rest = x;
  Vectors velocity(x.size(), tamis::Point{}), end = x;
  tamis::Detector detector(tamis::Mesh(kCloth + 3, faces));
  if (detector.has_intersection(x)) return 1;  // asked once: what begins apart stays apart

  for (int step = 0; step < 200; ++step) {
    for (int v = 0; v < kCloth; ++v) velocity[v][2] -= 9.81 * kStep;
    for (const auto& [a, b] : detector.mesh().edges()) {
      const auto now = sum(x[a], -1, x[b]), then = sum(rest[a], -1, rest[b]);
      const double pull = a < kCloth ? kStep * kSpring * (1 - std::sqrt(dot(then, then) / dot(now, now))) : 0;
      velocity[a] = sum(velocity[a], -pull, now), velocity[b] = sum(velocity[b], pull, now);
    }
    for (int round = 0; round < 4; ++round) {
      for (int v = 0; v < kCloth; ++v) end[v] = sum(x[v], kStep, velocity[v]);
      for (const tamis::Contact& c : detector.contacts({x, end}, {.min_separation = kThickness})) respond(c, velocity);
    }
    const Vectors to = detector.truncate({x, end}).positions;  // whatever the response left undone
    for (int v = 0; v < kCloth; ++v) velocity[v] = sum({}, 1 / kStep, sum(to[v], -1, x[v]));
    x = to;
  }
  const double highest = (*std::max_element(x.begin(), x.end(), [](auto& a, auto& b) { return a[2] < b[2]; }))[2];
  std::printf("the cloth lies on the ground: %s\n", highest < 5 * kThickness ? "yes" : "no");
  std::printf("intersections: %zu\n", detector.intersections(x).size());
}
