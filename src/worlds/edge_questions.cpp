// The questions of planners. Threads share the edges, each with a world of its own.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <string>

#include "api/validate.hpp"
#include "numbers/parallel.hpp"
#include "numbers/pool.hpp"
#include "tamis/error.hpp"
#include "worlds/edges.hpp"

namespace tamis {
namespace {

/// Configurations, one after the other.
class Configurations {
 public:
  /// Throws InvalidOptions and InvalidStep.
  Configurations(std::span<const double> numbers, std::size_t dimension, const char* name)
      : numbers_(numbers), dimension_(dimension) {
    if (dimension == 0 ? !numbers.empty() : numbers.size() % dimension != 0)
      throw InvalidOptions("the " + std::string(name) + " have " + std::to_string(numbers.size()) + " numbers: give " +
                           std::to_string(dimension) + " for each configuration");
    for (std::size_t i = 0; i < numbers.size(); ++i)
      if (!std::isfinite(numbers[i]))
        throw InvalidStep("configuration " + std::to_string(i / dimension) + " of the " + name +
                          " holds a number that is not finite: give finite ones");
  }
  std::size_t count() const { return dimension_ > 0 ? numbers_.size() / dimension_ : 0; }
  std::span<const double> operator[](std::size_t i) const { return numbers_.subspan(i * dimension_, dimension_); }

