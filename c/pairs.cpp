#include <algorithm>
#include <string>

#include "c/options.hpp"
#include "c/sized.hpp"
#include "tamis/pair.hpp"

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

tamis_pair_result result_of(const PairResult& r) {
  tamis_pair_result result{
      r.touches ? 1 : 0, static_cast<int32_t>(r.certainty), r.toi_lower, r.toi_upper, r.u, r.v, {}};
  std::copy(r.normal.begin(), r.normal.end(), result.normal);
  return result;
}

struct Lists {
  std::size_t count;
  const double *start, *end;
  void* results;
  std::size_t result_size;
};

template <std::size_t corners>
tamis_status ask_all(tamis_pairs* pairs, const Lists& lists, Ask<corners> ask) noexcept {
  if (!pairs) return TAMIS_INVALID_ARGUMENT;
  if (!pairs->is_made) return pairs->outcome.status();
  return attempt(pairs->outcome, [&] {
    if (lists.count == 0) return;
    const double &start = required(lists.start, "start"), &end = required(lists.end, "end");
    required(static_cast<unsigned char*>(lists.results), "results");
    check_size(lists.result_size, sizeof(int32_t), "result");
    for (std::size_t i = 0; i < lists.count; ++i) try {
        const PairResult r = ask(points_of_pair<corners>(&start, i), points_of_pair<corners>(&end, i), pairs->options);
        write_element(result_of(r), lists.results, i, lists.result_size);
      } catch (const InvalidStep& e) {
        throw InvalidStep("pair " + std::to_string(i) + ": " + e.what());
      }
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
  return ask_all<4>(pairs, {count, start, end, results, result_size}, &tamis::vertex_face);
}

tamis_status tamis_edge_edge(tamis_pairs* pairs, size_t count, const double* start, const double* end,
                             tamis_pair_result* results, size_t result_size) {
  return ask_all<4>(pairs, {count, start, end, results, result_size}, &tamis::edge_edge);
}

tamis_status tamis_vertex_edge(tamis_pairs* pairs, size_t count, const double* start, const double* end,
                               tamis_pair_result* results, size_t result_size) {
  return ask_all<3>(pairs, {count, start, end, results, result_size}, &tamis::vertex_edge);
}

tamis_status tamis_vertex_vertex(tamis_pairs* pairs, size_t count, const double* start, const double* end,
                                 tamis_pair_result* results, size_t result_size) {
  return ask_all<2>(pairs, {count, start, end, results, result_size}, &tamis::vertex_vertex);
}
