#include "files/motion/motion.hpp"

#include <algorithm>

#include "files/error.hpp"
#include "files/mesh/frames.hpp"
#include "files/mesh/mesh_file.hpp"
#include "files/motion/mesh_frames.hpp"
#include "files/motion/point_cache.hpp"

namespace tamis::io {
namespace {

[[noreturn]] void refuse_for_mesh(const std::filesystem::path& cache) {
  throw FileError(cache.string(), "",
                  "a point cache has positions and no faces: give it together with one mesh file, "
                  "as in mesh.obj cache.pc2");
}

}  // namespace

std::vector<std::filesystem::path> MotionFiles::all() const {
  std::vector<std::filesystem::path> files = meshes;
  if (!cache.empty()) files.push_back(cache);
  return files;
}

MotionFiles motion_files(const std::vector<std::string>& names) {
  MotionFiles files{moving_files(names), {}};
  const auto caches = std::stable_partition(files.meshes.begin(), files.meshes.end(),
                                            [](const auto& path) { return !is_point_cache_name(path); });
  const auto count = files.meshes.end() - caches;
  if (count == 0) return files;
  files.cache = *caches;
  files.meshes.erase(caches, files.meshes.end());
  if (count > 1 || files.meshes.size() > 1) refuse_for_mesh(files.cache);
  return files;
}

std::unique_ptr<audit::FrameSource> open_motion(const MotionFiles& files, GivenMesh given) {
  if (files.cache.empty()) return std::make_unique<MeshFrames>(files.meshes, std::move(given.objects));
  if (!given.mesh && files.meshes.empty()) refuse_for_mesh(files.cache);
  if (!given.mesh)
    given.mesh =
        std::make_shared<audit::AuditedMesh>(mesh_of(read_mesh(files.meshes.front())), std::move(given.objects));
  return std::make_unique<PointCache>(files.cache, std::move(given.mesh));
}

}  // namespace tamis::io
