#include "paper/topology/patches.hpp"

#include <algorithm>
#include <map>
#include <numeric>

#include "search/topology/at.hpp"

namespace tamis::lab {
namespace {

class PatchOrder {
 public:
  explicit PatchOrder(const Mesh& mesh) : mesh_(mesh), patch_of_(mesh.faces().size(), 0) {}

  std::vector<Index> order() {
    std::vector<Index> triangles(mesh_.faces().size());
    std::iota(triangles.begin(), triangles.end(), 0);
    split(triangles);
    return triangles;
  }

 private:
  void split(std::span<Index> patch) {
    if (patch.size() < 3) return;
    // Starts at the rim, from the last triangle of a first search, so that the first half is not cut out of the middle.
    const Index rim = search(patch, patch[0]);
    search(patch, rim);
    const std::size_t half = patch.size() / 2;
    split(patch.first(half));
    split(patch.subspan(half));
  }

  /// Orders the patch by breadth-first search from `start`; returns the last triangle of start's component.
  Index search(std::span<Index> patch, Index start) {
    const Index unseen = ++marks_;
    for (Index t : patch) patch_of_[at(t)] = unseen;
    const Index seen = ++marks_;
    queue_.clear();
    Index last = start;
    const auto search_component = [&](Index first) {
      std::size_t head = queue_.size();
      patch_of_[at(first)] = seen;
      queue_.push_back(first);
      for (; head < queue_.size(); ++head)
        for (Index edge : mesh_.edges_of_face(queue_[head])) {
          if (edge < 0) continue;
          for (Index t : mesh_.faces_of_edge(edge)) {
            if (patch_of_[at(t)] != unseen) continue;
            patch_of_[at(t)] = seen;
            queue_.push_back(t);
          }
        }
    };
    search_component(start);
    last = queue_.back();
    for (Index t : patch)
      if (patch_of_[at(t)] == unseen) search_component(t);
    std::copy(queue_.begin(), queue_.end(), patch.begin());
    return last;
  }

  const Mesh& mesh_;
  std::vector<Index> patch_of_;
  std::vector<Index> queue_;
  Index marks_ = 0;
};

/// Oriented sides, and how many of each remain after opposite ones have cancelled. The key is (smaller, larger vertex);
/// the count is positive from the smaller to the larger.
using EdgeChain = std::vector<std::pair<Edge, int>>;

EdgeChain chain_of(const Face& face) {
  EdgeChain chain;
  for (std::size_t k = 0; k < 3; ++k) {
    const Index a = face[k], b = face[(k + 1) % 3];
    chain.push_back(a < b ? std::pair{Edge{a, b}, 1} : std::pair{Edge{b, a}, -1});
  }
  std::sort(chain.begin(), chain.end());
  return chain;
}

EdgeChain sum(const EdgeChain& a, const EdgeChain& b) {
  EdgeChain result;
  for (auto i = a.begin(), j = b.begin(); i != a.end() || j != b.end();) {
    if (j == b.end() || (i != a.end() && i->first < j->first)) {
      result.push_back(*i++);
    } else if (i == a.end() || j->first < i->first) {
      result.push_back(*j++);
    } else {
      if (i->second + j->second != 0) result.emplace_back(i->first, i->second + j->second);
      ++i;
      ++j;
    }
  }
  return result;
}

/// The chain as one loop of vertices; empty if it is not one loop.
std::vector<Index> loop_of(const EdgeChain& chain) {
  std::vector<Edge> sides;  // from, to
  for (const auto& [edge, count] : chain) {
    if (count != 1 && count != -1) return {};
    sides.push_back(count > 0 ? edge : Edge{edge[1], edge[0]});
  }
  std::sort(sides.begin(), sides.end());
  for (std::size_t i = 1; i < sides.size(); ++i)
    if (sides[i][0] == sides[i - 1][0]) return {};
  std::vector<Index> loop;
  for (Index vertex = sides.empty() ? 0 : sides[0][0]; loop.size() < sides.size();) {
    const auto side = std::lower_bound(sides.begin(), sides.end(), Edge{vertex, 0});
    if (side == sides.end() || (*side)[0] != vertex || (!loop.empty() && vertex == loop[0])) return {};
    loop.push_back(vertex);
    vertex = (*side)[1];
    if (loop.size() == sides.size() && vertex != loop[0]) return {};
  }
  return loop;
}

class ContourCollector {
 public:
  ContourCollector(const Mesh& mesh, std::size_t smallest) : mesh_(mesh), smallest_(smallest) {}

  IndexRows collect(std::span<const Index> order) {
    if (!order.empty()) visit(order);
    IndexRows rows;
    for (const auto& loop : loops_) {
      rows.items.insert(rows.items.end(), loop.begin(), loop.end());
      rows.offsets.push_back(static_cast<Index>(rows.items.size()));
    }
    return rows;
  }

 private:
  EdgeChain visit(std::span<const Index> patch) {
    const std::size_t node = loops_.size();
    loops_.emplace_back();
    if (patch.size() == 1) return chain_of(mesh_.faces()[at(patch[0])]);
    const std::size_t half = patch.size() / 2;
    const EdgeChain first = visit(patch.first(half));
    EdgeChain chain = sum(first, visit(patch.subspan(half)));
    if (patch.size() >= smallest_) loops_[node] = loop_of(chain);
    return chain;
  }

  const Mesh& mesh_;
  std::size_t smallest_;
  std::vector<std::vector<Index>> loops_;
};

}  // namespace

std::vector<Index> patch_order(const Mesh& mesh) { return PatchOrder(mesh).order(); }

IndexRows patch_contours(const Mesh& mesh, const std::vector<Index>& order, std::size_t smallest) {
  return ContourCollector(mesh, smallest).collect(order);
}

}  // namespace tamis::lab
