// Elements that a rank needs besides its own. Every rank publishes some moving boxes around its elements. Where boxes
// of two ranks meet, one of the two sends its elements there to the other, which searches.
#pragma once
#include <exception>
#include <optional>
#include <vector>

#include "distributed/src/agreement.hpp"
#include "distributed/src/communicator.hpp"
#include "distributed/src/partition/box_tree.hpp"
#include "distributed/src/partition/element_set.hpp"
#include "distributed/src/sparse_exchange.hpp"

namespace tamis::distributed {

/// Which of two ranks searches the pairs between their elements: the lower or the higher by turns, so that each rank
/// searches for half of its neighbours.
inline int searcher_of(int a, int b) { return (a + b) % 2 != 0 ? std::min(a, b) : std::max(a, b); }

class Borrowing {
 public:
  /// Collective; this rank's messages are on their way when it returns. Keeps a reference to `own`. A rank that fails
  /// (`failure`) goes on as if it had nothing, so that no rank waits; what it has found is then not used.
  template <class Test>
  Borrowing(Communicator& communicator, const ElementSet& own, const BoxRule& rule, const Test& may_matter);

  /// Collective, to be called once. Receives the elements of other ranks that matter to some of this rank's elements.
  void finish();
  const ElementSet& borrowed() const { return borrowed_; }
  /// The elements of this rank to which borrowed ones matter.
  template <class Test>
  ElementSet own_near_borrowed(const Test& may_matter) const;
  std::uint64_t boxes_published() const { return boxes_; }
  /// Ranks must agree on it before they use any answer.
  const std::exception_ptr& failure() const { return failure_; }

 private:
  template <class Work>
  void attempt(const Work& work);
  std::vector<BoxTree> publish();
  void send(int rank, const std::vector<std::uint32_t>& places, std::vector<Message>& messages) const;

  Communicator& communicator_;
  const ElementSet& own_;
  const BoxRule rule_;
  BoxTree tree_;  ///< over this rank's elements
  std::uint64_t boxes_ = 0;
  std::optional<SparseExchange> exchange_;
  ElementSet borrowed_;
  std::exception_ptr failure_;
};

template <class Work>
void Borrowing::attempt(const Work& work) {
  if (!failure_) failure_ = failure_of(work);
}

template <class Test>
Borrowing::Borrowing(Communicator& communicator, const ElementSet& own, const BoxRule& rule, const Test& may_matter)
    : communicator_(communicator), own_(own), rule_(rule) {
  attempt([&] { tree_ = BoxTree(boxes_of(own, rule)); });
  const std::vector<BoxTree> trees = publish();
  std::vector<Message> messages;
  attempt([&] {
    for (int rank = 0; rank < communicator.size(); ++rank)
      if (rank != communicator.rank() && searcher_of(rank, communicator.rank()) == rank)
        send(rank, tree_.leaves_that_meet(trees[static_cast<std::size_t>(rank)], may_matter), messages);
  });
  if (failure_) messages.clear();
  exchange_.emplace(communicator, std::move(messages));
}

template <class Test>
ElementSet Borrowing::own_near_borrowed(const Test& may_matter) const {
  return subset(own_, tree_.leaves_that_meet(BoxTree(boxes_of(borrowed_, rule_)), may_matter));
}

}  // namespace tamis::distributed
