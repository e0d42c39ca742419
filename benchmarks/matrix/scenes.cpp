#include "matrix/scenes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <string_view>

#include "files/mesh/mesh_file.hpp"
#include "matrix/kinds/kinds.hpp"
#include "scenes/generators/generators.hpp"
#include "tamis/error.hpp"

namespace tamis::matrix {
namespace {

struct Recorded {
  std::string_view name, start, end;
  double triangles, crowding = 1;
};

constexpr std::array kRecorded{
    Recorded{"cloth-ball", "cloth-ball/cloth_ball92.ply", "cloth-ball/cloth_ball93.ply", 92230, 3},
    Recorded{"cloth-funnel", "cloth-funnel/227.ply", "cloth-funnel/228.ply", 18484},
    Recorded{"armadillo-rollers", "armadillo-rollers/326.ply", "armadillo-rollers/327.ply", 24242},
    Recorded{"kick-62-63", "kick/frame_62.ply", "kick/frame_63.ply", 25472},
    Recorded{"kick-63-64", "kick/frame_63.ply", "kick/frame_64.ply", 25472},
    Recorded{"kick-64-65", "kick/frame_64.ply", "kick/frame_65.ply", 25472},
    Recorded{"kick-62-64", "kick/frame_62.ply", "kick/frame_64.ply", 25472},
    Recorded{"kick-63-65", "kick/frame_63.ply", "kick/frame_65.ply", 25472},
    Recorded{"kick-62-65", "kick/frame_62.ply", "kick/frame_65.ply", 25472},
};

struct Generated {
  std::string_view name;
  scenes::Scene (*make)(Index triangles, std::uint64_t seed);
  double crowding = 1;
  Index fewest_triangles = 0;  ///< asked for fewer, the generator makes the same scene
  bool parts_groups = false;
};

constexpr std::array kGenerated{
    Generated{"folded-cloth", scenes::folded_cloth},
    Generated{"colliding-bodies", scenes::colliding_bodies, 1, 100},
    Generated{"rod", scenes::rod, 15},
    Generated{"soup", scenes::soup},
    Generated{"stacked-boxes", scenes::stacked_boxes},
    Generated{"twisted-rods", scenes::twisted_rods},
    Generated{"graded-sheets", graded_sheets},
    Generated{"fast-body", fast_body, 1, 100},
    Generated{"spinning-bodies", spinning_bodies, 1, 100},
    Generated{"fast-together", fast_together},
    Generated{"bodies-without-self-contact", scenes::colliding_bodies, 1, 100, true},
    Generated{"passing-bodies", passing_bodies, 1, 100},
    Generated{"scattered-groups", scattered_groups, 1, 100, true},
};

/// Kinds of one size each: bad input, and steps as simulations make them.
struct OfOneSize {
  std::string_view name;
  scenes::Scene (*make)(Index triangles, std::uint64_t seed);
  Index triangles;
  bool is_of_two_sizes = false;
};

constexpr std::array kOfOneSize{
    // All triangles pass all others within 1e-300 of the step: each pair needs exact algebra.
    OfOneSize{"huge-beside-tiny", huge_beside_tiny, 12},
    OfOneSize{"infinite-ratio", infinite_ratio, 24},
    OfOneSize{"one-flies-through", one_flies_through, 1000},
    OfOneSize{"sleeve-on-arm", sleeve_on_arm, 3000},
    OfOneSize{"shell-on-core", shell_on_core, 3000},
    OfOneSize{"cloth-through-ring", cloth_through_ring, 3000},
    OfOneSize{"ball-through-curtain", ball_through_curtain, 3000},
    OfOneSize{"chain", chain, 3000},
    OfOneSize{"rope-on-post", rope_on_post, 3000},
    OfOneSize{"hair", hair, 3000},
    OfOneSize{"felt", felt, 3000},
    OfOneSize{"drum-of-grains", drum_of_grains, 3000},
    OfOneSize{"vehicle-in-city", vehicle_in_city, 3000},
    OfOneSize{"exploding-cloth", exploding_cloth, 300},
    OfOneSize{"body-fallen-off", body_fallen_off, 3000},
    OfOneSize{"vertex-flies-off", vertex_flies_off, 3000},
    OfOneSize{"cloth-on-terrain", cloth_on_terrain, 9000, true},
    OfOneSize{"polygons-in-plane", polygons_in_plane, 3000},
};

struct Size {
  std::string_view name;
  Index triangles;
};
constexpr std::array kSizes{Size{"12", 12}, Size{"100", 100}, Size{"1000", 1000}, Size{"20k", 20000},
                            Size{"300k", 300000}};
constexpr std::uint64_t kSceneSeed = 1;

std::filesystem::path frames() {
  const char* set = std::getenv("TAMIS_DATA");
  return std::filesystem::path(set ? set : TAMIS_MATRIX_DATA) / "frames";
}

std::filesystem::path start_of(const Recorded& scene) { return frames() / scene.start; }
bool is_here(const Recorded& scene) { return std::filesystem::exists(start_of(scene)); }

scenes::Scene read(const Recorded& recorded) {
  io::MeshFile first = io::read_mesh(start_of(recorded)), second = io::read_mesh(frames() / recorded.end);
  io::require_same_mesh(first, std::string(recorded.start), second, std::string(recorded.end));
  scenes::Scene scene;
  scene.start = std::move(first.positions);
  scene.end = std::move(second.positions);
  scene.faces = std::move(first.faces);
  scene.loose_edges = std::move(first.loose_edges);
  scene.loose_points = std::move(first.loose_points);
  return scene;
}

std::string sized(const Generated& kind, const Size& size) { return fmt::format("{}-{}", kind.name, size.name); }

}  // namespace

const std::vector<SceneName>& scene_names() {
  static const std::vector<SceneName> all = [] {
    std::vector<SceneName> names;
    for (const Recorded& scene : kRecorded)
      names.push_back({std::string(scene.name), scene.triangles, scene.crowding, is_here(scene)});
    for (const Generated& kind : kGenerated)
      for (const Size& size : kSizes)
        if (size.triangles >= kind.fewest_triangles)
          names.push_back({sized(kind, size), double(size.triangles), kind.crowding, true, kind.parts_groups});
    for (const OfOneSize& kind : kOfOneSize)
      names.push_back({std::string(kind.name), double(kind.triangles), 1, true, false, kind.is_of_two_sizes});
    return names;
  }();
  return all;
}

scenes::Scene load_scene(const std::string& name) {
  for (const Recorded& scene : kRecorded)
    if (scene.name == name) return read(scene);
  for (const Generated& kind : kGenerated)
    for (const Size& size : kSizes)
      if (sized(kind, size) == name) return kind.make(size.triangles, kSceneSeed);
  for (const OfOneSize& kind : kOfOneSize)
    if (kind.name == name) return kind.make(kind.triangles, kSceneSeed);
  throw InvalidOptions(fmt::format("the matrix has no scene '{}'", name));
}

}  // namespace tamis::matrix
