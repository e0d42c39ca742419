#include "c/motions.hpp"

#include "c/poses.hpp"

namespace tamis::c {
namespace {

std::vector<BodyMotion> deforming(const tamis_motions& given) {
  if (given.vertex_count < 0)
    throw InvalidStep("vertex_count is " + std::to_string(given.vertex_count) + ": give the vertices of the shape");
  const auto vertices = static_cast<std::size_t>(given.vertex_count);
  product(given.count, vertices, "count");
  std::vector<BodyMotion> motions;
  const double *start = array(given.start, vertices, "start"), *end = array(given.end, vertices, "end");
  for (std::size_t i = 0; i < given.count; ++i, start += 3 * vertices, end += 3 * vertices)
    motions.emplace_back(Deforming{point_rows(start, vertices, "start"), point_rows(end, vertices, "end")});
  return motions;
}

std::vector<BodyMotion> rigid(const tamis_motions& given) {
  product(given.count, given.links_of_each, "links_of_each");
  std::vector<BodyMotion> motions;
  for (std::size_t i = 0; i < given.count; ++i)
    motions.emplace_back(Rigid{chain_of(given.links + i * given.links_of_each, given.links_of_each)});
  return motions;
}

std::vector<BodyMotion> still(const tamis_motions& given) {
  std::vector<BodyMotion> motions;
  for (std::size_t i = 0; i < given.count; ++i)
    motions.emplace_back(given.poses ? Static{pose_of(given.poses[i])} : Static{});
  return motions;
}

}  // namespace

std::vector<BodyMotion> motions_of(const tamis_motions& given) {
  check_count(given.count, "count");
  const bool deforms = given.start || given.end;
  if ((given.poses != nullptr) + (given.links != nullptr) + deforms > 1)
    throw InvalidArgument(
        "motions has more than one of poses, links, start and end: give one and leave the others NULL");
  if (!given.links && given.links_of_each != 0)
    throw InvalidArgument("links_of_each is " + std::to_string(given.links_of_each) +
                          " and links is NULL: give links, or leave it 0");
  if (!deforms && given.vertex_count != 0)
    throw InvalidArgument("vertex_count is " + std::to_string(given.vertex_count) +
                          " and start is NULL: give start and end, or leave it 0");
  return deforms ? deforming(given) : given.links ? rigid(given) : still(given);
}

}  // namespace tamis::c
