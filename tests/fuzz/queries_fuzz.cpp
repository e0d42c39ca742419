// Any bytes through the reader of queries: finite coordinates, or one printable sentence.
#include "fuzz/reader_checks.hpp"
#include "paper/queries/queries.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  tamis::fuzz::check_reader(data, size, [](std::string_view bytes) {
    for (const auto& query : tamis::lab::parse_queries(bytes, tamis::PairKind::edge_edge, "file"))
      for (const auto* points : {&query.start, &query.end}) tamis::fuzz::check_finite(*points);
  });
  return 0;
}
