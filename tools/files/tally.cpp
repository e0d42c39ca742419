#include "files/tally.hpp"

#include <algorithm>
#include <iterator>

namespace tamis::io {
namespace {

constexpr std::uint64_t Tally::*kOfKind[] = {&Tally::vf, &Tally::ee, &Tally::ve, &Tally::vv};
static_assert(std::size(kOfKind) == kPairKinds, "name each kind of pair");

}  // namespace

Tally tally_of(std::span<const Contact> contacts) {
  Tally tally;
  for (const Contact& c : contacts) {
    ++(tally.*kOfKind[static_cast<std::size_t>(c.kind)]);
    tally.toi_lower = std::min(tally.toi_lower, c.toi_lower);
    if (c.certainty == Certainty::unresolved)
      ++tally.unresolved;
    else
      tally.toi_upper = std::min(tally.toi_upper, c.toi_upper);
  }
  return tally;
}

void Tally::add_counts(const Tally& step) {
  for (const auto of_kind : kOfKind) this->*of_kind += step.*of_kind;
  unresolved += step.unresolved;
}

Json json_of(const Tally& tally) { return {{"vf", tally.vf}, {"ee", tally.ee}, {"ve", tally.ve}, {"vv", tally.vv}}; }

void add_bracket(Json& json, bool is_free, double toi_lower, double toi_upper) {
  json["toi_lower"] = is_free ? Json() : Json(toi_lower);
  json["toi_upper"] = is_free ? Json() : Json(toi_upper);
}

void add_stages(Json& json, std::span<const StageCount> stages) {
  json["stages"] = Json::array();
  for (const StageCount& s : stages)
    json["stages"].push_back({{"name", s.name}, {"vf", s.vf}, {"ee", s.ee}, {"ve", s.ve}, {"vv", s.vv}});
}

}  // namespace tamis::io
