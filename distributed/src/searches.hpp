// What every question does up to its answer on one rank: it sends positions to owners, lends the frame, searches among
// own elements, and searches against borrowed ones. Also watches the balance of work.
#pragma once
#include <exception>
#include <string>

#include "distributed/src/agreement.hpp"
#include "distributed/src/borrowing.hpp"
#include "distributed/src/frame.hpp"
#include "distributed/src/input_part.hpp"
#include "distributed/src/local_search.hpp"
#include "distributed/src/partition/decomposition.hpp"
#include "distributed/src/stopwatch.hpp"
#include "tamis/distributed.hpp"

namespace tamis::distributed {

class Searches {
 public:
  /// Collective.
  Searches(MPI_Comm raw, const LocalMesh& mesh, Options options);

  /// Collective: begins every question. Checks that all ranks ask the same; afterwards each rank has its own elements
  /// with their motions, and the frame.
  void begin(const std::string& question, const Step& step, const QueryOptions& options);
  /// Collective. Calls `ask(search)` for a search among own elements while messages are on their way, then for one
  /// against all borrowed elements that `may_matter`.
  template <class Ask, class Test>
  void search_at_once(const Ask& ask, const Test& may_matter);
  /// Collective. The same, but elements are borrowed after the search among own elements: its answer bounds, by
  /// `make_test()`, which elements may matter.
  template <class Ask, class MakeTest>
  void search_in_turn(const Ask& ask, bool by_drifts, const MakeTest& make_test);
  /// Collective: ends every question; adds up its statistics.
  void end();
  /// Collective, after a question that tests all pairs. If work has become unequal, the next such question counts
  /// pairs, and the one after it has a new decomposition.
  void watch_balance();

  /// The question's options; the separation is its own, or else that of the detector's options.
  const QueryOptions& asked() const { return asked_; }
  Communicator& communicator() { return communicator_; }
  Index vertex_count() const { return input_.vertex_count; }
  Statistics& statistics() { return statistics_; }
  const Balance& balance() const { return balance_; }

 private:
  const ElementSet& own() const { return decomposition_.own(); }
  void decompose();
  template <class Test>
  Borrowing borrow(bool by_drifts, const Test& may_matter);
  template <class Ask>
  std::exception_ptr search_interior(const Ask& ask);
  template <class Test, class Ask>
  std::exception_ptr search_border(Borrowing& borrowing, const Test& may_matter, const Ask& ask);

  Communicator communicator_;
  const Options options_;
  InputPart input_;
  Decomposition decomposition_{communicator_};
  BoxFrame frame_{};
  LocalSearch interior_{options_}, border_{options_};
  QueryOptions asked_;
  bool is_to_decompose_ = true, counts_pairs_ = false;
  double allowed_;  ///< the imbalance that is accepted; 0: kWorse times that of the next question
  int cuts_ = 0;    ///< number of decompositions by weights
  Traffic traffic_before_;
  Statistics statistics_;
  Balance balance_;
};

template <class Ask, class Test>
void Searches::search_at_once(const Ask& ask, const Test& may_matter) {
  interior_.count_pairs(counts_pairs_);
  border_.count_pairs(counts_pairs_);
  Borrowing borrowing = borrow(false, may_matter);
  const std::exception_ptr of_interior = search_interior(ask);
  const std::exception_ptr of_border = search_border(borrowing, may_matter, ask);
  agree(communicator_, of_interior ? of_interior : of_border);
}

template <class Ask, class MakeTest>
void Searches::search_in_turn(const Ask& ask, bool by_drifts, const MakeTest& make_test) {
  agree(communicator_, search_interior(ask));
  const auto may_matter = make_test();
  Borrowing borrowing = borrow(by_drifts, may_matter);
  agree(communicator_, search_border(borrowing, may_matter, ask));
}

template <class Test>
Borrowing Searches::borrow(bool by_drifts, const Test& may_matter) {
  const Stopwatch watch(statistics_.seconds.borrow);
  return Borrowing(communicator_, own(), {*asked_.min_separation, options_.radii, by_drifts}, may_matter);
}

template <class Ask>
std::exception_ptr Searches::search_interior(const Ask& ask) {
  const Stopwatch watch(statistics_.seconds.interior);
  return failure_of([&] {
    if (own().empty()) return;
    const ElementSet* const sets[] = {&own()};
    interior_.assign(sets, frame_);
    ask(interior_);
    statistics_.pairs_tested += interior_.pairs_tested();
  });
}

template <class Test, class Ask>
std::exception_ptr Searches::search_border(Borrowing& borrowing, const Test& may_matter, const Ask& ask) {
  {
    const Stopwatch watch(statistics_.seconds.borrow);
    borrowing.finish();
  }
  statistics_.borrowed = borrowing.borrowed().elements.size();
  statistics_.boxes = borrowing.boxes_published();
  if (borrowing.failure()) return borrowing.failure();
  const Stopwatch watch(statistics_.seconds.border);
  return failure_of([&] {
    if (borrowing.borrowed().empty()) return;
    border_.assign_sides(borrowing.own_near_borrowed(may_matter), borrowing.borrowed(), frame_);
    ask(border_);
    statistics_.pairs_tested += border_.pairs_tested();
  });
}

}  // namespace tamis::distributed