 private:
  const std::span<const double> numbers_;
  const std::size_t dimension_;
};

PathOptions of_edges(const EdgeOptions& asked) { return {asked.min_separation, AtStart::report, asked.tolerance}; }

}  // namespace

template <class Test>
void World::State::for_each_edge(const std::shared_ptr<const LinkageTree>& tree, std::size_t count,
                                 const EdgeOptions& how, const Test& test) {
  const PathOptions asked = of_edges(how);
  tamis::validate(asked);
  for (const BodyId id : tree->bodies) body(id);
  if (!edge_testers_ || !edge_testers_->serve(tree, asked, turns_)) {
    edge_testers_.reset();
    edge_testers_ = std::make_shared<EdgeTesters>(*this, tree, asked);
  }
  Pool<Edges>& edges = edge_testers_->pool;
  for (const auto& each : edges.all()) each->statistics() = {};
  Arena(options).run([&] {
    parallel_for(count, 1, [&](std::size_t i, std::size_t end) {
      const auto mine = edges.take();
      for (; i != end; ++i) try {
          test(*mine, i);
        } catch (const InvalidStep& error) {
          throw InvalidStep("edge " + std::to_string(i) + ": " + error.what());
        }
    });
    statistics.threads = threads_here();
  });
  for (const auto& each : edges.all()) add_statistics(each->statistics());
}

std::vector<bool> World::configurations_are_free(const Linkage& linkage, std::span<const double> configurations,
                                                 const EdgeOptions& asked) {
  const State::QuestionTurn now(*this);
  const Configurations all(configurations, linkage.dimension(), "configurations");
  std::vector<char> free(all.count());
  now->for_each_edge(linkage.tree_, free.size(), asked, [&](State::Edges& edges, std::size_t i) {
    free[i] = edges.is_free(all[i], all[i], asked.starts_are_free);
  });
  return {free.begin(), free.end()};
}

std::vector<bool> World::edges_are_free(const Linkage& linkage, std::span<const double> starts,
                                        std::span<const double> ends, const EdgeOptions& asked) {
  const State::QuestionTurn now(*this);
  const Configurations from(starts, linkage.dimension(), "starts"), to(ends, linkage.dimension(), "ends");
  State::refuse_uneven(from.count(), to.count());
  std::vector<char> free(from.count());
  now->for_each_edge(linkage.tree_, free.size(), asked, [&](State::Edges& edges, std::size_t i) {
    free[i] = edges.is_free(from[i], to[i], asked.starts_are_free);
  });
  return {free.begin(), free.end()};
}

std::vector<EdgeAnswer> World::last_valid(const Linkage& linkage, std::span<const double> starts,
                                          std::span<const double> ends, const EdgeOptions& asked) {
  const State::QuestionTurn now(*this);
  const Configurations from(starts, linkage.dimension(), "starts"), to(ends, linkage.dimension(), "ends");
  State::refuse_uneven(from.count(), to.count());
  std::vector<EdgeAnswer> answers(from.count());
  now->for_each_edge(linkage.tree_, answers.size(), asked, [&](State::Edges& edges, std::size_t i) {
    answers[i] = edges.last_valid(from[i], to[i], asked.starts_are_free);
  });
  return answers;
}

bool World::State::others_stay(const LinkageTree& tree) const {
  return std::ranges::none_of(bodies, [&](const auto& each) {
    return each && each->motion_kind() != MotionKind::still &&
           std::ranges::find(tree.bodies, each->id()) == tree.bodies.end();
  });
}

void World::State::refuse_uneven(std::size_t starts, std::size_t ends) {
  if (starts != ends)
    throw InvalidOptions("there are " + std::to_string(starts) + " starts and " + std::to_string(ends) +
                         " ends: give as many");
}

FirstBadEdge World::first_bad_edge(const Linkage& linkage, std::span<const double> waypoints,
                                   const EdgeOptions& asked) {
  const State::QuestionTurn now(*this);
  const Configurations all(waypoints, linkage.dimension(), "waypoints");
  if (all.count() < 2)
    throw InvalidOptions("there are " + std::to_string(all.count()) + " waypoints: give two or more");
  const std::size_t count = all.count() - 1;
  std::atomic<std::size_t> first = count;
  // Obstacles that move are elsewhere when the next edge begins: what the edge before has proven is not about its
  // start.
  const bool others_stay = now->others_stay(*linkage.tree_);
  const auto is_known = [&](std::size_t i) { return i > 0 ? others_stay : asked.starts_are_free; };
  now->for_each_edge(linkage.tree_, count, asked, [&](State::Edges& edges, std::size_t i) {
    if (i > first || edges.is_free(all[i], all[i + 1], is_known(i))) return;
    std::size_t before = first;
    while (i < before && !first.compare_exchange_weak(before, i)) continue;
  });
  FirstBadEdge found;
  if (first == count) return found;
  found.edge = first;
  now->for_each_edge(linkage.tree_, 1, asked, [&](State::Edges& edges, std::size_t) {
    found.answer = edges.last_valid(all[first], all[first + 1], is_known(first));
  });
  return found;
}

FreeRoadmap World::roadmap(const Linkage& linkage, std::span<const double> configurations,
                           std::span<const std::array<Index, 2>> edges, const EdgeOptions& asked) {
  const State::QuestionTurn now(*this);
  const Configurations all(configurations, linkage.dimension(), "configurations");
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (const Index end : edges[i])
      if (end < 0 || static_cast<std::size_t>(end) >= all.count())
        throw InvalidOptions("edge " + std::to_string(i) + " names the configuration " + std::to_string(end) +
                             ": there are " + std::to_string(all.count()));
  std::vector<char> is_free(all.count()), is_edge_free(edges.size());
  now->for_each_edge(linkage.tree_, is_free.size(), asked, [&](State::Edges& tester, std::size_t i) {
    is_free[i] = tester.is_free(all[i], all[i], asked.starts_are_free);
  });
  now->for_each_edge(linkage.tree_, edges.size(), asked, [&](State::Edges& tester, std::size_t i) {
    const auto from = static_cast<std::size_t>(edges[i][0]), to = static_cast<std::size_t>(edges[i][1]);
    is_edge_free[i] = is_free[from] && is_free[to] && tester.is_free(all[from], all[to], true);
  });
  return {{is_free.begin(), is_free.end()}, {is_edge_free.begin(), is_edge_free.end()}};
}

}  // namespace tamis
