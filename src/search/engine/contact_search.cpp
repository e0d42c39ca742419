#include "search/engine/contact_search.hpp"

#include <algorithm>

#include "search/engine/scene_beginning.hpp"

namespace tamis {
namespace {

/// The question for all contacts has no use for samples. An early contact shortens nothing.
Samples samples_for(const Query& query, int parts) {
  return query.question == Question::all_contacts ? Samples() : Samples(parts);
}

}  // namespace

void ContactSearch::find(const Query& query, ContactCollector& answer, Statistics& statistics) {
  FeatureTrees& trees = workspace_.trees;
  const LooksAt looks_at = query.question == Question::earliest ? LooksAt::start : LooksAt::whole_step;
  const bool is_listed = candidates_.prepare(query, looks_at, ahead_.begin(query), ahead_, statistics);
  const Stopwatch watch;
  streams_.begin(answer);
  if (is_listed) search_lists(answer);
  const bool is_undecided = is_listed ? ahead_.leaves_undecided(answer) : !search_beginnings(answer, statistics);
  if (is_listed && is_undecided)
    trees.refit_or_rebuild(query.step, query.separations, query.frame, looks_at, statistics);
  if (is_undecided) search_trees(answer);
  using Counts = SearchCounts;
  query.separations.any()
      ? streams_.report(statistics, watch.seconds(), {&Counts::boxes, &Counts::slab, &Counts::apart, &Counts::solve})
      : streams_.report(statistics, watch.seconds(),
                        {&Counts::boxes, &Counts::slab, &Counts::dnf, &Counts::ncf, &Counts::solve});
  ahead_.end(answer);
}

void ContactSearch::search_lists(ContactCollector& answer) {
  const PairLists& lists = ahead_.lists();
  const std::size_t most_parts = std::max(lists[PairKind::vertex_face].parts(), lists[PairKind::edge_edge].parts());
  float t_limit = 1;
  for (const Sample& sample : samples_for(answer.query(), static_cast<int>(most_parts))) {
    streams_.search_lists(lists, sample, ahead_.when(), t_limit);
    t_limit = std::min(t_limit, gather(answer));
  }
}

/// For steps on which vertices go very far (scene_beginning.hpp). The first contact comes early there, and is searched
/// for in beginnings of the step. Returns whether it was found there. If not, the trees are of the whole step again.
bool ContactSearch::search_beginnings(ContactCollector& answer, Statistics& statistics) {
  constexpr int kBeginnings = 4;  // without an early contact they are searched in vain
  constexpr double kLonger = 16;
  const Query& query = answer.query();
  FeatureTrees& trees = workspace_.trees;
  if (query.question != Question::earliest) return false;
  double length = beginning_of_long_step(query.step, workspace_.mesh.points(), trees.motion().frame.widening);
  for (int i = 0; i < kBeginnings && length < 1; ++i, length *= kLonger) {
    PairLists lists;
    const Listing beginning = listing_of_beginning(query, workspace_.mesh.points(), length);
    const bool is_complete = candidates_.list(query, beginning, lists, statistics);
    if (is_complete) {
      trees.load_vertices(query.step, query.separations, query.frame, statistics);
      streams_.begin(answer);
      answer.count_ignored_anew();
      streams_.search_lists(lists, Sample(), {0, 1}, float_after(answer.bound().latest()));
      gather(answer);
      if (answer.bound().latest() < length) return true;  // pairs that are not listed touch at `length` or later
    }
    trees.refit_for(query.step, query.separations, query.frame);
    streams_.begin(answer);
    if (!is_complete) return false;
  }
  return false;
}

/// REQUIRES: trees of the query's step.
void ContactSearch::search_trees(ContactCollector& answer) {
  const FeatureTrees& trees = workspace_.trees;
  TAMIS_ASSERT(trees.are_of(answer.query().step));
  answer.count_ignored_anew();
  float t_limit = float_after(answer.bound().latest());  // lists may have found a contact
  for (const Sample& sample : samples_for(answer.query(), trees.most_leaf_blocks())) {
    streams_.search_trees(sample, t_limit);
    t_limit = std::min(t_limit, gather(answer));
  }
}

/// Collects the contacts of all threads in `answer`, and tells each thread the first contact so far. Returns the latest
/// time of interest. The step is shortened only between samples, so answers do not depend on threads.
float ContactSearch::gather(ContactCollector& answer) {
  streams_.for_each([&](ContactConsumer& consumer) { answer.take(consumer.found()); });
  streams_.for_each([&](ContactConsumer& consumer) { consumer.found().learn(answer); });
  return float_after(answer.bound().latest());
}

}  // namespace tamis
