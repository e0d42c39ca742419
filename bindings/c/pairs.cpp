#include "c/pairs.hpp"

#include "c/options.hpp"
#include "c/pair_results.hpp"
#include "c/sized.hpp"
#include "c/step.hpp"

namespace tamis::c {
namespace {

std::span<const Point> points_of(const double* rows, std::size_t count, const char* name) {
  if (count == 0) return {};
  return {reinterpret_cast<const Point*>(&required(rows, name)), count};
}

/// Asks about pairs of one kind, each of `corners` points.
template <PairKind kind, std::size_t corners>
tamis_status ask_about(tamis_pairs* pairs, std::size_t count, const double* start, const double* end,
                       tamis_pair_result* results, std::size_t result_size) noexcept {
  return with_object(pairs, [&](const PairOptions& options) {
    check_count(count, "count");
    std::vector<PairResult> answers(count);
    narrow_phase(kind, points_of(start, corners * count, "start"), points_of(end, corners * count, "end"), answers,
                 options);
    write_results(answers, results, result_size);
  });
}

}  // namespace
}  // namespace tamis::c

using namespace tamis::c;

tamis_status tamis_pairs_create(const tamis_pair_options* options, tamis_pairs** pairs) {
  return make_handle(pairs, [&](tamis_pairs& handle) {
    const auto chosen = options ? options_of(read_sized(options, "options")) : tamis::PairOptions{};
    tamis::narrow_phase({}, tamis::Step{}, {}, chosen);  // refuses options out of range
    handle.object = chosen;
  });
}

void tamis_pairs_free(tamis_pairs* pairs) { delete pairs; }

const char* tamis_pairs_message(const tamis_pairs* pairs) { return message_of(pairs); }

tamis_status tamis_vertex_face(tamis_pairs* pairs, size_t count, const double* start, const double* end,
                               tamis_pair_result* results, size_t result_size) {
  return ask_about<tamis::PairKind::vertex_face, 4>(pairs, count, start, end, results, result_size);
}

tamis_status tamis_edge_edge(tamis_pairs* pairs, size_t count, const double* start, const double* end,
                             tamis_pair_result* results, size_t result_size) {
  return ask_about<tamis::PairKind::edge_edge, 4>(pairs, count, start, end, results, result_size);
}

tamis_status tamis_vertex_edge(tamis_pairs* pairs, size_t count, const double* start, const double* end,
                               tamis_pair_result* results, size_t result_size) {
  return ask_about<tamis::PairKind::vertex_edge, 3>(pairs, count, start, end, results, result_size);
}

tamis_status tamis_vertex_vertex(tamis_pairs* pairs, size_t count, const double* start, const double* end,
                                 tamis_pair_result* results, size_t result_size) {
  return ask_about<tamis::PairKind::vertex_vertex, 2>(pairs, count, start, end, results, result_size);
}

tamis_status tamis_narrow_phase(tamis_pairs* pairs, const tamis_feature_pair* list, size_t count,
                                const tamis_step* step, tamis_pair_result* results, size_t result_size) {
  return with_object(pairs, [&](const tamis::PairOptions& own) {
    const tamis_step given = read_sized(step, "step");
    const tamis::PairOptions options = options_for(given, own);
    const auto listed = list_of(list, count);
    write_results(tamis::narrow_phase(listed, step_of(given), options), results, result_size);
  });
}
