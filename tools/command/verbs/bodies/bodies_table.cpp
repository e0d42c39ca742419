#include "command/verbs/bodies/bodies_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "command/answers.hpp"
#include "command/command_line/verb.hpp"
#include "files/system.hpp"

namespace tamis::cli {
namespace {

std::optional<BodyContact> first_of(const std::vector<BodyContact>& contacts) {
  const auto first = std::min_element(contacts.begin(), contacts.end(),
                                      [](const auto& a, const auto& b) { return a.toi_lower < b.toi_lower; });
  return first == contacts.end() ? std::nullopt : std::optional(*first);
}

Tally tally_of_bodies(const std::vector<BodyContact>& contacts) {
  return tally_of(std::vector<Contact>(contacts.begin(), contacts.end()));
}

std::array<std::string, 2> names_of(const BodyContact& contact, const std::vector<std::string>& names) {
  return {names[static_cast<std::size_t>(contact.bodies[0])], names[static_cast<std::size_t>(contact.bodies[1])]};
}

}  // namespace

void BodiesTable::print_bodies() const {
  fmt::print("bodies          {} static, {} rigid, {} deforming, with {}\n", grouped(bodies_.count_of(false, false)),
             grouped(bodies_.count_of(true, false)), grouped(bodies_.count_of(true, true)),
             counted(bodies_.triangle_count(), "triangle"));
}

int BodiesTable::refuse(const StartCheck& start) const {
  if (json_) {
    Json json{{"free", false}};
    start.add_refused_to(json, bodies_.names());
    print_json(json);
  } else {
    print_bodies();
    start.print_refused(bodies_.names());
  }
  return kNo;
}

void BodiesTable::print_head() const {
  if (json_) return;
  print_bodies();
  if (!is_one())
    fmt::print("\n{:>5} {:>11} {:>11} {:>14} {:>10}\n", "step", "vertex-face", "edge-edge", "free until", "time");
}

void BodiesTable::add(const std::vector<BodyContact>& contacts, const Statistics& statistics, const Timing& timing) {
  const Tally tally = tally_of_bodies(contacts);
  const std::optional<BodyContact> first = first_of(contacts);
  ++steps_asked_;
  const bool is_free = !first && !bodies_.leaves_out();
  free_steps_ += is_free ? 1 : 0;
  if (!is_free && !first_not_free_) first_not_free_ = steps_asked_;
  if (first && !first_) first_ = {steps_asked_, *first};
  total_.add_counts(tally);
  timing_ += timing;
  if (json_)
    steps_.push_back(step_json(tally, first, statistics, timing));
  else if (is_one())
    print_tally(tally, !bodies_.leaves_out());
  else
    print_row(tally, timing);
}

void BodiesTable::print_row(const Tally& tally, const Timing& timing) const {
  fmt::print("{:>5} {:>11} {:>11} {:>14} {:>10}{}\n", steps_asked_, grouped(tally.vf), grouped(tally.ee),
             bodies_.leaves_out() ? "0"
             : tally.is_free()    ? std::string("end")
                                  : no_later(tally.toi_lower),
             readable(timing.warm.total), of_loose_points(tally.ve, tally.vv));
  std::fflush(stdout);
}

Json BodiesTable::step_json(const Tally& tally, const std::optional<BodyContact>& contact, const Statistics& statistics,
                            const Timing& timing) const {
  Json json{{"step", steps_asked_}, {"contacts", json_of(tally)}, {"unresolved", tally.unresolved}};
  const bool is_of_all = !bodies_.leaves_out();
  add_bracket(json, tally.is_free() && is_of_all, is_of_all ? tally.toi_lower : 0, tally.toi_upper);
  json["collapsed"] = !is_of_all;
  json["contact"] = contact ? json_of(*contact) : Json();
  if (contact) json["contact"]["bodies"] = names_of(*contact, bodies_.names());
  json["ignored"] = statistics.ignored;
  json["seconds"] = json_of(timing.warm);
  json["seconds_cold"] = json_of(timing.cold);
  return json;
}

Json BodiesTable::totals_json(const Options& options, const Statistics& statistics, const StartCheck& start) {
  Json json{{"free", is_free()},
            {"bodies",
             {{"static", bodies_.count_of(false, false)},
              {"rigid", bodies_.count_of(true, false)},
              {"deforming", bodies_.count_of(true, true)}}},
            {"triangles", bodies_.triangle_count()},
            {"steps", std::move(steps_)},
            {"contacts", json_of(total_)},
            {"unresolved", total_.unresolved},
            {"free_steps", free_steps_},
            {"first_not_free", first_not_free_ ? Json(*first_not_free_) : Json()},
            {"seconds", {{"total", timing_.warm.total}}},
            {"peak_memory_bytes", system::peak_memory_bytes()},
            {"threads", statistics.threads},
            {"min_separation", options.min_separation},
            {"isa", name_of(statistics.isa)}};
  start.add_to(json);
  return json;
}

void BodiesTable::print_totals(const Options& options, const Statistics& statistics, const StartCheck& start,
                               int repeat) {
  if (json_) return print_json(totals_json(options, statistics, start));
  if (!is_one())
    fmt::print("{:>5} {:>11} {:>11} {:>14} {:>10}{}\n", "total", grouped(total_.vf), grouped(total_.ee),
               fmt::format("{}/{} free", free_steps_, steps_asked_), readable(timing_.warm.total),
               of_loose_points(total_.ve, total_.vv));
  if (first_not_free_ && !is_one()) fmt::print("\nfirst not free  step {}\n", *first_not_free_);
  if (first_ && first_->step == first_not_free_)
    print_contact(first_->contact, names_of(first_->contact, bodies_.names()));
  if (is_one()) print_ignored(statistics);
  if (is_free()) start.print_for_bodies();
  if (is_one()) print_costs(statistics, timing_, repeat);
}

}  // namespace tamis::cli
