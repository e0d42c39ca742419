// tamis_same_bits [ISA...]: a hash of every bit of every contact of the generated scenes and of the recorded frames,
// one line each; nonzero if two of the instruction sets named (default: best) give different ones, 77 if one is not
// here.
#include <cstdio>
#include <cstring>
#include <span>
#include <string>
#include <vector>

#include "files/mesh/mesh_file.hpp"
#include "scenes/scene_list.hpp"
#include "support/data_folder.hpp"
#include "tamis/detector.hpp"
#include "tamis/error.hpp"

namespace tamis::test {
namespace {

/// FNV-1a.
class Hash {
 public:
  template <class T>
  void add(const T& value) {
    unsigned char bytes[sizeof(T)];
    std::memcpy(bytes, &value, sizeof(T));
    for (const unsigned char byte : bytes) value_ = (value_ ^ byte) * 0x100000001b3;
  }
  unsigned long long value() const { return value_; }

 private:
  unsigned long long value_ = 0xcbf29ce484222325;
};

void add(Hash& hash, const Contact& c) {
  hash.add(static_cast<int>(c.kind));
  hash.add(static_cast<int>(c.certainty));
  for (const Index v : c.vertices) hash.add(v);
  for (const double x : {c.toi_lower, c.toi_upper, c.u, c.v}) hash.add(x);
  for (const double x : c.normal) hash.add(x);
}

/// All contacts, then the first, then a step length: warm, from one detector.
std::string answers(const Mesh& mesh, const Step& step, Isa isa) {
  Options options;
  options.isa = isa;
  Detector detector(mesh, options);
  Hash hash;
  std::span<const Contact> contacts = detector.contacts(step);
  const std::size_t count = contacts.size();
  for (const Contact& c : contacts) add(hash, c);
  const EarliestContact first = detector.earliest(step);
  hash.add(first.toi_lower);
  hash.add(first.toi_upper);
  if (first.contact) add(hash, *first.contact);
  const SafeStep safe = detector.safe_step(step, 0.2);
  hash.add(safe.toi_lower);
  hash.add(safe.toi_upper);
  char line[64];
  std::snprintf(line, sizeof line, "%zu contacts, hash %016llx", count, hash.value());
  return line;
}

/// Prints the answers' line; false if the instruction sets differ.
bool compare(const std::string& name, const Mesh& mesh, const Step& step, const std::vector<Isa>& isas) {
  bool are_equal = true;
  const std::string first = answers(mesh, step, isas[0]);
  for (std::size_t i = 1; i < isas.size(); ++i) are_equal &= answers(mesh, step, isas[i]) == first;
  std::printf("%-24s %s%s\n", name.c_str(), first.c_str(), are_equal ? "" : "  NOT THE SAME");
  return are_equal;
}

bool compare_scenes(const std::vector<Isa>& isas) {
  bool are_equal = true;
  for (const scenes::Recipe& recipe : scenes::recipes()) {
    const scenes::Scene scene = recipe.make(recipe.scales ? 2000 : 300, 1);
    are_equal &= compare(std::string(recipe.name), scene.mesh(), scene.step(), isas);
  }
  return are_equal;
}

bool compare_frames(const std::vector<Isa>& isas) {
  struct Frames {
    const char *start, *end;
  };
  constexpr Frames kFrames[] = {{"cloth-funnel/227.ply", "cloth-funnel/228.ply"},
                                {"kick/frame_62.ply", "kick/frame_63.ply"},
                                {"kick/frame_63.ply", "kick/frame_64.ply"},
                                {"kick/frame_64.ply", "kick/frame_65.ply"},
                                {"cloth-ball/cloth_ball92.ply", "cloth-ball/cloth_ball93.ply"}};
  const auto folder = data_folder();
  if (folder.empty()) std::printf("recorded frames skipped: %s\n", kNoData);
  bool are_equal = true;
  for (const Frames& frames : kFrames) {
    if (folder.empty() || !std::filesystem::exists(folder / "frames" / frames.start)) continue;
    const io::MeshFile start = io::read_mesh(folder / "frames" / frames.start),
                       end = io::read_mesh(folder / "frames" / frames.end);
    are_equal &= compare(frames.start, io::mesh_of(start), {start.positions, end.positions}, isas);
  }
  return are_equal;
}

int run(const std::vector<std::string>& names) {
  std::vector<Isa> isas;
  for (const std::string& name : names) {
    isas.push_back(isa_from_name(name));
    Options options;
    options.isa = isas.back();
    try {
      const Detector is_here(Mesh(1, {}, {}, {0}), options);
    } catch (const InvalidOptions& error) {
      std::printf("skipped: %s\n", error.what());
      return 77;
    }
  }
  if (isas.empty()) isas.push_back(Isa::best);
  const bool scenes_are_equal = compare_scenes(isas), frames_are_equal = compare_frames(isas);
  return scenes_are_equal && frames_are_equal ? 0 : 1;
}

}  // namespace
}  // namespace tamis::test

int main(int argc, char** argv) { return tamis::test::run({argv + 1, argv + argc}); }
