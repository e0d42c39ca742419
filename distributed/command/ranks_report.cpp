#include "distributed/command/ranks_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <span>

namespace tamis::distributed {
namespace {

using cli::grouped, cli::Json, cli::readable;

cli::Json json_of(const Seconds& s) {
  return {{"positions", s.positions}, {"decompose", s.decompose}, {"borrow", s.borrow}, {"interior", s.interior},
          {"border", s.border},       {"deliver", s.deliver},     {"total", s.total}};
}

}  // namespace

RanksReport::RanksReport(Communicator& communicator, const Detector& detector) : balance_(detector.balance()) {
  Packer packer;
  packer.put(detector.statistics());
  for (const Bytes& bytes : communicator.gather_for_all(packer.take()))
    ranks_.push_back(Unpacker(bytes).get<Statistics>());
}

void RanksReport::print() const {
  fmt::print("\n{:>5} {:>10} {:>10} {:>13} {:>9} {:>13} {:>10} {:>10} {:>10} {:>10}\n", "rank", "owned", "borrowed",
             "pairs tested", "messages", "bytes sent", "interior", "border", "total", "of this");
  for (std::size_t rank = 0; rank < ranks_.size(); ++rank) {
    const Statistics& s = ranks_[rank];
    const double others = s.seconds.positions + s.seconds.decompose + s.seconds.borrow + s.seconds.deliver;
    fmt::print("{:>5} {:>10} {:>10} {:>13} {:>9} {:>13} {:>10} {:>10} {:>10} {:>10}\n", rank, grouped(s.owned),
               grouped(s.borrowed), grouped(s.pairs_tested), grouped(s.messages_sent), grouped(s.bytes_sent),
               readable(s.seconds.interior), readable(s.seconds.border), readable(s.seconds.total), readable(others));
  }
  fmt::print("\nbalance         busiest over mean: pairs {:.2f}, elements {:.2f}; every rank holds {} boxes\n",
             balance_.pairs, balance_.owned, grouped(ranks_.front().boxes));
}

void RanksReport::add_to(Json& json) const {
  json["ranks"] = Json::array();
  for (const Statistics& s : ranks_)
    json["ranks"].push_back({{"owned", s.owned},
                             {"borrowed", s.borrowed},
                             {"pairs_tested", s.pairs_tested},
                             {"boxes", s.boxes},
                             {"messages_sent", s.messages_sent},
                             {"bytes_sent", s.bytes_sent},
                             {"decomposed_anew", s.decomposed_anew},
                             {"seconds", json_of(s.seconds)}});
  json["balance"] = {{"pairs", balance_.pairs}, {"owned", balance_.owned}};
}

cli::Tally tally_of_all(Communicator& communicator, std::span<const Contact> contacts) {
  Packer packer;
  packer.put(cli::tally_of(contacts));
  cli::Tally all;
  for (const Bytes& bytes : communicator.gather_for_all(packer.take())) {
    const auto tally = Unpacker(bytes).get<cli::Tally>();
    all.add_counts(tally);
    all.toi_lower = std::min(all.toi_lower, tally.toi_lower);
    all.toi_upper = std::min(all.toi_upper, tally.toi_upper);
  }
  return all;
}

void print_mesh(const StepParts& parts) {
  fmt::print("mesh            {}, {}\n", cli::counted(parts.vertices, "vertex", "vertices"),
             cli::counted(parts.triangles, "triangle"));
}

void add_facts(Json& json, const StepParts& parts, const Options& options) {
  json["min_separation"] = options.min_separation;
  json["mesh"] = {{"vertices", parts.vertices}, {"triangles", parts.triangles}};
}

}  // namespace tamis::distributed
