#include <algorithm>
#include <chrono>
#include <cmath>
#include <tuple>

#include "mpi/src/agreement.hpp"
#include "mpi/src/borrowing.hpp"
#include "mpi/src/decomposition.hpp"
#include "mpi/src/deliver.hpp"
#include "mpi/src/frame.hpp"
#include "mpi/src/input_part.hpp"
#include "mpi/src/input_positions.hpp"
#include "mpi/src/local_search.hpp"
#include "mpi/src/same_on_all.hpp"
#include "tamis/distributed.hpp"
#include "tamis/error.hpp"

namespace tamis::distributed {
namespace {

using Clock = std::chrono::steady_clock;

/// Work is balanced while the busiest rank has this much more than the mean.
constexpr double kBalanced = 1.2;

/// Throws as `tamis::Detector` does, before any rank has an element.
void validate(const Options& options) {
  if (options.method == Method::paper) throw InvalidOptions("method paper is a laboratory on one machine: use tamis");
  Options alone = options;
  alone.filter.group_of_vertex.clear();
  tamis::Detector(Mesh(1, {}, {}, {0}), std::move(alone));
}

/// Adds the seconds from its making to its end.
class Stopwatch {
 public:
  explicit Stopwatch(double& seconds) : seconds_(seconds) {}
  ~Stopwatch() { seconds_ += std::chrono::duration<double>(Clock::now() - start_).count(); }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  double& seconds_;
  const Clock::time_point start_ = Clock::now();
};

double largest_over_mean(Communicator& communicator, std::uint64_t number) {
  const std::uint64_t sum = communicator.sum(number), largest = communicator.largest(number);
  return sum == 0 ? 1 : static_cast<double>(largest) * communicator.size() / static_cast<double>(sum);
}

/// Collective. Of what all ranks have found, that which is first: by the least time, then kind and vertices.
template <class T, class Time, class Pair>
T first_of_all(Communicator& communicator, const T& mine, const Time& time_of, const Pair& pair_of) {
  const double least = communicator.least(pair_of(mine) ? time_of(mine) : 2);
  Packer packer;
  if (pair_of(mine) && time_of(mine) == least) packer.put(mine);
  T first{};
  for (const Bytes& bytes : communicator.gather_for_all(packer.take())) {
    if (bytes.empty()) continue;
    const T other = Unpacker(bytes).template get<T>();
    const auto &a = pair_of(other), &b = pair_of(first);
    if (!b || std::tie(a->kind, a->vertices) < std::tie(b->kind, b->vertices)) first = other;
  }
  return first;
}

EarliestContact first_of_all(Communicator& communicator, const EarliestContact& mine) {
  EarliestContact first = first_of_all(
      communicator, mine, [](const EarliestContact& e) { return e.toi_lower; },
      [](const EarliestContact& e) -> const auto& { return e.contact; });
  first.toi_upper = communicator.least(mine.toi_upper);
  return first;
}

SafeStep first_of_all(Communicator& communicator, const SafeStep& mine) {
  return first_of_all(
      communicator, mine, [](const SafeStep& s) { return s.lower; },
      [](const SafeStep& s) -> const auto& { return s.pair; });
}

/// Of two searches of one rank.
void keep_first(EarliestContact& first, const EarliestContact& other) {
  const double upper = std::min(first.toi_upper, other.toi_upper);
  const auto key = [](const EarliestContact& e) {
    return std::tuple(e.toi_lower, e.contact->kind, e.contact->vertices);
  };
  if (other.contact && (!first.contact || key(other) < key(first))) first = other;
  first.toi_upper = upper;
}

void keep_first(SafeStep& first, const SafeStep& other) {
  const auto key = [](const SafeStep& s) { return std::tuple(s.lower, s.pair->kind, s.pair->vertices); };
  if (other.pair && (!first.pair || key(other) < key(first))) first = other;
}

}  // namespace

struct Detector::State {
  State(MPI_Comm raw, const LocalMesh& mesh, Options o) : communicator(raw), options(std::move(o)) {
    together(communicator, [&] { validate(options); });
    require_same(communicator, sayings_of(options));
    input = make_input_part(communicator, mesh, options.filter);
  }

