// Tiny meshes of any shape: method tamis and method paper report what method brute does, and the three
// questions of a detector agree, also when asked a second time, of a
// hierarchy that was refitted. Step lengths are the same, bit for bit, by every method, also of a detector that has
// been asked before.
#include <algorithm>
#include <set>
#include <span>
#include <sstream>

#include "fuzz/moving_points.hpp"
#include "fuzz/require.hpp"
#include "support/yardstick/methods.hpp"
#include "tamis/tamis.hpp"

namespace tamis::fuzz {

using yardstick::Method;
namespace {

struct MovingMesh {
  Mesh mesh;
  MovingPoints points;
  Step step() const { return {points.start, points.end}; }
};

MovingMesh take_mesh(ByteSource& bytes) {
  const int vertices = 4 + bytes.below(13), faces = 1 + bytes.below(12);
  const auto vertex = [&] { return static_cast<Index>(bytes.below(vertices)); };
  std::vector<Face> face_list;
  for (int i = 0; i < faces; ++i) face_list.push_back({vertex(), vertex(), vertex()});
  std::vector<Edge> rods;
  for (int left = bytes.below(16) - 12; left > 0; --left) {
    const Index a = vertex(), b = vertex();
    if (a != b) rods.push_back({std::min(a, b), std::max(a, b)});
  }
  std::vector<Index> loose_points;
  for (int left = bytes.below(16) - 12; left > 0; --left) loose_points.push_back(vertex());
  Mesh mesh(vertices, std::move(face_list), rods, std::move(loose_points));
  MovingPoints points = take_points(bytes, static_cast<std::size_t>(vertices));
  place(bytes, points);
  return {std::move(mesh), std::move(points)};
}

using Name = std::tuple<PairKind, std::array<Index, 4>>;
using Names = std::set<Name>;

Names names_of(std::span<const Contact> contacts) {
  Names names;
  for (const Contact& c : contacts) names.insert({c.kind, c.vertices});
  return names;
}

std::string text_of(const Names& names) {
  std::ostringstream out;
  for (const auto& [kind, v] : names)
    out << (kind == PairKind::vertex_face ? "vf " : "ee ") << v[0] << ' ' << v[1] << ' ' << v[2] << ' ' << v[3] << '\n';
  return out.str();
}

std::string text_of(const MovingMesh& m) {
  std::ostringstream out;
  out << std::hexfloat;
  for (std::size_t i = 0; i < m.points.start.size(); ++i) {
    out << "v " << i;
    for (const Point& p : {m.points.start[i], m.points.end[i]}) out << "  " << p[0] << ' ' << p[1] << ' ' << p[2];
    out << '\n';
  }
  for (const Face& f : m.mesh.faces()) out << "f " << f[0] << ' ' << f[1] << ' ' << f[2] << '\n';
  for (const Edge& e : m.mesh.edges()) out << "e " << e[0] << ' ' << e[1] << '\n';
  return out.str();
}

yardstick::Options options_of(Method method, double separation) {
  yardstick::Options options;
  options.method = method;
  options.min_separation = separation;
  options.threads = 1;
  return options;
}

void check_questions(const MovingMesh& m, Detector& detector, const Names& names) {
  const auto describe = [&] { return text_of(m); };
  const EarliestContact earliest = detector.earliest(m.step());
  require(earliest.contact.has_value() == !names.empty(), "earliest and contacts differ", describe);
  require(detector.is_free(m.step()) == names.empty(), "is_free and contacts differ", describe);
  (void)detector.contacts({m.points.end, m.points.start});
  require(names_of(detector.contacts(m.step())) == names, "an earlier question changes the answer", describe);
}

void check(const MovingMesh& m, double separation) {
  Detector brute = yardstick::make_detector(m.mesh, options_of(Method::brute, separation));
  const Names expected = names_of(brute.contacts(m.step()));
  Detector detector = yardstick::make_detector(m.mesh, options_of(Method::tamis, separation));
  const Names found = names_of(detector.contacts(m.step()));
  require(found == expected, "the methods differ",
          [&] { return text_of(m) + "brute:\n" + text_of(expected) + "tamis:\n" + text_of(found); });
  check_questions(m, detector, found);
}

bool are_same(const SafeStep& a, const SafeStep& b) {
  const bool same_pair = a.pair.has_value() == b.pair.has_value() &&
                         (!a.pair || (a.pair->kind == b.pair->kind && a.pair->vertices == b.pair->vertices));
  return a.toi_lower == b.toi_lower && a.toi_upper == b.toi_upper && same_pair;
}

void check_step_lengths(const MovingMesh& m, double fraction, double separation) {
  const auto options = [&](Method method) { return options_of(method, separation); };
  const SafeStep truth = yardstick::make_detector(m.mesh, options(Method::brute)).safe_step(m.step(), fraction);
  Detector detector = yardstick::make_detector(m.mesh, options(Method::tamis));
  const SafeStep found = detector.safe_step(m.step(), fraction);
  const auto describe = [&] { return text_of(m) + "fraction " + std::to_string(fraction); };
  require(are_same(found, truth), "step lengths differ", describe);
  require(0 <= found.toi_lower && found.toi_lower <= found.toi_upper && found.toi_upper <= 1, "no bracket of a step",
          describe);
  require(found.toi_lower <= detector.earliest(m.step()).toi_upper, "a step length beyond the first contact", describe);
  (void)detector.safe_step({m.points.end, m.points.start}, fraction);
  require(are_same(detector.safe_step(m.step(), fraction), truth), "an earlier question changes a step length",
          describe);
}

}  // namespace
}  // namespace tamis::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tamis::fuzz;
  ByteSource bytes({data, size});
  const int choice = bytes.below(8);
  const double separation = choice < 6 ? 0 : std::ldexp(1 + bytes.below(16), -bytes.below(24));
  const MovingMesh mesh = take_mesh(bytes);
  check(mesh, separation);
  check_step_lengths(mesh, (1 + bytes.below(255)) / 256.0, separation);
  return 0;
}
