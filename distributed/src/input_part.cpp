#include "distributed/src/input_part.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <string>

#include "distributed/src/agreement.hpp"
#include "distributed/src/partition/vertex_directory.hpp"
#include "tamis/error.hpp"

namespace tamis::distributed {
namespace {

constexpr Index kMostVertices = std::numeric_limits<Index>::max();
constexpr Index kNoGroup = -1;  ///< of vertices that no feature uses

Edge ascending(Index a, Index b) { return a < b ? Edge{a, b} : Edge{b, a}; }

void check_number(Index number, const std::string& who) {
  if (number < 0 || number >= kMostVertices)
    throw InvalidMesh(who + " names vertex " + std::to_string(number) + ": numbers must be in [0, 2^31 - 1)");
}

template <class Elements>
void check_numbers(const Elements& elements, const std::string& what) {
  for (std::size_t i = 0; i < elements.size(); ++i)
    for (const Index number : elements[i]) check_number(number, what + " " + std::to_string(i));
}

[[noreturn]] void refuse_group(const std::string& who, Index group, const PairFilter& filter) {
  throw InvalidOptions(who + " is in group " + std::to_string(group) + ", but group_count is " +
                       std::to_string(filter.group_count) +
                       ": give groups in [0, group_count), or set group_count to their number");
}

void check_groups(const PairFilter& filter, std::size_t rows) {
  const std::vector<Index>& groups = filter.group_of_vertex;
  if (!groups.empty() && groups.size() != rows)
    throw InvalidOptions("group_of_vertex has " + std::to_string(groups.size()) + " entries for " +
                         std::to_string(rows) + " vertices of this rank: give one group a vertex, or none");
  if (groups.empty() && rows > 0 && (filter.group_count > 1 || !filter.groups_may_touch.empty()))
    throw InvalidOptions(
        "group_of_vertex is empty, but group_count or groups_may_touch are set: give one group a vertex");
  for (std::size_t row = 0; row < groups.size(); ++row)
    if (groups[row] < kNoGroup || groups[row] >= filter.group_count)
      refuse_group("the vertex in row " + std::to_string(row), groups[row], filter);
}

void validate(const LocalMesh& mesh, const PairFilter& filter) {
  for (std::size_t row = 0; row < mesh.vertices.size(); ++row)
    check_number(mesh.vertices[row], "row " + std::to_string(row));
  check_numbers(mesh.faces, "face");
  check_numbers(mesh.loose_edges, "loose edge");
  for (std::size_t i = 0; i < mesh.loose_points.size(); ++i)
    check_number(mesh.loose_points[i], "loose point " + std::to_string(i));
  check_groups(filter, mesh.vertices.size());
}

/// The largest number plus 1.
std::uint64_t end_of_numbers(const LocalMesh& mesh) {
  std::uint64_t end = 0;
  const auto see = [&](Index number) { end = std::max(end, static_cast<std::uint64_t>(number) + 1); };
  std::ranges::for_each(mesh.vertices, see);
  for (const Face& face : mesh.faces) std::ranges::for_each(face, see);
  for (const Edge& edge : mesh.loose_edges) std::ranges::for_each(edge, see);
  std::ranges::for_each(mesh.loose_points, see);
  return end;
}

class InputPartMaker {
 public:
  InputPartMaker(Communicator& communicator, const LocalMesh& mesh, const PairFilter& filter)
      : communicator_(communicator), mesh_(mesh), filter_(filter) {}

  InputPart make() {
    together(communicator_, [&] { validate(mesh_, filter_); });
    part_.vertex_count = static_cast<Index>(communicator_.largest(end_of_numbers(mesh_)));
    part_.row_count = static_cast<Index>(mesh_.vertices.size());
    together(communicator_, [&] { mention_all(); });
    VertexDirectory directory(communicator_, part_.vertex_count);
    const DirectoryAnswer answer = directory.look_up(mentions_);
    together(communicator_, [&] { take_vertices(answer); });
    take_sample(directory.used_vertices(), answer.entries);
    take_elements(directory, answer.entries);
    if (communicator_.sum(part_.elements.elements.size()) == 0)
      throw InvalidMesh("the mesh has no face, no edge and no point on any rank: give at least one feature");
    return std::move(part_);
  }

 private:
  /// Makes one mention of each vertex that this rank gives or uses, by number.
  void mention_all() {
    std::vector<Mention> all;
    for (std::size_t row = 0; row < mesh_.vertices.size(); ++row)
      all.push_back({.number = mesh_.vertices[row],
                     .group = filter_.group_of_vertex.empty() ? 0 : filter_.group_of_vertex[row],
                     .is_given = true});
    for (const Face& face : mesh_.faces)
      for (const Index v : face) all.push_back({.number = v, .is_used = true, .is_covered = true});
    for (const Edge& edge : mesh_.loose_edges)
      for (const Index v : edge) {
        const bool is_edge = edge[0] != edge[1];
        all.push_back({.number = v, .is_used = true, .is_covered = is_edge, .is_on_loose_edge = is_edge});
      }
    for (const Index v : mesh_.loose_points) all.push_back({.number = v, .is_used = true});
    std::ranges::stable_sort(all, {}, &Mention::number);
    for (const Mention& mention : all)
      if (mentions_.empty() || mentions_.back().number != mention.number)
        mentions_.push_back(mention);
      else
        add_to(mentions_.back(), mention);
  }