  /// Every question begins so: all ranks ask the same; everybody has its own elements, and those of the frame.
  void begin(const std::string& question, const Step& step, std::optional<double> own_separation) {
    statistics = {};
    traffic_before = communicator.traffic();
    separation = own_separation.value_or(options.min_separation);
    require_same(communicator, {question, "minimum separation " + exact(separation)});
    if (!(std::isfinite(separation) && separation >= 0))
      throw InvalidOptions("the minimum separation is " + exact(separation) + ": give a finite distance >= 0");
    {
      const Stopwatch watch(statistics.seconds.positions);
      take_positions(communicator, step, input);
    }
    if (!decomposition.exists() || is_to_decompose) decompose();
    {
      const Stopwatch watch(statistics.seconds.positions);
      decomposition.send_motions(input.elements);
    }
    const Stopwatch watch(statistics.seconds.borrow);
    frame_elements = frame.span(own());
  }

  void decompose() {
    const Stopwatch watch(statistics.seconds.decompose);
    decomposition.decompose(input.elements);
    frame.forget();
    interior.forget();
    border.forget();
    statistics.decomposed_anew = true;
    is_to_decompose = false;
  }

  const ElementSet& own() const { return decomposition.own(); }

  BoxRule box_rule(bool has_drifts = false) const { return {separation, options.thickness, has_drifts}; }

  /// `ask(search)` among own elements; those of the frame are there, too.
  template <class Ask>
  std::exception_ptr search_interior(const Ask& ask) {
    const Stopwatch watch(statistics.seconds.interior);
    return failure_of([&] {
      if (own().empty()) return;
      const ElementSet* const sets[] = {&own(), &frame_elements};
      interior.assign(sets);
      ask(interior);
      statistics.pairs_tested += interior.pairs_tested();
    });
  }

  /// And among what was borrowed and what that matters to.
  template <class Test, class Ask>
  std::exception_ptr search_border(Borrowing& borrowing, const Test& may_matter, const Ask& ask) {
    {
      const Stopwatch watch(statistics.seconds.borrow);
      borrowing.finish();
    }
    statistics.borrowed = borrowing.borrowed().elements.size();
    statistics.boxes = borrowing.boxes_published();
    const Stopwatch watch(statistics.seconds.border);
    return failure_of([&] {
      if (borrowing.borrowed().empty()) return;
      const ElementSet mine = borrowing.own_near_borrowed(may_matter);
      const ElementSet* const others[] = {&borrowing.borrowed(), &frame_elements};
      border.assign_sides(mine, others);
      ask(border);
      statistics.pairs_tested += border.pairs_tested();
    });
  }

  template <class Test>
  Borrowing borrow(const BoxRule& rule, const Test& may_matter) {
    const Stopwatch watch(statistics.seconds.borrow);
    return Borrowing(communicator, own(), rule, may_matter);
  }

  /// Own elements first; what they say bounds what has to be borrowed.
  template <class Ask, class Test>
  void search_in_turn(const Ask& ask, const BoxRule& rule, const Test& make_test) {
    agree(communicator, search_interior(ask));
    const auto may_matter = make_test();
    Borrowing borrowing = borrow(rule, may_matter);
    agree(communicator, search_border(borrowing, may_matter, ask));
  }

  void find_contacts() {
    const MeetUntil may_matter{1};
    std::vector<std::vector<HomedContact>> found;
    const auto ask = [&](LocalSearch& search) { found.push_back(search.contacts(separation)); };
    interior.count_pairs(counts_pairs);
    border.count_pairs(counts_pairs);
    Borrowing borrowing = borrow(box_rule(), may_matter);
    const std::exception_ptr failure = search_interior(ask);  // while messages are on their way
    const std::exception_ptr of_border = search_border(borrowing, may_matter, ask);
    agree(communicator, failure ? failure : of_border);
    const Stopwatch watch(statistics.seconds.deliver);
    contacts = deliver(communicator, found);
  }

  EarliestContact find_earliest() {
    EarliestContact first;
    search_in_turn([&](LocalSearch& search) { keep_first(first, search.earliest(separation)); }, box_rule(),
                   [&] { return MeetUntil{soon_after(communicator.least(first.toi_upper))}; });
    return first_of_all(communicator, first);
  }

  bool find_any() {
    bool is_free = true;
    const auto ask = [&](LocalSearch& search) { is_free = is_free && search.is_free(separation); };
    agree(communicator, search_interior(ask));
    if (communicator.any(!is_free)) return false;
    const MeetUntil may_matter{1};
    Borrowing borrowing = borrow(box_rule(), may_matter);
    agree(communicator, search_border(borrowing, may_matter, ask));
    return !communicator.any(!is_free);
  }

