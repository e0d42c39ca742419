#include "paper/command/query_score.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>

namespace tamis::lab {
namespace {

PairResult ask(const Query& query, const PairOptions& options) {
  return query.kind == PairKind::vertex_face ? vertex_face(query.start, query.end, options)
                                             : edge_edge(query.start, query.end, options);
}

PairResult ask(const RigidQuery& query, const PairOptions& options) {
  constexpr std::array<Index, 4> kVertices{0, 1, 2, 3};
  return query.kind == PairKind::vertex_face ? vertex_face(query.path(), kVertices, options)
                                             : edge_edge(query.path(), kVertices, options);
}

PairResult ask(const SingleQuery& query, const PairOptions& options) {
  return std::visit([&](const auto& q) { return ask(q, options); }, query);
}

double nanoseconds_of(const SingleQuery& query, const PairOptions& options, PairResult& result) {
  const auto start = std::chrono::steady_clock::now();
  result = ask(query, options);
  return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count();
}

double at_rank(const std::vector<double>& sorted, double fraction) {
  return sorted[static_cast<std::size_t>(fraction * static_cast<double>(sorted.size() - 1))];
}

}  // namespace

void QueryScore::add(const SingleQuery& query, const PairResult& result) {
  const std::optional<bool> touches = std::visit([](const auto& q) { return q.touches; }, query);
  const bool is_unresolved = result.touches && result.certainty == Certainty::unresolved;
  ++queries;
  contacts += result.touches;
  unresolved += is_unresolved;
  if (!touches) return;
  ++labelled;
  false_positives += result.touches && !*touches;
  false_positives_certified += result.touches && !*touches && !is_unresolved;
  false_negatives += !result.touches && *touches;
}

void QueryScore::add(const QueryScore& other) {
  queries += other.queries;
  labelled += other.labelled;
  contacts += other.contacts;
  false_positives += other.false_positives;
  false_positives_certified += other.false_positives_certified;
  false_negatives += other.false_negatives;
  unresolved += other.unresolved;
  nanoseconds.insert(nanoseconds.end(), other.nanoseconds.begin(), other.nanoseconds.end());
}

Percentiles percentiles_of(std::vector<double> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  constexpr double kHalf = 0.5, kNearlyAll = 0.99;
  return {std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size()),
          at_rank(values, kHalf), at_rank(values, kNearlyAll), values.back()};
}

QueryScore answer(const std::vector<SingleQuery>& queries, const PairOptions& options, int repeat,
                  std::vector<PairResult>& results) {
  QueryScore score;
  PairResult result;
  for (const SingleQuery& query : queries) {
    results.push_back(ask(query, options));
    score.add(query, results.back());
  }
  std::vector<std::vector<double>> times(queries.size());
  for (int pass = 0; pass < repeat; ++pass)
    for (std::size_t i = 0; i < queries.size(); ++i) times[i].push_back(nanoseconds_of(queries[i], options, result));
  for (auto& of_query : times) {
    const auto middle = of_query.begin() + static_cast<std::ptrdiff_t>(of_query.size() / 2);
    std::nth_element(of_query.begin(), middle, of_query.end());
    score.nanoseconds.push_back(*middle);
  }
  return score;
}

}  // namespace tamis::lab
