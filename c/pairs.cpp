#include <algorithm>

#include "c/options.hpp"
#include "c/pair_results.hpp"

struct tamis_pairs {
  tamis::c::Outcome outcome;
  tamis::PairOptions options;
  bool is_made = false;
};

namespace tamis::c {
namespace {

/// The question about one pair of a kind that has so many points.
template <std::size_t corners>
using Ask = PairResult (*)(const std::array<Point, corners>&, const std::array<Point, corners>&, const PairOptions&);

template <std::size_t corners>
std::array<Point, corners> points_of_pair(const double* rows, std::size_t pair) {
  std::array<Point, corners> points;
  std::copy_n(rows + 3 * corners * pair, 3 * corners, points.front().data());
  return points;
}

struct Lists {
  const double *start, *end;
  PairResults results;
};

template <std::size_t corners>
tamis_status ask_all(tamis_pairs* pairs, const Lists& lists, Ask<corners> ask) noexcept {
  if (!pairs) return TAMIS_INVALID_ARGUMENT;
  if (!pairs->is_made) return pairs->outcome.status();
  return attempt(pairs->outcome, [&] {
    if (lists.results.count == 0) return;
    const double &start = required(lists.start, "start"), &end = required(lists.end, "end");
    write_each(lists.results, [&](std::size_t i) {
      return ask(points_of_pair<corners>(&start, i), points_of_pair<corners>(&end, i), pairs->options);
    });
  });
}

}  // namespace
}  // namespace tamis::c

using namespace tamis::c;

tamis_status tamis_pairs_create(const tamis_pair_options* options, tamis_pairs** pairs) {
  return make_handle(pairs, [&](tamis_pairs& handle) {
    if (options) handle.options = options_of(read_sized(options, "options"));
    tamis::vertex_face({}, {}, handle.options);  // refuses options out of range
    handle.is_made = true;
  });
}

void tamis_pairs_free(tamis_pairs* pairs) { delete pairs; }

const char* tamis_pairs_message(const tamis_pairs* pairs) { return pairs ? pairs->outcome.message() : ""; }

tamis_status tamis_vertex_face(tamis_pairs* pairs, size_t count, const double* start, const double* end,
                               tamis_pair_result* results, size_t result_size) {
  return ask_all<4>(pairs, {start, end, {count, results, result_size}}, &tamis::vertex_face);
}

tamis_status tamis_edge_edge(tamis_pairs* pairs, size_t count, const double* start, const double* end,
                             tamis_pair_result* results, size_t result_size) {
  return ask_all<4>(pairs, {start, end, {count, results, result_size}}, &tamis::edge_edge);
}

tamis_status tamis_vertex_edge(tamis_pairs* pairs, size_t count, const double* start, const double* end,
                               tamis_pair_result* results, size_t result_size) {
  return ask_all<3>(pairs, {start, end, {count, results, result_size}}, &tamis::vertex_edge);
}

tamis_status tamis_vertex_vertex(tamis_pairs* pairs, size_t count, const double* start, const double* end,
                                 tamis_pair_result* results, size_t result_size) {
  return ask_all<2>(pairs, {start, end, {count, results, result_size}}, &tamis::vertex_vertex);
}
