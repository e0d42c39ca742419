#include "paper/command/evaluation/run.hpp"

#include <algorithm>
#include <ctime>
#include <tuple>

#include "command/step_files.hpp"
#include "files/error.hpp"
#include "files/scale_step.hpp"
#include "paper/detector.hpp"

namespace tamis::lab {
namespace {

bool before(const Contact& a, const Contact& b) { return std::tie(a.kind, a.vertices) < std::tie(b.kind, b.vertices); }

using ContactList = std::vector<Contact>;

ContactList united(const ContactList& a, const ContactList& b) {
  ContactList both;
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both), before);
  return both;
}

std::uint64_t count_missing(const ContactList& wanted, const ContactList& there) {
  ContactList missing;
  std::set_difference(wanted.begin(), wanted.end(), there.begin(), there.end(), std::back_inserter(missing), before);
  return missing.size();
}

/// Counts a contact as true if any method reports it, so that a disagreement of one method with all others shows.
void compare(const std::vector<ContactList>& answers, std::vector<MethodResult>& methods) {
  ContactList all;
  for (const ContactList& answer : answers) all = united(all, answer);
  for (std::size_t i = 0; i < methods.size(); ++i) {
    methods[i].missed += count_missing(all, answers[i]);
    methods[i].contacts += answers[i].size();
  }
}

void add_stages(const Statistics& statistics, MethodResult& method) {
  if (method.stages.empty()) {
    method.stages = statistics.stages;
    return;
  }
  for (std::size_t i = 0; i < method.stages.size(); ++i) {
    method.stages[i].vf += statistics.stages[i].vf;
    method.stages[i].ee += statistics.stages[i].ee;
  }
}

/// Time of this process, which runs on one thread. Wall-clock time would depend on other users of the machine.
double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

std::vector<Options> options_of(const std::vector<std::string>& names) {
  std::vector<Options> all(names.size() + 1);
  for (std::size_t i = 0; i < names.size(); ++i) choose_method(all[i], names[i]);
  Options& sieve = all.back();
  sieve.method = Method::paper;
  sieve.paper.filters = sieve_filters();
  for (Options& options : all) options.threads = 1;
  return all;
}

/// The detectors of a scene, the sieve's last; adds what each step costs to the scene's result.
class Contest {
 public:
  Contest(const Mesh& mesh, SceneResult& result) : result_(result) {
    for (const Options& options : options_of(paper_methods())) detectors_.push_back(make_detector(mesh, options));
  }

  /// Asks all methods about one step, one after the other, so that a slow phase of the machine affects all of them.
  void run(const Step& step) {
    const bool is_first = result_.steps++ == 0;
    std::vector<ContactList> answers;
    for (std::size_t i = 0; i < result_.methods.size(); ++i) {
      if (is_first) (void)detectors_[i].contacts(step);
      const double start = processor_seconds();
      const std::span<const Contact> found = detectors_[i].contacts(step);
      result_.methods[i].seconds += processor_seconds() - start;
      answers.emplace_back(found.begin(), found.end());
      add_stages(detectors_[i].statistics(), result_.methods[i]);
    }
    compare(answers, result_.methods);
    (void)detectors_.back().contacts(step);
    add_stages(detectors_.back().statistics(), result_.sieve);
  }

 private:
  SceneResult& result_;
  std::vector<Detector> detectors_;
};

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
  constexpr double kMillisecondsPerSecond = 1e3;
  return kMillisecondsPerSecond * method(name).seconds / static_cast<double>(steps);
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

std::vector<std::string> sieve_filters() {
  return {"dnf", "ncf-published", "ncf", "slab", "sat", "pfs-linear", "pfs-planar"};
}

std::vector<std::size_t> PaperSteps::begins(std::size_t frames) const {
  const auto length = static_cast<std::size_t>(factor);
  const std::size_t count = frames > length ? (frames - 1) / length : 1;
  const std::size_t taken = most == 0 ? count : std::min(most, count);
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < taken; ++i) result.push_back(i * count / taken * length);
  return result;
}

SceneResult run_paper_scene(const SceneFrames& scene, const PaperSteps& steps, const std::function<void()>& step_done) {
  const std::size_t count = scene.frames.size();
  if (count < 2)
    throw io::FileError(scene.frames.front().string(), "", "a single frame does not move: give two or more");
  const auto factor = static_cast<std::size_t>(steps.factor);
  const bool extrapolates = factor >= count;
  const std::size_t length = extrapolates ? count - 1 : factor;
  const io::MeshFile first = cli::read_with_notes(scene.frames.front());
  const auto positions_at = [&](std::size_t i) {
    io::MeshFile frame = io::read_mesh(scene.frames[i]);
    io::require_same_mesh(first, scene.frames.front().string(), frame, scene.frames[i].string());
    return std::move(frame.positions);
  };
  SceneResult result{.scene = scene.name,
                     .factor = steps.factor,
                     .extrapolated = extrapolates,
                     .triangles = first.faces.size(),
                     .steps = 0,
                     .all_steps = extrapolates ? 1 : (count - 1) / length,
                     .methods = {},
                     .sieve = {.method = "sieve", .stages = {}}};
  for (const std::string& name : paper_methods()) result.methods.push_back({.method = name, .stages = {}});
  Contest contest(io::mesh_of(first), result);
  for (const std::size_t begin : steps.begins(count)) {
    const std::vector<Point> start = positions_at(begin);
    std::vector<Point> end = positions_at(begin + length);
    if (extrapolates) io::scale_step(start, end, static_cast<double>(factor) / static_cast<double>(length));
    contest.run({start, end});
    step_done();
  }
  return result;
}

}  // namespace tamis::lab
