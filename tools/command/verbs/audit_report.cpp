#include "command/verbs/audit_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "command/command_line/messages.hpp"
#include "command/command_line/printable.hpp"
#include "files/system.hpp"

namespace tamis::cli {
namespace {

using audit::FrameAnswer;
using audit::Report;

constexpr std::size_t kFramesPrinted = 20;

std::vector<std::size_t> bad_frames(const Report& report) {
  std::vector<std::size_t> bad;
  for (std::size_t i = 0; i < report.frames.size(); ++i)
    if (report.frames[i].is_bad()) bad.push_back(i);
  return bad;
}

/// The key of a place in Report::by_rings.
std::string name_of_rings(const Report& report, std::size_t place) {
  const auto limit = static_cast<std::size_t>(report.ring_limit);
  if (place < limit) return fmt::format("{}", place + 1);
  return place == limit ? fmt::format(">{}", limit) : "unconnected";
}

void print_row(const Report& report, std::size_t i) {
  const FrameAnswer& frame = report.frames[i];
  fmt::print("{:>7} {:<24} {:>13} {:>11} {:>8} {:>10} {:>14}\n", i, printable(frame.name),
             grouped(frame.intersections()), grouped(frame.contacts()), grouped(frame.fresh), grouped(frame.neighbours),
             frame.contacts() == 0 && frame.toi_lower == 1 ? std::string("end") : no_later(frame.toi_lower));
}

void print_bad(const Report& report, const std::vector<std::size_t>& bad) {
  if (bad.empty()) return;
  fmt::print("\n{:>7} {:<24} {:>13} {:>11} {:>8} {:>10} {:>14}\n", "frame", "name", "intersections", "contacts", "new",
             "neighbours", "free until");
  for (std::size_t i = 0; i < std::min(bad.size(), kFramesPrinted); ++i) print_row(report, bad[i]);
  if (bad.size() > kFramesPrinted)
    fmt::print("and {} more: --json, --out-frames FILE.csv and --out FILE.csv or FILE.html have all\n",
               grouped(bad.size() - kFramesPrinted));
  fmt::print("\n");
}

void print_rings(const Report& report) {
  std::string text;
  for (std::size_t place = 0; place < report.by_rings.size(); ++place)
    if (const std::uint64_t count = report.by_rings[place]; count > 0)
      text += fmt::format("{}{} at {}{}", text.empty() ? "" : ", ", grouped(count), name_of_rings(report, place),
                          place == 0 ? " (neighbours)" : "");
  if (!text.empty()) fmt::print("rings           {}\n", text);
}

/// Pairs that the frame before did not have.
void print_new(const Report& report) {
  const auto first = report.first_new();
  const auto is_new = [](const FrameAnswer& frame) { return frame.fresh > 0; };
  const auto frames = static_cast<std::uint64_t>(std::count_if(report.frames.begin(), report.frames.end(), is_new));
  fmt::print("new             {} in {}, not in the frame before{}\n", grouped(report.fresh), counted(frames, "frame"),
             first ? fmt::format("; first frame {}, {}", *first, printable(report.frames[*first].name)) : "");
}

void print_found(const Report& report, const std::vector<std::size_t>& bad) {
  const auto& [vf, ee, ve, vv, ef] = report.counts;
  const auto count = [&](auto is_counted) {
    return static_cast<std::uint64_t>(std::count_if(report.frames.begin(), report.frames.end(), is_counted));
  };
  const std::uint64_t frames = count([](const FrameAnswer& frame) { return frame.intersections() > 0; });
  const std::uint64_t steps = count([](const FrameAnswer& frame) { return frame.contacts() > 0; });
  fmt::print("intersections   {} in {}\n", grouped(ef), counted(frames, "frame"));
  fmt::print("contacts        {} in {}: {} vertex-face, {} edge-edge{}\n", grouped(vf + ee + ve + vv),
             counted(steps, "step"), grouped(vf), grouped(ee), of_loose_points(ve, vv));
  if (report.collapsed > 0)
    fmt::print("collapsed       objects in {}: the notes say which\n", counted(report.collapsed, "frame"));
  print_rings(report);
  fmt::print("first bad       frame {}, {}\n", bad.front(), printable(report.frames[bad.front()].name));
  print_new(report);
}

Json json_of_frame(const FrameAnswer& frame, std::size_t number) {
  Json json{{"frame", number}, {"name", frame.name}, {"intersections", frame.intersections()}};
  json["contacts"] = {
      {"vf", frame.counts[0]}, {"ee", frame.counts[1]}, {"ve", frame.counts[2]}, {"vv", frame.counts[3]}};
  json["neighbours"] = frame.neighbours;
  json["new"] = frame.fresh;
  json["collapsed"] = frame.has_collapsed;
  add_bracket(json, frame.contacts() == 0 && frame.toi_lower == 1, frame.toi_lower, frame.toi_upper);
  return json;
}

Json json_of(const Report& report, const audit::Finding& pair) {
  std::vector<Index> vertices(pair.vertices.begin(), std::find(pair.vertices.begin(), pair.vertices.end(), -1));
  Json json{{"frame", pair.frame}, {"kind", name_of(pair.kind)}, {"vertices", std::move(vertices)}};
  add_bracket(json, pair.kind == audit::Kind::edge_face, pair.toi_lower, pair.toi_upper);
  json["objects"] = {report.object_name(pair, 0), report.object_name(pair, 1)};
  json["rings"] = pair.rings == audit::kNotConnected ? Json() : Json(pair.rings);
  json["new"] = pair.is_new;
  return json;
}

/// All non-empty sentences, each with its frame.
Json texts(const Report& report, std::string FrameAnswer::*text) {
  Json list = Json::array();
  for (std::size_t i = 0; i < report.frames.size(); ++i)
    if (const std::string& sentence = report.frames[i].*text; !sentence.empty())
      list.push_back({{"frame", i}, {"name", report.frames[i].name}, {"says", sentence}});
  return list;
}

Json rings_of(const Report& report) {
  Json rings = Json::object();
  for (std::size_t place = 0; place < report.by_rings.size(); ++place)
    rings[name_of_rings(report, place)] = report.by_rings[place];
  return rings;
}

}  // namespace

void print_audit(const Report& report, double seconds) {
  const std::vector<std::size_t> bad = bad_frames(report);
  print_bad(report, bad);
  fmt::print("tested          {} and {}{}\n", counted(report.frames.size() - report.problems, "frame"),
             counted(report.steps, "step"),
             report.segments.size() > 1 ? fmt::format(", of {} topologies", report.segments.size()) : "");
  if (bad.empty())
    fmt::print("found           {}\n", report.problems == 0 && !report.ended_by
                                           ? "nothing: all of it is free, proven"
                                           : "nothing in the frames that could be tested");
  else
    print_found(report, bad);
  if (report.pairs_left_out > 0)
    fmt::print("not listed      {} pairs are counted alone: --pairs N lists more\n", grouped(report.pairs_left_out));
  fmt::print("time            {}, {:.1f} frames a second\n", readable(seconds),
             static_cast<double>(report.frames.size()) / seconds);
}

Json audit_json(const Report& report, double seconds) {
  const auto& [vf, ee, ve, vv, ef] = report.counts;
  const auto first = report.first_bad();
  const auto first_new = report.first_new();
  Json json{{"free", report.is_free()},
            {"frames", report.frames.size()},
            {"steps", report.steps},
            {"first_bad", first ? json_of_frame(report.frames[*first], *first) : Json()},
            {"first_new", first_new ? json_of_frame(report.frames[*first_new], *first_new) : Json()},
            {"new", report.fresh},
            {"intersections", ef},
            {"contacts", {{"vf", vf}, {"ee", ee}, {"ve", ve}, {"vv", vv}}},
            {"rings", rings_of(report)},
            {"bad_frames", Json::array()},
            {"pairs", Json::array()},
            {"pairs_left_out", report.pairs_left_out},
            {"problems", texts(report, &FrameAnswer::problem)},
            {"notes", texts(report, &FrameAnswer::note)},
            {"min_separation", report.min_separation},
            {"seconds", {{"total", seconds}}},
            {"peak_memory_bytes", system::peak_memory_bytes()}};
  for (const std::size_t i : bad_frames(report)) json["bad_frames"].push_back(json_of_frame(report.frames[i], i));
  for (const audit::Finding& pair : report.pairs) json["pairs"].push_back(json_of(report, pair));
  return json;
}

void note_frames(const Report& report) {
  std::size_t all = 0;
  const auto say = [&](const FrameAnswer& frame, const std::string& sentence) {
    if (!sentence.empty() && ++all <= kFramesPrinted) note(fmt::format("{}: {}", frame.name, sentence));
  };
  for (const FrameAnswer& frame : report.frames) {
    say(frame, frame.note);
    if (report.first_bad()) say(frame, frame.problem);
  }
  if (all > kFramesPrinted) note(fmt::format("and so on for {} more frames: --json lists all", all - kFramesPrinted));
}

std::string problem_of(const Report& report) {
  const auto first = std::find_if(report.frames.begin(), report.frames.end(),
                                  [](const FrameAnswer& frame) { return !frame.problem.empty(); });
  const std::string more =
      report.problems > 1 ? fmt::format(" (and {} more frames: --json lists them)", report.problems - 1) : "";
  return fmt::format("frame {}, {}: {}{}", first - report.frames.begin(), first->name, first->problem, more);
}

}  // namespace tamis::cli
