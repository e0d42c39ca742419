#include "api/validate.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

#include "api/enum_names.hpp"
#include "api/stored.hpp"
#include "numbers/finite.hpp"
#include "numbers/in_parts.hpp"
#include "numbers/number_text.hpp"
#include "search/topology/at.hpp"
#include "tamis/error.hpp"

namespace tamis {
namespace {

void validate_threads(int threads) {
  if (threads < 0)
    throw InvalidOptions("threads is " + std::to_string(threads) + ": give 0 (all) or a positive number");
}

void check_tolerance(double tolerance) {
  if (!(tolerance > 0 && tolerance <= 1))
    throw InvalidOptions("the tolerance of brackets is " + number_text(tolerance) +
                         ": give a fraction of the step, > 0 and <= 1");
}

void validate(const PairFilter& filter, const Mesh& mesh) {
  const auto n = at(filter.group_count);
  if (filter.rings < 1)
    throw InvalidOptions("rings is " + std::to_string(filter.rings) +
                         ": give at least 1, which skips pairs with a common vertex");
  if (filter.group_count <= 0)
    throw InvalidOptions("group_count is " + std::to_string(filter.group_count) + ": give at least one group");
  const std::uint64_t entries = std::uint64_t{n} * n;  // may exceed std::size_t of 32 bits
  if (!filter.groups_may_touch.empty() && filter.groups_may_touch.size() != entries)
    throw InvalidOptions("groups_may_touch has " + std::to_string(filter.groups_may_touch.size()) +
                         " entries: give group_count^2 = " + std::to_string(entries));
  for (std::size_t a = 0; a < n && !filter.groups_may_touch.empty(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      if (!filter.groups_may_touch[a * n + b] != !filter.groups_may_touch[b * n + a])
        throw InvalidOptions("groups_may_touch differs for (" + std::to_string(a) + ", " + std::to_string(b) +
                             ") and its mirror image: make it symmetric");
  if (filter.group_of_vertex.empty()) {
    if (n == 1 && filter.groups_may_touch.empty()) return;
    throw InvalidOptions(
        "group_of_vertex is empty, but group_count or groups_may_touch are set: give one group a vertex");
  }
  if (filter.group_of_vertex.size() != at(mesh.vertex_count()))
    throw InvalidOptions("group_of_vertex has " + std::to_string(filter.group_of_vertex.size()) + " entries for " +
                         std::to_string(mesh.vertex_count()) + " vertices: give one group a vertex, or none");
  auto point = mesh.points().begin();
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    const Index group = filter.group_of_vertex[at(v)];
    const bool is_point = point != mesh.points().end() && *point == v;
    if (is_point) ++point;
    if (group < (is_point ? 0 : -1) || group >= filter.group_count)
      throw InvalidOptions("vertex " + std::to_string(v) + " is in group " + std::to_string(group) +
                           ", but group_count is " + std::to_string(n) +
                           ": give groups in [0, group_count), or set group_count to their number");
  }
}

[[noreturn]] void refuse(const char* end_of_step, Index vertex, double coordinate, const char* what) {
  throw InvalidStep("vertex " + std::to_string(vertex) + " at the " + end_of_step + " of the step has the coordinate " +
                    number_text(coordinate) + what);
}

bool is_distance(double distance) { return std::isfinite(distance) && distance >= 0; }

void check_kept(double keep, bool is_enough, const char* least) {
  if (!(is_enough && keep < 1))
    throw InvalidOptions("keep is " + number_text(keep) + ": give the fraction of its distance that each pair keeps, " +
                         least + " and < 1");
}

void validate_layout(const Positions& positions, const char* what) {
  if (positions.count() < 0)
    throw InvalidStep(std::string(what) + " has more than 2^31 - 1 positions: give one row a vertex");
  if (positions.count() > 0 && (!positions.data() || positions.stride() < 3))
    throw InvalidStep(
        std::string(what) +
        " is not an n x 3 array of doubles, row by row: give three columns next to each other (of Eigen a "
        "RowMajor matrix or a Matrix3Xd, or points_of(matrix); of flat numbers Positions(data, vertices)) and a stride "
        "of at least 3");
}

}  // namespace

void validate_layout(const Step& step) {
  if (step.start.count() != step.end.count())
    throw InvalidStep("the step has " + std::to_string(step.start.count()) + " positions at its start and " +
                      std::to_string(step.end.count()) + " at its end: give as many");
  validate_layout(step.start, "the start of the step");
  validate_layout(step.end, "the end of the step");
}

void validate(const Positions& positions, const Mesh& mesh, const char* what) {
  validate_layout(positions, what);
  if (positions.count() != mesh.vertex_count())
    throw InvalidStep(std::string(what) + " has " + std::to_string(positions.count()) + " positions, the mesh " +
                      std::to_string(mesh.vertex_count()) + " vertices: give one row a vertex");
  const auto is_valid = [&](Index v) { return is_finite(positions[v]); };
  if (all_in_parts(mesh.points(), kVerticesPerPart, is_valid)) return;
  throw InvalidStep("vertex " + std::to_string(*std::ranges::find_if_not(mesh.points(), is_valid)) + " in " + what +
                    " has a coordinate that is not finite: give finite positions");
}

void validate(const Options& options, const Mesh& mesh) {
  validate_is_named(options.isa, "instruction set");
  validate_threads(options.threads);
  validate_distance(options.min_separation, "min_separation");
  validate(options.filter, mesh);
  if (!options.radii.empty() && options.radii.size() != at(options.filter.group_count))
    throw InvalidOptions("radii has " + std::to_string(options.radii.size()) + " entries for " +
                         std::to_string(options.filter.group_count) +
                         " groups: give one radius a group, or none (group_of_vertex and group_count make groups)");
  const auto refused = std::ranges::find_if_not(options.radii, is_distance);
  if (refused != options.radii.end())
    validate_distance(*refused, "the radius of group " + std::to_string(refused - options.radii.begin()));
}

void validate(const PairOptions& options) {
  validate_distance(options.min_separation, "the minimum separation");
  if (!(options.latest >= 0 && options.latest <= 1))
    throw InvalidOptions("the latest time of interest is " + number_text(options.latest) +
                         ": give a fraction of the step, >= 0 and <= 1");
  check_tolerance(options.tolerance);
  validate_threads(options.threads);
  if (options.isa != Isa::best) validate_is_named(options.isa, "instruction set");  // the default needs no look-up
}

void validate_distance(double distance, std::string_view what) {
  if (!is_distance(distance))
    throw InvalidOptions(std::string(what) + " is " + number_text(distance) + ": give a finite distance >= 0");
}

void validate(const Separations& separations) {
  const double radius = separations.largest_radius();
  if (!std::isfinite(2 * radius + separations.fixed))
    throw InvalidOptions("a separation of " + number_text(separations.fixed) + " and twice the radius " +
                         number_text(radius) + " are together more than any double: give smaller ones");
}

void validate(const Step& step, const Mesh& mesh) {
  validate(step.start, mesh, "the start of the step");
  validate(step.end, mesh, "the end of the step");
}

void validate_stored(const Step& step, const Mesh& mesh, StoredType stored) {
  for (const Index v : mesh.points())
    for (std::size_t k = 0; k < 3; ++k) {
      const double start = step.start[v][k], end = step.end[v][k];
      if (rounded(start, stored) != start)
        refuse("start", v, start, ", which is not float32: give the start as it is stored, in numbers of float32");
      if (!std::isfinite(rounded(end, stored)))
        refuse("end", v, end, ", which is beyond all numbers of float32: give positions below 3.4e38");
    }
}

void validate_kept(double keep) { check_kept(keep, keep >= 0, ">= 0"); }
void validate_kept_of_truncate(double keep) { check_kept(keep, keep > 0, "> 0"); }

void validate(const QueryOptions& options) {
  if (options.min_separation) validate_distance(*options.min_separation, "the minimum separation");
  validate_is_named(options.at_start, "at_start mode");
}

void validate(const PathOptions& options) {
  validate(QueryOptions{options.min_separation, options.at_start});
  check_tolerance(options.tolerance);
}

}  // namespace tamis
