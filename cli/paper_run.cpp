#include "cli/paper_run.hpp"

#include <algorithm>
#include <array>
#include <tuple>

#include "cli/step_files.hpp"
#include "io/error.hpp"
#include "tamis/detector.hpp"

namespace tamis::cli {
namespace {

bool before(const Contact& a, const Contact& b) { return std::tie(a.kind, a.vertices) < std::tie(b.kind, b.vertices); }

using Contacts = std::vector<Contact>;

Contacts united(const Contacts& a, const Contacts& b) {
  Contacts both;
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both), before);
  return both;
}

std::uint64_t count_missing(const Contacts& wanted, const Contacts& there) {
  Contacts missing;
  std::set_difference(wanted.begin(), wanted.end(), there.begin(), there.end(), std::back_inserter(missing), before);
  return missing.size();
}

/// A contact is true if any method certifies it, so a method that all others disagree with shows.
void compare(const std::vector<Contacts>& answers, std::vector<MethodResult>& methods) {
  Contacts certified;
  for (const Contacts& answer : answers) {
    Contacts sure;
    std::copy_if(answer.begin(), answer.end(), std::back_inserter(sure),
                 [](const Contact& c) { return c.certainty == Certainty::certified; });
    certified = united(certified, sure);
  }
  for (std::size_t i = 0; i < methods.size(); ++i) {
    methods[i].missed += count_missing(certified, answers[i]);
    methods[i].extra += count_missing(answers[i], certified);
    methods[i].contacts += answers[i].size();
    methods[i].unresolved += static_cast<std::uint64_t>(std::count_if(
        answers[i].begin(), answers[i].end(), [](const Contact& c) { return c.certainty == Certainty::unresolved; }));
  }
}

void add_costs(const Statistics& statistics, MethodResult& method) {
  method.seconds += statistics.seconds.total - statistics.seconds.build;
  if (method.stages.empty()) {
    method.stages = statistics.stages;
    return;
  }
  for (std::size_t i = 0; i < method.stages.size(); ++i) {
    method.stages[i].vf += statistics.stages[i].vf;
    method.stages[i].ee += statistics.stages[i].ee;
  }
}

std::vector<Detector> detectors_of(const Mesh& mesh, const std::vector<std::string>& names) {
  std::vector<Detector> detectors;
  for (const std::string& name : names) {
    Options options;
    choose_method(options, name);
    options.threads = 1;
    detectors.emplace_back(mesh, options);
  }
  return detectors;
}

/// The methods take turns within a step, so that a slow phase of the machine is shared by all.
void run_step(const Step& step, std::vector<Detector>& detectors, std::vector<MethodResult>& methods) {
  std::vector<Contacts> answers;
  for (std::size_t i = 0; i < detectors.size(); ++i) {
    answers.push_back(detectors[i].contacts(step));
    add_costs(detectors[i].statistics(), methods[i]);
  }
  compare(answers, methods);
}

}  // namespace

std::uint64_t MethodResult::entering(std::string_view stage) const {
  for (const StageCount& count : stages)
    if (count.name == stage) return count.vf + count.ee;
  return 0;
}

std::uint64_t MethodResult::elementary_tests() const {
  constexpr std::string_view kOfTamis = "solve", kOfThePaper = "newton";
  return entering(kOfTamis) + entering(kOfThePaper);
}

std::uint64_t MethodResult::false_pairs() const { return elementary_tests() - std::min(contacts, elementary_tests()); }

const MethodResult& SceneResult::method(std::string_view name) const {
  return *std::find_if(methods.begin(), methods.end(), [&](const MethodResult& m) { return m.method == name; });
}

double SceneResult::milliseconds(std::string_view name) const {
  constexpr double kMillisecondsASecond = 1e3;
  return kMillisecondsASecond * method(name).seconds / static_cast<double>(steps);
}

bool SceneResult::sets_agree() const {
  return std::all_of(methods.begin(), methods.end(), [](const MethodResult& m) { return m.missed == 0; });
}

std::vector<std::string> paper_methods() {
  std::vector<std::string> names;
  for (const std::string_view name : method_choices()) {
    const bool is_too_slow = name == name_of(Method::brute);
    const bool is_there_twice = name == "paper-dnf-ncf";
    if (!is_too_slow && !is_there_twice) names.emplace_back(name);
  }
  return names;
}

SceneResult run_paper_scene(const PaperScene& scene, int factor, const std::function<void()>& step_done) {
  const std::size_t count = scene.frames.size();
  if (count < 2)
    throw io::FileError(scene.frames.front().string(), "", "a single frame does not move: give two or more");
  const bool extrapolates = static_cast<std::size_t>(factor) >= count;
  const std::size_t stride = extrapolates ? count - 1 : static_cast<std::size_t>(factor);
  io::MeshFile first = read_with_notes(scene.frames.front());
  std::vector<Point> start = first.positions;
  SceneResult result{scene.name, factor, extrapolates, first.faces.size(), 0, {}};
  for (const std::string& name : paper_methods()) result.methods.push_back({.method = name, .stages = {}});
  std::vector<Detector> detectors = detectors_of(io::mesh_of(first), paper_methods());
  for (std::size_t i = stride; i < count; i += stride) {
    io::MeshFile frame = io::read_mesh(scene.frames[i]);
    io::require_same_mesh(first, scene.frames.front().string(), frame, scene.frames[i].string());
    std::vector<Point> end = frame.positions;
    if (extrapolates) scale_step(start, end, static_cast<double>(factor) / static_cast<double>(stride));
    run_step({start, end}, detectors, result.methods);
    ++result.steps;
    start = std::move(frame.positions);
    step_done();
  }
  return result;
}

}  // namespace tamis::cli
