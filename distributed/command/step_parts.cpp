#include "distributed/command/step_parts.hpp"

#include <numeric>
#include <optional>

#include "command/step_files.hpp"
#include "distributed/command/ply_part.hpp"
#include "distributed/src/agreement.hpp"
#include "files/scale_step.hpp"

namespace tamis::distributed {
namespace {

template <class T>
std::vector<T> block_of(const std::vector<T>& all, const Block& block) {
  const auto at = [&](std::uint64_t row) { return all.begin() + static_cast<std::ptrdiff_t>(row); };
  return {at(block.first_of(all.size())), at(block.last_of(all.size()))};
}

std::vector<Index> numbers_of(const Block& block, std::uint64_t vertices) {
  std::vector<Index> numbers(block.last_of(vertices) - block.first_of(vertices));
  std::iota(numbers.begin(), numbers.end(), static_cast<Index>(block.first_of(vertices)));
  return numbers;
}

bool is_one_mesh(const PlyPart& a, const PlyPart& b) {
  return a.vertices == b.vertices && a.faces == b.faces && a.triangles == b.triangles;
}

std::optional<StepParts> read_blocks(const std::string& start, const std::string& end, const Block& block) {
  std::optional<PlyPart> first = read_ply_part(start, block);
  if (!first || first->faces == 0) return {};
  std::optional<PlyPart> second = read_ply_part(end, block);
  if (!second || !is_one_mesh(*first, *second)) return {};
  return StepParts{{numbers_of(block, first->vertices), std::move(first->triangles), {}, {}},
                   std::move(first->positions),
                   std::move(second->positions),
                   first->vertices,
                   first->faces};
}

StepParts read_whole(const std::string& start, const std::string& end, const Block& block) {
  const io::MeshFile first = cli::read_with_notes(start), second = cli::read_with_notes(end);
  io::require_same_mesh(first, start, second, end);
  return {{numbers_of(block, first.positions.size()), block_of(first.faces, block), block_of(first.loose_edges, block),
           block_of(first.loose_points, block)},
          block_of(first.positions, block),
          block_of(second.positions, block),
          first.positions.size(),
          first.faces.size()};
}

}  // namespace

StepParts read_step_parts(Communicator& communicator, const std::string& start, const std::string& end, double scale) {
  const Block block{static_cast<std::uint64_t>(communicator.rank()), static_cast<std::uint64_t>(communicator.size())};
  std::optional<StepParts> parts;
  together(communicator, [&] { parts = read_blocks(start, end, block); });
  const bool all_have = !communicator.any(!parts);
  together(communicator, [&] {
    if (!all_have) parts = read_whole(start, end, block);
    io::scale_step(parts->start, parts->end, scale);
  });
  return std::move(*parts);
}

}  // namespace tamis::distributed
