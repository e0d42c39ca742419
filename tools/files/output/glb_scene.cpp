#include "files/output/glb_scene.hpp"

namespace tamis::io {
namespace {

constexpr int kMeshMaterial = 0;
constexpr int kContactMaterial = 1;

Json materials() {
  return Json::array(
      {{{"name", "mesh"},
        {"doubleSided", true},
        {"pbrMetallicRoughness",
         {{"baseColorFactor", {0.27, 0.38, 0.56, 1.0}}, {"metallicFactor", 0.0}, {"roughnessFactor", 0.8}}}},
       {{"name", "contacts"}, {"extensions", {{"KHR_materials_unlit", Json::object()}}}}});
}

}  // namespace

Json GlbScene::add_motion(const MovingPoints& points) {
  std::vector<FloatPoint> start(points.start.size()), way(points.start.size());
  for (std::size_t i = 0; i < start.size(); ++i)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      start[i][axis] = static_cast<float>(points.start[i][axis] - middle_[axis]);
      way[i][axis] = static_cast<float>(points.end[i][axis] - points.start[i][axis]);
    }
  Json motion;
  motion["attributes"]["POSITION"] = buffer_.add_points(start);
  motion["targets"].push_back({{"POSITION", buffer_.add_points(way)}});
  return motion;
}

void GlbScene::add_indexed(Json& primitives, Json motion, GlbMode mode, std::span<const Index> indices) {
  if (indices.empty()) return;
  motion["mode"] = mode;
  motion["indices"] = buffer_.add_indices(indices);
  motion["material"] = kMeshMaterial;
  primitives.push_back(std::move(motion));
}

void GlbScene::add_coloured(Json& primitives, Json motion, GlbMode mode, std::span<const Colour> colours) {
  motion["mode"] = mode;
  motion["attributes"]["COLOR_0"] = buffer_.add_colours(colours);
  motion["material"] = kContactMaterial;
  primitives.push_back(std::move(motion));
}

void GlbScene::add_node(const char* name, Json primitives, Json extras) {
  Json mesh{{"name", name}, {"primitives", std::move(primitives)}};
  mesh["weights"].push_back(0.0);
  meshes_.push_back(std::move(mesh));
  nodes_.push_back({{"name", name}, {"mesh", meshes_.size() - 1}, {"translation", middle_}});
  if (!extras.is_null()) nodes_.back()["extras"] = std::move(extras);
}

std::string GlbScene::file() {
  constexpr std::array<float, 2> kWeights{0, 1};
  Json animation{{"name", "step"}};
  animation["samplers"].push_back(
      {{"input", buffer_.add_times(kWeights)}, {"output", buffer_.add_times(kWeights)}, {"interpolation", "LINEAR"}});
  Json scene;
  for (std::size_t node = 0; node < nodes_.size(); ++node) {
    animation["channels"].push_back({{"sampler", 0}, {"target", {{"node", node}, {"path", "weights"}}}});
    scene["nodes"].push_back(node);
  }
  Json gltf{{"asset", {{"version", "2.0"}, {"generator", "Tamis"}}}, {"scene", 0}};
  gltf["extensionsUsed"].push_back("KHR_materials_unlit");
  gltf["scenes"].push_back(std::move(scene));
  gltf["nodes"] = nodes_;
  gltf["meshes"] = meshes_;
  gltf["materials"] = materials();
  gltf["animations"].push_back(std::move(animation));
  return buffer_.file(std::move(gltf));
}

}  // namespace tamis::io