  SafeStep find_safe_step(double fraction) {
    SafeStep first;
    const auto ask = [&](LocalSearch& search) { keep_first(first, search.keep_distance(fraction, separation)); };
    // What a pair's own time is rounded by is in the factor (NearQuestion, docs/numerics.md).
    search_in_turn(ask, box_rule(true),
                   [&] { return NearWithin{communicator.least(first.lower) * (1 + 0x1p-14) / (1 - fraction)}; });
    return first_of_all(communicator, first);
  }

  /// Brackets of contacts that come first end a little after the first contact's.
  static double soon_after(double time) {
    constexpr double kRoom = 0x1p-10;
    return std::min(time + kRoom, 1.0);
  }

  void end() {
    statistics.owned = own().elements.size();
    statistics.messages_sent = communicator.traffic().messages - traffic_before.messages;
    statistics.bytes_sent = communicator.traffic().bytes - traffic_before.bytes;
    balance = {largest_over_mean(communicator, statistics.pairs_tested),
               largest_over_mean(communicator, statistics.owned)};
  }

  /// Where work has become unequal, the next question counts pairs, and the one after it has a new decomposition.
  void watch_balance() {
    if (counts_pairs) {
      std::vector<std::uint64_t> weights = interior.weights_of(own());
      const std::vector<std::uint64_t> of_border = border.weights_of(own());
      for (std::size_t e = 0; e < weights.size(); ++e) weights[e] += of_border[e];
      decomposition.report_weights(weights);
      counts_pairs = false;
      is_to_decompose = true;
      allowed = 0;
      return;
    }
    constexpr double kWorse = 1.25;
    if (allowed == 0) allowed = std::max(kBalanced, kWorse * balance.pairs);
    counts_pairs = balance.pairs > allowed;
  }

  template <class Work>
  void measure(const Work& work) {
    double total = 0;
    {
      const Stopwatch watch(total);
      work();
      end();
    }
    statistics.seconds.total = total;
  }

  Communicator communicator;
  Options options;
  InputPart input;
  Decomposition decomposition{communicator};
  Frame frame{communicator};
  ElementSet frame_elements;
  LocalSearch interior{options}, border{options};
  double separation = 0;
  bool is_to_decompose = false, counts_pairs = false;
  double allowed = kBalanced;  ///< imbalance; 0: what the next question has, and some more
  std::vector<Contact> contacts;
  Traffic traffic_before;
  Statistics statistics;
  Balance balance;
};

Detector::Detector(MPI_Comm communicator, LocalMesh mesh, Options options)
    : state_(std::make_unique<State>(communicator, mesh, std::move(options))) {}
Detector::~Detector() = default;
Detector::Detector(Detector&&) noexcept = default;
Detector& Detector::operator=(Detector&&) noexcept = default;

const std::vector<Contact>& Detector::contacts(const Step& step, std::optional<double> min_separation) {
  state_->measure([&] {
    state_->begin("contacts", step, min_separation);
    state_->find_contacts();
  });
  state_->watch_balance();
  return state_->contacts;
}

std::vector<Contact> Detector::gather_contacts(int root) {
  require_same(state_->communicator, {"gather contacts on rank " + std::to_string(root)});
  return gather(state_->communicator, state_->contacts, root);
}

EarliestContact Detector::earliest(const Step& step, std::optional<double> min_separation) {
  EarliestContact first;
  state_->measure([&] {
    state_->begin("earliest", step, min_separation);
    first = state_->find_earliest();
  });
  return first;
}

bool Detector::is_free(const Step& step, std::optional<double> min_separation) {
  bool is_free = false;
  state_->measure([&] {
    state_->begin("is_free", step, min_separation);
    is_free = state_->find_any();
  });
  return is_free;
}

SafeStep Detector::keep_distance(const Step& step, double fraction, std::optional<double> min_separation) {
  SafeStep safe;
  state_->measure([&] {
    state_->begin("keep_distance " + exact(fraction), step, min_separation);
    safe = state_->find_safe_step(fraction);
  });
  return safe;
}

Index Detector::vertex_count() const { return state_->input.vertex_count; }
const Statistics& Detector::statistics() const { return state_->statistics; }
const Balance& Detector::balance() const { return state_->balance; }

}  // namespace tamis::distributed
