#include "benchmarks/stages/workload.hpp"

#include <cstdlib>
#include <filesystem>
#include <span>

#include "files/mesh/mesh_file.hpp"
#include "scenes/scene_list.hpp"

namespace tamis::bench {
namespace {

namespace fs = std::filesystem;

/// Enough buffers to fill the caches, few enough to keep in memory.
constexpr std::size_t kMostBuffers = 256;

void keep(Buffers& buffers, const PairBuffer& pairs) {
  if (pairs.count > 0 && buffers.size() < kMostBuffers) buffers.push_back(std::make_unique<PairBuffer>(pairs));
}

std::unique_ptr<Workload> from_frames(const std::string& name, const fs::path& start, const fs::path& end) {
  io::MeshFile first = io::read_mesh(start), second = io::read_mesh(end);
  std::vector<Point> from = first.positions;
  return std::make_unique<Workload>(name, io::mesh_of(std::move(first)), std::move(from), std::move(second.positions));
}

}  // namespace

Workload::Workload(std::string name, Mesh mesh, std::vector<Point> start, std::vector<Point> end)
    : name_(std::move(name)),
      mesh_(std::move(mesh)),
      start_(std::move(start)),
      end_(std::move(end)),
      kernels_(tamis::kernels(Isa::best)) {
  motion_.assign(step(), mesh_.points(), {kSeparation});
  points_.set_features(mesh_.points());
  edges_.set_features(mesh_.edges());
  faces_.set_features(mesh_.faces());
  for (BlockTree* tree : trees()) tree->build(motion_, {}, kernels_.bound_leaf);
  vf_ = inputs_of(PairKind::vertex_face);
  ee_ = inputs_of(PairKind::edge_edge);
}

StageInputs Workload::inputs_of(PairKind kind) const {
  StageInputs inputs;
  auto slab = std::make_unique<PairBuffer>(), filtered = std::make_unique<PairBuffer>();
  search(kind, [&](PairBuffer& pairs) {
    kernels_.of(kind).slab(motion_.view(), pairs, *slab);
    kernels_.of(kind).filter(motion_.view(), *slab, *filtered);
    keep(inputs.slab, pairs);
    keep(inputs.filter, *slab);
    keep(inputs.solve, *filtered);
    pairs.count = 0;
  });
  return inputs;
}

std::vector<PairPoints> Workload::points(const Buffers& buffers, std::size_t most) const {
  std::vector<PairPoints> all;
  for (const auto& buffer : buffers)
    for (int i = 0; i < buffer->count && all.size() < most; ++i) {
      PairPoints& points = all.emplace_back();
      for (std::size_t corner = 0; corner < 4; ++corner) {
        const auto vertex = static_cast<std::size_t>(buffer->corner[corner][i]);
        points.start[corner] = start_[vertex];
        points.end[corner] = end_[vertex];
      }
    }
  return all;
}

std::vector<PairMotion<double>> Workload::motions(PairKind kind, const Buffers& buffers, std::size_t most) const {
  std::vector<PairMotion<double>> all;
  for (const PairPoints& pair : points(buffers, most)) all.push_back(make_motion(kind, pair));
  return all;
}

std::vector<std::unique_ptr<Workload>> make_workloads() {
  constexpr Index kTriangles = 50000;
  std::vector<std::unique_ptr<Workload>> workloads;
  const scenes::Scene cloth = scenes::scene_by_name("folded-cloth", kTriangles, 1);
  workloads.push_back(std::make_unique<Workload>("folded-cloth", cloth.mesh(), cloth.start, cloth.end));
  const char* set = std::getenv("TAMIS_DATA");
  const fs::path frames = (set != nullptr ? fs::path(set) : fs::path(TAMIS_DEFAULT_DATA)) / "frames";
  const auto add = [&](const std::string& name, const char* start, const char* end) {
    if (fs::exists(frames / name / start))
      workloads.push_back(from_frames(name, frames / name / start, frames / name / end));
  };
  add("cloth-funnel", "227.ply", "228.ply");
  add("cloth-ball", "cloth_ball92.ply", "cloth_ball93.ply");
  return workloads;
}

}  // namespace tamis::bench
