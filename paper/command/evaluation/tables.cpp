#include "paper/command/evaluation/tables.hpp"

#include <fmt/format.h>

#include "files/atomic_file.hpp"

namespace tamis::lab {

double culled_part(std::uint64_t entering, std::uint64_t leaving) {
  return entering == 0 ? 0 : 1 - static_cast<double>(leaving) / static_cast<double>(entering);
}

void write_paper_table(const std::filesystem::path& folder, std::span<const SceneResult> results) {
  io::AtomicFile file(folder / "table1.csv");
  file.append(
      "scene,step,extrapolated,triangles,steps,all_steps,method,ms_a_frame,elementary_tests,false_pairs_left,contacts,"
      "missed\n");
  for (const SceneResult& r : results)
    for (const MethodResult& m : r.methods)
      file.append(fmt::format("{},{}x,{},{},{},{},{},{:.4f},{},{},{},{}\n", r.scene, r.factor, r.extrapolated ? 1 : 0,
                              r.triangles, r.steps, r.all_steps, m.method, r.milliseconds(m.method),
                              m.elementary_tests(), m.false_pairs(), m.contacts, m.missed));
  file.commit();
}

void write_paper_stages(const std::filesystem::path& folder, std::span<const SceneResult> results) {
  io::AtomicFile file(folder / "stages.csv");
  file.append("scene,step,method,stage,vf,ee\n");
  const auto append = [&](const SceneResult& r, const MethodResult& m) {
    for (const StageCount& s : m.stages)
      file.append(fmt::format("{},{}x,{},{},{},{}\n", r.scene, r.factor, m.method, s.name, s.vf, s.ee));
  };
  for (const SceneResult& r : results) {
    for (const MethodResult& m : r.methods) append(r, m);
    append(r, r.sieve);
  }
  file.commit();
}

}  // namespace tamis::lab
