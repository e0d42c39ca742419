#include <algorithm>

#include "distributed/src/agreement.hpp"
#include "distributed/src/deliver.hpp"
#include "distributed/src/first_of_all.hpp"
#include "distributed/src/same_on_all.hpp"
#include "distributed/src/searches.hpp"
#include "numbers/busy_guard.hpp"
#include "numbers/floating_point_state.hpp"
#include "tamis/distributed.hpp"
#include "tamis/error.hpp"

namespace tamis::distributed {
namespace {

/// Other ranks may have the first contact until this time: its bracket may end a little later than the least upper end.
double soon_after(double time) {
  constexpr double kWidestBracket = 0x1p-10;
  return std::min(time + kWidestBracket, 1.0);
}

}  // namespace

struct Detector::State {
  State(MPI_Comm communicator, const LocalMesh& mesh, Options options)
      : searches(communicator, mesh, std::move(options)) {}

  void find_contacts() {
    std::vector<std::vector<HomedContact>> found;
    searches.search_at_once([&](LocalSearch& search) { found.push_back(search.contacts(searches.asked())); },
                            MeetUntil{1});
    const Stopwatch watch(searches.statistics().seconds.deliver);
    contacts = deliver(searches.communicator(), found);
  }

  EarliestContact find_earliest() {
    EarliestContact first;
    searches.search_in_turn([&](LocalSearch& search) { keep_first(first, search.earliest(searches.asked())); }, false,
                            [&] { return MeetUntil{soon_after(searches.communicator().least(first.toi_upper))}; });
    const Stopwatch watch(searches.statistics().seconds.deliver);
    return first_of_all(searches.communicator(), first);
  }

  /// Once any rank has a contact, no rank needs to borrow.
  bool find_whether_free() {
    bool is_free = true;
    searches.search_in_turn([&](LocalSearch& search) { is_free = is_free && search.is_free(searches.asked()); }, false,
                            [&] { return MeetUntil{searches.communicator().any(!is_free) ? -1.0 : 1.0}; });
    return !searches.communicator().any(!is_free);
  }

  SafeStep find_safe_step(double keep) {
    SafeStep first;
    double upper = 1;  // with keep 0: the least of any contact, whichever pair is first
    const auto ask = [&](LocalSearch& search) {
      const SafeStep safe = search.safe_step(keep, searches.asked());
      keep_first(first, safe);
      upper = std::min(upper, safe.toi_upper);
    };
    // The factor covers the rounding of a pair's own time (docs/numerics/steps.md, "Step lengths").
    searches.search_in_turn(ask, true, [&] {
      const double until = soon_after(searches.communicator().least(first.toi_lower)) * (1 + 0x1p-14);
      return NearWithin{until / (1 - keep)};
    });
    const Stopwatch watch(searches.statistics().seconds.deliver);
    SafeStep answer = first_of_all(searches.communicator(), first);
    if (keep == 0) answer.toi_upper = searches.communicator().least(upper);
    return answer;
  }

  /// Collective: runs one question from its beginning to its end.
  template <class Find>
  void ask(const std::string& question, const Step& step, const QueryOptions& options, const Find& find) {
    double total = 0;
    agreed_or_ended(searches.communicator().raw(), [&] {
      const Stopwatch watch(total);
      searches.begin(question, step, options);
      find();
      searches.end();
    });
    searches.statistics().seconds.total = total;
  }

  void refuse_while_asked() const {
    if (is_asked.test(std::memory_order_acquire)) throw Busy();
  }

  Searches searches;
  std::vector<Contact> contacts;
  std::atomic_flag is_asked;  ///< set while this rank answers a question
};

Detector::Detector(MPI_Comm communicator, const LocalMesh& mesh, Options options)
    : state_(computing([&] {
        return agreed_or_ended(communicator,
                               [&] { return std::make_unique<State>(communicator, mesh, std::move(options)); });
      })) {}
Detector::~Detector() = default;
Detector::Detector(Detector&&) noexcept = default;
Detector& Detector::operator=(Detector&&) noexcept = default;

std::span<const Contact> Detector::contacts(const Step& step, const QueryOptions& options) {
  const BusyGuard guard(state_->is_asked);
  const ComputingState computing_state;
  state_->ask("contacts", step, options, [&] { state_->find_contacts(); });
  agreed_or_ended(state_->searches.communicator().raw(), [&] { state_->searches.watch_balance(); });
  return state_->contacts;
}

std::vector<Contact> Detector::gather_contacts(int root) {
  const BusyGuard guard(state_->is_asked);
  const ComputingState computing_state;
  Communicator& communicator = state_->searches.communicator();
  return agreed_or_ended(communicator.raw(), [&] {
    require_same(communicator, {"gather contacts on rank " + std::to_string(root)});
    if (root < 0 || root >= communicator.size())
      throw InvalidOptions("there is no rank " + std::to_string(root) + ": there are " +
                           std::to_string(communicator.size()) + ", from 0");
    return gather(communicator, state_->contacts, root);
  });
}

EarliestContact Detector::earliest(const Step& step, const QueryOptions& options) {
  const BusyGuard guard(state_->is_asked);
  const ComputingState computing_state;
  EarliestContact first;
  state_->ask("earliest", step, options, [&] { first = state_->find_earliest(); });
  return first;
}

bool Detector::is_free(const Step& step, const QueryOptions& options) {
  const BusyGuard guard(state_->is_asked);
  const ComputingState computing_state;
  bool is_free = false;
  state_->ask("is_free", step, options, [&] { is_free = state_->find_whether_free(); });
  return is_free;
}

SafeStep Detector::safe_step(const Step& step, double keep, const QueryOptions& options) {
  const BusyGuard guard(state_->is_asked);
  const ComputingState computing_state;
  SafeStep safe;
  state_->ask("safe_step " + exact(keep), step, options, [&] { safe = state_->find_safe_step(keep); });
  return safe;
}

Index Detector::vertex_count() const { return state_->searches.vertex_count(); }
const Statistics& Detector::statistics() const {
  state_->refuse_while_asked();
  return state_->searches.statistics();
}
const Balance& Detector::balance() const {
  state_->refuse_while_asked();
  return state_->searches.balance();
}

}  // namespace tamis::distributed
