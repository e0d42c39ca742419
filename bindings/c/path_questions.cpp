// Questions about curved motion.
#include <algorithm>
#include <array>
#include <numeric>
#include <string>
#include <vector>

#include "c/detector.hpp"
#include "c/options.hpp"
#include "c/pair_results.hpp"
#include "c/path.hpp"

namespace tamis::c {
namespace {

/// Runs `work(handle, path, options)`.
template <class Work>
tamis_status ask_on_path(tamis_detector* handle, const tamis_path* path, const tamis_path_options* options,
                         const Work& work) noexcept {
  return with(handle, [&](tamis_detector& h) {
    h.contacts.clear();
    const PathOptions given = path_options_of(read_options(options));
    work(h, made<InvalidPath>(path, "path"), given);
  });
}

template <std::size_t corners>
using Ask = PairResult (*)(const Path&, const std::array<Index, corners>&, const PairOptions&);

template <std::size_t corners>
tamis_status ask_all(tamis_path* handle, const tamis_path_options* options, const int32_t* vertices, std::size_t count,
                     tamis_pair_result* results, std::size_t result_size, Ask<corners> ask) noexcept {
  return with_object(handle, [&](const Path& path) {
    const tamis_path_options given = read_options(options);
    require_report(given.at_start);
    const PairOptions chosen{.min_separation = separation(given.min_separation).value_or(0),
                             .tolerance = path_options_of(given).tolerance,
                             .is_cancelled = cancelling(given.is_cancelled, given.user)};
    check_count(count, "count");
    std::vector<PairResult> answers;
    answers.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
      std::array<Index, corners> pair;
      std::copy_n(&required(vertices, "vertices") + corners * i, corners, pair.begin());
      answers.push_back(ask(path, pair, chosen));
    }
    write_results(answers, results, result_size);
  });
}

}  // namespace
}  // namespace tamis::c

using namespace tamis::c;

tamis_status tamis_detector_contacts_on_path(tamis_detector* detector, const tamis_path* path,
                                             const tamis_path_options* options, size_t* count) {
  return ask_on_path(detector, path, options, [&](auto& handle, const auto& p, const tamis::PathOptions& q) {
    keep_rows(handle.contacts, count, [&] { return handle.object->contacts(p, q); });
  });
}

tamis_status tamis_detector_earliest_on_path(tamis_detector* detector, const tamis_path* path,
                                             const tamis_path_options* options, double* toi_lower, double* toi_upper,
                                             size_t* count) {
  return ask_on_path(detector, path, options, [&](auto& handle, const auto& p, const tamis::PathOptions& q) {
    const FirstTimes times = first_times(toi_lower, toi_upper, count);
    times.write(handle, handle.object->earliest(p, q));
  });
}

tamis_status tamis_detector_is_free_on_path(tamis_detector* detector, const tamis_path* path,
                                            const tamis_path_options* options, int* is_free) {
  return ask_on_path(detector, path, options, [&](auto& handle, const auto& p, const tamis::PathOptions& q) {
    required(is_free, "is_free") = handle.object->is_free(p, q) ? 1 : 0;
  });
}

tamis_status tamis_path_points_at(tamis_path* path, double time, double* points) {
  return with_object(path, [&](const tamis::Path& p) {
    if (!(time >= 0 && time <= 1)) throw InvalidArgument("the time is " + text_of(time) + ": give a number in [0, 1]");
    std::vector<tamis::Index> vertices(static_cast<std::size_t>(p.vertex_count()));
    std::iota(vertices.begin(), vertices.end(), 0);
    std::vector<tamis::Point> answer(vertices.size());
    std::vector<double> errors(vertices.size());
    p.points_at(time, vertices, answer, errors);
    copy_points(answer, &required(points, "points"));
  });
}

tamis_status tamis_path_vertex_face(tamis_path* path, const tamis_path_options* options, size_t count,
                                    const int32_t* vertices, tamis_pair_result* results, size_t result_size) {
  return ask_all<4>(path, options, vertices, count, results, result_size, &tamis::vertex_face);
}

tamis_status tamis_path_edge_edge(tamis_path* path, const tamis_path_options* options, size_t count,
                                  const int32_t* vertices, tamis_pair_result* results, size_t result_size) {
  return ask_all<4>(path, options, vertices, count, results, result_size, &tamis::edge_edge);
}

tamis_status tamis_path_vertex_edge(tamis_path* path, const tamis_path_options* options, size_t count,
                                    const int32_t* vertices, tamis_pair_result* results, size_t result_size) {
  return ask_all<3>(path, options, vertices, count, results, result_size, &tamis::vertex_edge);
}

tamis_status tamis_path_vertex_vertex(tamis_path* path, const tamis_path_options* options, size_t count,
                                      const int32_t* vertices, tamis_pair_result* results, size_t result_size) {
  return ask_all<2>(path, options, vertices, count, results, result_size, &tamis::vertex_vertex);
}
