#include "distributed/src/borrowing.hpp"

namespace tamis::distributed {
namespace {

/// The most boxes that one rank publishes. Fewer if there are many ranks, as every rank holds the boxes of all.
std::size_t most_boxes(int ranks) {
  constexpr std::size_t kMost = 512, kLeast = 32, kOfAll = std::size_t{1} << 18;
  return std::clamp(kOfAll / static_cast<std::size_t>(ranks), kLeast, kMost);
}

}  // namespace

std::vector<BoxTree> Borrowing::publish() {
  Packer packer;
  packer.put_all(tree_.level_of_at_most(most_boxes(communicator_.size())));
  std::vector<BoxTree> trees;
  for (const Bytes& bytes : communicator_.gather_for_all(packer.take())) {
    auto boxes = Unpacker(bytes).get_all<MovingBox>();
    boxes_ += boxes.size();
    trees.emplace_back(std::move(boxes));
  }
  return trees;
}

void Borrowing::send(int rank, const std::vector<std::uint32_t>& places, std::vector<Message>& messages) const {
  if (places.empty()) return;
  Packer packer;
  pack(packer, subset(own_, places));
  messages.push_back({rank, packer.take()});
}

void Borrowing::finish() {
  const std::vector<Message> messages = exchange_->finish();
  attempt([&] {
    std::vector<ElementSet> sets;
    for (const Message& message : messages) {
      Unpacker unpacker(message.bytes);
      sets.push_back(unpack_elements(unpacker));
    }
    std::vector<const ElementSet*> all;
    for (const ElementSet& set : sets) all.push_back(&set);
    borrowed_ = united(all);
  });
}

}  // namespace tamis::distributed
