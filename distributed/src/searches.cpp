#include "distributed/src/searches.hpp"

#include <algorithm>
#include <cmath>

#include "distributed/src/input_positions.hpp"
#include "distributed/src/same_on_all.hpp"
#include "tamis/error.hpp"

namespace tamis::distributed {
namespace {

/// Work counts as balanced while the busiest rank has at most this many times the mean.
constexpr double kBalanced = 1.2;
/// After this many decompositions by weights, one after the other, the remaining imbalance is accepted: weights are
/// those of the decomposition before.
constexpr int kCuts = 3;
/// The accepted imbalance may grow by this factor before there is a new decomposition.
constexpr double kWorse = 1.25;

/// Throws as `tamis::Detector` does, before any rank has an element.
void validate(const Options& options) {
  if (options.filter.rings != 1)
    throw InvalidOptions("rings is " + std::to_string(options.filter.rings) +
                         ": ranks have parts of the mesh, along which they cannot go; leave it at 1");
  Options alone = options;
  alone.filter.group_of_vertex = {0};
  tamis::Detector(Mesh(1, {}, {}, {0}), std::move(alone));
}

double largest_over_mean(Communicator& communicator, std::uint64_t number) {
  const std::uint64_t sum = communicator.sum(number), largest = communicator.largest(number);
  return sum == 0 ? 1 : static_cast<double>(largest) * communicator.size() / static_cast<double>(sum);
}

}  // namespace

Searches::Searches(MPI_Comm raw, const LocalMesh& mesh, Options options)
    : communicator_(raw), options_(std::move(options)), allowed_(kBalanced) {
  together(communicator_, [&] { validate(options_); });
  require_same(communicator_, sayings_of(options_));
  input_ = make_input_part(communicator_, mesh, options_.filter);
}

void Searches::begin(const std::string& question, const Step& step, const QueryOptions& options) {
  statistics_ = {};
  traffic_before_ = communicator_.traffic();
  asked_ = options;
  const double separation = options.min_separation.value_or(options_.min_separation);
  asked_.min_separation = separation;
  require_same(communicator_, {question, "minimum separation " + exact(separation),
                               "at_start " + std::string(name_of(options.at_start))});
  if (!(std::isfinite(separation) && separation >= 0))
    throw InvalidOptions("the minimum separation is " + exact(separation) + ": give a finite distance >= 0");
  if (options.at_start != AtStart::report && options.at_start != AtStart::ignore)
    throw InvalidOptions("at_start is " + std::string(name_of(options.at_start)) +
                         ": ranks know report and ignore; query the contacts of the start at rest instead");
  {
    const Stopwatch watch(statistics_.seconds.positions);
    take_positions(communicator_, step, input_);
  }
  if (is_to_decompose_) decompose();
  {
    const Stopwatch watch(statistics_.seconds.positions);
    decomposition_.send_motions(input_.elements);
  }
  const Stopwatch watch(statistics_.seconds.borrow);
  frame_ = frame_of_scene(communicator_, input_, separation);
}

void Searches::decompose() {
  const Stopwatch watch(statistics_.seconds.decompose);
  decomposition_.decompose(input_.elements);
  interior_.forget();
  border_.forget();
  statistics_.decomposed_anew = true;
  is_to_decompose_ = false;
}

void Searches::end() {
  statistics_.owned = own().elements.size();
  statistics_.messages_sent = communicator_.traffic().messages - traffic_before_.messages;
  statistics_.bytes_sent = communicator_.traffic().bytes - traffic_before_.bytes;
  balance_ = {largest_over_mean(communicator_, statistics_.pairs_tested),
              largest_over_mean(communicator_, statistics_.owned)};
}

void Searches::watch_balance() {
  if (counts_pairs_) {
    std::vector<std::uint64_t> weights = interior_.weights_of(own());
    const std::vector<std::uint64_t> of_border = border_.weights_of(own());
    for (std::size_t e = 0; e < weights.size(); ++e) weights[e] += 2 * of_border[e];  // borrowers search the other half
    decomposition_.report_weights(weights);
    counts_pairs_ = false;
    is_to_decompose_ = true;
    allowed_ = ++cuts_ % kCuts != 0 ? kBalanced : 0;
    return;
  }
  if (allowed_ == 0) allowed_ = std::max(kBalanced, kWorse * balance_.pairs);
  counts_pairs_ = balance_.pairs > allowed_;
}

}  // namespace tamis::distributed
