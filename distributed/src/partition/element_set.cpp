#include "distributed/src/partition/element_set.hpp"

#include <algorithm>

namespace tamis::distributed {
namespace {

constexpr Index kUnused = -1;

/// The corners by the vertices' numbers instead of their places.
Corners numbered(const Corners& corners, const std::vector<Vertex>& vertices) {
  Corners result = corners;
  for (Index& corner : result)
    if (corner >= 0) corner = vertices[static_cast<std::size_t>(corner)].number;
  return result;
}

struct NamedElement {
  ElementId id;
  Corners numbers;
};

std::vector<NamedElement> named_elements(std::span<const ElementSet* const> sets) {
  std::vector<NamedElement> all;
  for (const ElementSet* set : sets)
    for (std::size_t e = 0; e < set->elements.size(); ++e)
      all.push_back({set->ids[e], numbered(set->elements[e], set->vertices)});
  std::ranges::sort(all, {}, &NamedElement::id);
  const auto has_same_id = [](const NamedElement& a, const NamedElement& b) { return a.id == b.id; };
  all.erase(std::unique(all.begin(), all.end(), has_same_id), all.end());
  return all;
}

}  // namespace

ElementSet subset(const ElementSet& set, std::span<const std::uint32_t> places) {
  std::vector<Index> new_place(set.vertices.size(), kUnused);
  for (const std::uint32_t e : places) for_each_corner(set.elements[e], [&](std::size_t v) { new_place[v] = 0; });
  ElementSet result;
  for (std::size_t v = 0; v < new_place.size(); ++v) {
    if (new_place[v] == kUnused) continue;
    new_place[v] = static_cast<Index>(result.vertices.size());
    result.vertices.push_back(set.vertices[v]);
    if (!set.motions.empty()) result.motions.push_back(set.motions[v]);
  }
  for (const std::uint32_t e : places) {
    Corners corners = set.elements[e];
    for (Index& corner : corners)
      if (corner >= 0) corner = new_place[static_cast<std::size_t>(corner)];
    result.elements.push_back(corners);
    if (!set.ids.empty()) result.ids.push_back(set.ids[e]);
  }
  return result;
}

ElementSet united(std::span<const ElementSet* const> sets) {
  ElementSet result;
  for (const ElementSet* set : sets)
    result.vertices.insert(result.vertices.end(), set->vertices.begin(), set->vertices.end());
  std::ranges::sort(result.vertices, {}, &Vertex::number);
  result.vertices.erase(std::unique(result.vertices.begin(), result.vertices.end()), result.vertices.end());
  for (const NamedElement& element : named_elements(sets)) {
    Corners corners = element.numbers;
    for (Index& corner : corners)
      if (corner >= 0) corner = static_cast<Index>(place_of(result.vertices, corner));
    result.elements.push_back(corners);
    result.ids.push_back(element.id);
  }
  result.motions.resize(result.vertices.size());
  for (const ElementSet* set : sets) copy_motions(*set, result);
  return result;
}

void copy_motions(const ElementSet& from, ElementSet& to) {
  std::size_t place = 0;
  for (std::size_t v = 0; v < from.vertices.size(); ++v) {
    while (to.vertices[place].number < from.vertices[v].number) ++place;
    to.motions[place] = from.motions[v];
  }
}

void pack(Packer& packer, const ElementSet& set) {
  packer.put_all(set.vertices);
  packer.put_all(set.motions);
  packer.put_all(set.elements);
  packer.put_all(set.ids);
}

ElementSet unpack_elements(Unpacker& unpacker) {
  ElementSet set;
  set.vertices = unpacker.get_all<Vertex>();
  set.motions = unpacker.get_all<Motion>();
  set.elements = unpacker.get_all<Corners>();
  set.ids = unpacker.get_all<ElementId>();
  return set;
}

}  // namespace tamis::distributed
