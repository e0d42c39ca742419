#include "distributed/src/partition/decomposition.hpp"

#include <map>
#include <numeric>

#include "distributed/src/agreement.hpp"
#include "distributed/src/partition/recursive_bisection.hpp"
#include "distributed/src/partition/spatial_order.hpp"
#include "distributed/src/sparse_exchange.hpp"

namespace tamis::distributed {
namespace {

std::vector<std::uint32_t> places_of(const ElementSet& set, const std::vector<Vertex>& vertices) {
  std::vector<std::uint32_t> places;
  places.reserve(vertices.size());
  for (const Vertex& vertex : vertices)
    places.push_back(static_cast<std::uint32_t>(place_of(set.vertices, vertex.number)));
  return places;
}

ElementSet topology_of(ElementSet set) {
  set.motions.clear();
  return set;
}

}  // namespace

void Decomposition::decompose(const ElementSet& input) {
  std::vector<Point> centers;
  together(communicator_, [&] {
    weights_.resize(input.elements.size(), 1);
    centers = centers_of(input);
  });
  const std::vector<int> owners = bisect(communicator_, centers, weights_);
  send_elements(input, owners);
  is_ordered_ = false;
}

void Decomposition::send_elements(const ElementSet& input, const std::vector<int>& owners) {
  std::vector<Message> outgoing;
  together(communicator_, [&] {
    std::map<int, std::vector<std::uint32_t>> by_owner;
    for (std::size_t e = 0; e < owners.size(); ++e) by_owner[owners[e]].push_back(static_cast<std::uint32_t>(e));
    sent_.clear();
    for (auto& [owner, elements] : by_owner) {
      const ElementSet set = topology_of(subset(input, elements));
      Packer packer;
      pack(packer, set);
      outgoing.push_back({owner, packer.take()});
      sent_.push_back({owner, std::move(elements), places_of(input, set.vertices)});
    }
  });
  const std::vector<Message> incoming = exchange(communicator_, std::move(outgoing));
  together(communicator_, [&] {
    std::vector<ElementSet> sets;
    std::size_t count = 0;
    received_.clear();
    for (const Message& message : incoming) {
      Unpacker unpacker(message.bytes);
      ElementSet set = unpack_elements(unpacker);
      set.ids.resize(set.elements.size());
      std::iota(set.ids.begin(), set.ids.end(), count);
      set.motions.resize(set.vertices.size());
      received_.push_back({message.rank, std::vector<std::uint32_t>(set.elements.size()), {}});
      std::iota(received_.back().elements.begin(), received_.back().elements.end(), static_cast<std::uint32_t>(count));
      count += set.elements.size();
      sets.push_back(std::move(set));
    }
    std::vector<const ElementSet*> all;
    for (const ElementSet& set : sets) all.push_back(&set);
    own_ = united(all);
    for (std::size_t i = 0; i < sets.size(); ++i) received_[i].vertices = places_of(own_, sets[i].vertices);
  });
}

void Decomposition::send_motions(const ElementSet& input) {
  std::vector<Message> outgoing;
  together(communicator_, [&] {
    for (const Share& share : sent_) {
      Packer packer;
      for (const std::uint32_t v : share.vertices) packer.put(input.motions[v]);
      outgoing.push_back({share.rank, packer.take()});
    }
  });
  // Messages and received_ are both sorted by rank: each rank that sent elements sends their motions.
  const std::vector<Message> incoming = exchange(communicator_, std::move(outgoing));
  for (std::size_t i = 0; i < incoming.size(); ++i) {
    Unpacker unpacker(incoming[i].bytes);
    for (const std::uint32_t v : received_[i].vertices) own_.motions[v] = unpacker.get<Motion>();
  }
  if (!is_ordered_) together(communicator_, [&] { put_in_spatial_order(); });
}

void Decomposition::put_in_spatial_order() {
  const std::vector<std::uint32_t> order = spatial_order(centers_of(own_));
  std::vector<std::uint32_t> new_place(order.size());
  std::vector<Corners> elements(order.size());
  for (std::size_t e = 0; e < order.size(); ++e) {
    new_place[order[e]] = static_cast<std::uint32_t>(e);
    elements[e] = own_.elements[order[e]];
    own_.ids[e] = element_id(communicator_.rank(), e);
  }
  own_.elements = std::move(elements);
  for (Share& share : received_)
    for (std::uint32_t& e : share.elements) e = new_place[e];
  is_ordered_ = true;
}

void Decomposition::report_weights(const std::vector<std::uint64_t>& weights) {
  std::vector<Message> outgoing;
  for (const Share& share : received_) {
    Packer packer;
    for (const std::uint32_t e : share.elements) packer.put(weights[e]);
    outgoing.push_back({share.rank, packer.take()});
  }
  const std::vector<Message> incoming = exchange(communicator_, std::move(outgoing));
  for (std::size_t i = 0; i < incoming.size(); ++i) {
    Unpacker unpacker(incoming[i].bytes);
    for (const std::uint32_t e : sent_[i].elements) weights_[e] = unpacker.get<std::uint64_t>();
  }
}

}  // namespace tamis::distributed