  /// REQUIRES: mentions of rows are added first.
  static void add_to(Mention& mention, const Mention& other) {
    if (mention.is_given && other.is_given)
      throw InvalidMesh("vertex " + std::to_string(other.number) + " has two rows of positions: give it one");
    mention.is_used |= other.is_used;
    mention.is_covered |= other.is_covered;
    mention.is_on_loose_edge |= other.is_on_loose_edge;
  }

  void take_vertices(const DirectoryAnswer& answer) {
    for (std::size_t v = 0; v < mentions_.size(); ++v) {
      const Entry& entry = answer.entries[v];
      if (entry.home < 0)
        throw InvalidMesh("vertex " + std::to_string(entry.number) +
                          " is used, but no rank gives its position: list it in `vertices` of one");
      if (mentions_[v].is_given && mentions_[v].group != entry.group)
        throw InvalidOptions("vertex " + std::to_string(entry.number) + " is in group " +
                             std::to_string(mentions_[v].group) + ", on rank " + std::to_string(entry.home) +
                             " in group " + std::to_string(entry.group) + ": give it the same group everywhere");
      if (entry.is_used && entry.group == kNoGroup)
        refuse_group("vertex " + std::to_string(entry.number), entry.group, filter_);
      part_.elements.vertices.push_back({entry.number, entry.group, entry.home});
    }
    part_.row_of_vertex.assign(mentions_.size(), -1);
    for (std::size_t row = 0; row < mesh_.vertices.size(); ++row)
      part_.row_of_vertex[place_of(mentions_, mesh_.vertices[row])] = static_cast<Index>(row);
    share(answer.sharers);
  }

  void take_sample(const UsedVertices& used, const std::vector<Entry>& entries) {
    part_.used_count = used.count;
    const auto is_spoken_for = [&](std::size_t v) {
      return entries[v].home == communicator_.rank() && entries[v].is_used;
    };
    for (std::size_t v = 0; v < entries.size(); ++v)
      if (is_spoken_for(v)) part_.spoken_for.push_back(static_cast<Index>(v));
    for (const auto& [in_sample, number] : used.sample) {
      const std::size_t v = place_of(mentions_, number);
      if (v < entries.size() && entries[v].number == number && is_spoken_for(v))
        part_.sample.push_back({in_sample, static_cast<Index>(v)});
    }
  }

  void share(const std::vector<Sharer>& sharers) {
    for (const Sharer& sharer : sharers) {
      if (part_.lent.empty() || part_.lent.back().rank != sharer.rank) part_.lent.push_back({sharer.rank, {}});
      part_.lent.back().places.push_back(place_of(mentions_, sharer.number));
    }
    std::map<int, std::vector<std::size_t>> by_home;
    for (std::size_t v = 0; v < part_.elements.vertices.size(); ++v)
      by_home[part_.elements.vertices[v].home].push_back(v);
    by_home.erase(communicator_.rank());
    for (auto& [home, places] : by_home) part_.borrowed.push_back({home, std::move(places)});
  }

  /// Leaves out loose features that belong to larger ones: a search without the larger ones would take them for loose.
  void take_elements(VertexDirectory& directory, const std::vector<Entry>& entries) {
    std::vector<Index> points;
    const auto add_point = [&](Index v) {
      if (!entries[place_of(mentions_, v)].is_covered) points.push_back(v);
    };
    std::vector<Edge> edges;
    together(communicator_, [&] {
      for (const Edge& edge : mesh_.loose_edges)
        if (edge[0] == edge[1])
          add_point(edge[0]);
        else
          edges.push_back(ascending(edge[0], edge[1]));
      std::ranges::for_each(mesh_.loose_points, add_point);
    });
    const bool may_meet = communicator_.any(!points.empty()) && communicator_.any(!edges.empty());
    const auto covered =
        may_meet ? directory.covered_edges(edges, sides_near_loose_edges(entries)) : std::vector<Edge>{};
    together(communicator_, [&] {
      part_.is_used.assign(entries.size(), false);
      for (const Face& face : mesh_.faces) add({face[0], face[1], face[2]});
      for (const Edge& edge : edges)
        if (!std::ranges::binary_search(covered, edge)) add({edge[0], edge[1], -1});
      for (const Index point : points) add({point, -1, -1});
    });
  }

  std::vector<Edge> sides_near_loose_edges(const std::vector<Entry>& entries) const {
    std::vector<Edge> sides;
    const auto is_near = [&](Index v) { return entries[place_of(mentions_, v)].is_on_loose_edge; };
    for (const Face& face : mesh_.faces)
      for (std::size_t k = 0; k < 3; ++k) {
        const Index a = face[k], b = face[(k + 1) % 3];
        if (a != b && is_near(a) && is_near(b)) sides.push_back(ascending(a, b));
      }
    return sides;
  }

  void add(Corners numbers) {
    for (Index& corner : numbers) {
      if (corner < 0) continue;
      const std::size_t place = place_of(mentions_, corner);
      part_.is_used[place] = true;
      corner = static_cast<Index>(place);
    }
    part_.elements.elements.push_back(numbers);
  }

  Communicator& communicator_;
  const LocalMesh& mesh_;
  const PairFilter& filter_;
  std::vector<Mention> mentions_;  ///< by number
  InputPart part_;
};

}  // namespace

InputPart make_input_part(Communicator& communicator, const LocalMesh& mesh, const PairFilter& filter) {
  return InputPartMaker(communicator, mesh, filter).make();
}

}  // namespace tamis::distributed
