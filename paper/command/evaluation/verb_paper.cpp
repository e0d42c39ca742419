// tamis-lab paper: the seed paper's evaluation, from the scenes to the report, in one command.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "command/command_line/messages.hpp"
#include "command/command_line/option_list.hpp"
#include "command/command_line/printable.hpp"
#include "command/output_file.hpp"
#include "command/progress.hpp"
#include "files/atomic_file.hpp"
#include "files/mesh/frames.hpp"
#include "paper/command/evaluation/earlier.hpp"
#include "paper/command/evaluation/pictures.hpp"
#include "paper/command/evaluation/run.hpp"
#include "paper/command/evaluation/tables.hpp"
#include "paper/command/verbs.hpp"
#include "scenes/simulation/recording.hpp"
#include "tamis/error.hpp"

namespace tamis::lab {
namespace {

namespace files = std::filesystem;

/// A row of the paper's Table 1, or the larger funnel.
struct Row {
  std::string_view name, scene;
  Index full_triangles, quick_triangles;  ///< approximate; without a quick size, --quick leaves the row out
};

constexpr std::array kRows{Row{"airbag", "airbag", 18'000, 1'500}, Row{"cloth-ball", "cloth-ball", 92'000, 3'000},
                           Row{"funnel", "funnel", 18'000, 2'000}, Row{"funnel-92k", "funnel", 92'000, 0},
                           Row{"bunny", "bunny", 4'000, 1'200}};

class Paper final : public cli::Verb {
 public:
  const char* name() const override { return "paper"; }
  const char* summary() const override { return "Repeats the paper's evaluation: tables, figures, report"; }
  const char* examples() const override {
    return "  tamis-lab paper --quick --out laboratory\n"
           "  tamis-lab paper --out laboratory --frames ball=frames/ball --frames bunny=frames/bunny\n"
           "  tamis-lab paper --out laboratory --scenes none --frames ball=frames/ball\n\n"
           "Simulated frames go to FOLDER/frames/SCENE and are used again by the next run. A folder of frames given\n"
           "under the name of a scene takes its place.";
  }
  void declare(cli::OptionList& options) override {
    options.add_text("--out", folder_, "the folder of the report; made if it is not there")
        .shown_as("FOLDER")
        .required();
    options.add_flag("--quick", quick_, "small variants of the scenes, for minutes instead of hours");
    options
        .add_texts("--frames", given_, "frames that are there already: a folder, under a name of its own; repeatable")
        .shown_as("NAME=FOLDER");
    options.add_names("--scenes", scenes_, "only these of airbag, cloth-ball, funnel, funnel-92k, bunny; or none");
    options.add_number("--length", "N", length_, {1, 9999},
                       "frames simulated after the first; default: the whole scene");
    options
        .add_texts(
            "--steps", most_steps_,
            "run at most so many steps of a scene at each length of step, evenly spread; repeatable; default: all")
        .shown_as("NAME=N");
    options.add_flag("--resume", resumes_, "take the rows that an interrupted run of the same command has finished");
  }

  int run() override {
    require_known_scenes();
    std::vector<SceneFrames> given_scenes;  // read before anything is simulated, as a path may be wrong
    for (const std::string& pair : given_) given_scenes.push_back(given(pair));
    require_scenes_of_steps();
    io::make_folder(folder_);
    require_outputs(given_scenes);
    if (resumes_) earlier_.emplace(folder_);
    std::vector<SceneFrames> scenes;
    for (const Row& row : kRows)
      if (wants(row)) scenes.push_back(simulated(row));
    scenes.insert(scenes.end(), given_scenes.begin(), given_scenes.end());
    for (const SceneFrames& scene : scenes)
      for (const int factor : {1, 3}) measure(scene, factor);
    write_paper_report(folder_, results_, size());
    const std::string why = draw_pictures(folder_);
    if (!why.empty()) cli::note("no pictures, only their tables: " + why);
    fmt::print("report          {}\n", cli::printable((files::path(folder_) / "report.md").string()));
    for (const SceneResult& result : results_)
      if (!result.sets_agree()) return cli::kNo;
    return cli::kSuccess;
  }

 private:
  void require_known_scenes() const {
    for (const std::string& name : scenes_) {
      bool is_known = name == "none";
      for (const Row& row : kRows) is_known = is_known || row.name == name;
      if (!is_known)
        throw InvalidOptions(
            fmt::format("no scene is called '{}': use airbag, cloth-ball, funnel, funnel-92k, bunny or none", name));
    }
  }

  bool wants(const Row& row) const {
    for (const std::string& pair : given_)
      if (name_of(pair) == row.name) return false;
    for (const std::string& name : scenes_)
      if (name == row.name) return true;
    return scenes_.empty() && (!quick_ || row.quick_triangles > 0);
  }

  SceneFrames simulated(const Row& row) const {
    const simulation::SimulatedScene& scene = simulation::simulated_scene(row.scene);
    const int count = length_ > 0 ? length_ : scene.frames;
    const files::path folder = files::path(folder_) / "frames" / row.name;
    const Index triangles = quick_ && row.quick_triangles > 0 ? row.quick_triangles : row.full_triangles;
    cli::Progress progress(static_cast<std::size_t>(count), "frames");
    simulation::record(scene, {folder, count, triangles, 1}, [&](const simulation::Simulator& simulator) {
      progress.show(static_cast<std::size_t>(simulator.frame()));
    });
    SceneFrames made{std::string(row.name), {}};
    for (int i = 0; i <= count; ++i) made.frames.push_back(simulation::frame_path(folder, i));
    return made;
  }

  static SceneFrames given(const std::string& pair) {
    const std::string name = name_of(pair);
    if (name.empty()) throw InvalidOptions(fmt::format("--frames {} names no scene: write NAME=FOLDER", pair));
    // The name becomes a cell of tables, in CSV and in Markdown.
    if (name.find_first_of(",\"|`\n\r") != std::string::npos || cli::printable(name) != name)
      throw InvalidOptions(
          fmt::format("--frames {}: the name holds a comma, quote, bar or control character: leave it out", pair));
    return {name, io::frame_files({value_of(pair)})};
  }

  void require_outputs(const std::vector<SceneFrames>& given_scenes) const {
    std::vector<files::path> inputs;
    for (const SceneFrames& scene : given_scenes) inputs.insert(inputs.end(), scene.frames.begin(), scene.frames.end());
    for (const char* name : {"report.md", "table1.csv", "stages.csv", "table1.png", "fig4.png", "fig5.png"})
      cli::require_output(files::path(folder_) / name, inputs, false);
  }

  /// 0: all.
  std::size_t most_steps(const std::string& scene) const {
    for (const std::string& pair : most_steps_)
      if (name_of(pair) == scene) return steps_in(pair);
    return 0;
  }

  static std::size_t steps_in(const std::string& pair) {
    return number_from("--steps " + pair, value_of(pair), cli::NumberRange<std::uint64_t>{.least = 1});
  }

  std::vector<std::string> names_to_run() const {
    std::vector<std::string> names;
    for (const Row& row : kRows)
      if (wants(row)) names.emplace_back(row.name);
    for (const std::string& pair : given_) names.push_back(name_of(pair));
    return names;
  }

  void require_scenes_of_steps() const {
    const std::vector<std::string> names = names_to_run();
    if (names.empty()) throw InvalidOptions("there is no scene to run: give --scenes or --frames");
    for (const std::string& pair : most_steps_) {
      const std::string name = name_of(pair);
      if (name.empty()) throw InvalidOptions(fmt::format("--steps {} names no scene: write NAME=N", pair));
      steps_in(pair);
      if (std::find(names.begin(), names.end(), name) == names.end())
        throw InvalidOptions(
            fmt::format("--steps {} names a scene that is not run: use one of {}", pair, fmt::join(names, ", ")));
    }
  }

  /// The name in NAME=VALUE; empty if there is none.
  static std::string name_of(const std::string& pair) {
    const std::size_t sign = pair.find('=');
    return sign == std::string::npos ? "" : pair.substr(0, sign);
  }
  static std::string value_of(const std::string& pair) { return pair.substr(pair.find('=') + 1); }

  /// Runs one scene, or takes its earlier result. Writes the tables again, so that an interrupted run keeps its rows.
  void measure(const SceneFrames& scene, int factor) {
    const PaperSteps steps{factor, most_steps(scene.name)};
    cli::Progress progress(steps.begins(scene.frames.size()).size(), "steps");
    std::size_t done = 0;
    const SceneResult* earlier = earlier_ ? earlier_->find(scene.name, factor) : nullptr;
    results_.push_back(earlier ? *earlier : run_paper_scene(scene, steps, [&] { progress.show(++done); }));
    progress.clear();
    const SceneResult& r = results_.back();
    fmt::print("{:<12} {}x  paper {:>9.2f} ms a frame, default {:>9.2f}, {}\n", r.scene, factor,
               r.milliseconds("paper"), r.milliseconds("tamis"), r.sets_agree() ? "sets agree" : "SETS DIFFER");
    std::fflush(stdout);
    write_tables();
  }

  /// Writes this run's rows, and those of an earlier run that this one has not reached yet: an interruption loses no
  /// row. Writes the stages first, because a row in the table means that its stages are there.
  void write_tables() const {
    std::vector<SceneResult> rows = results_;
    const bool is_last = rows.size() == 2 * names_to_run().size();
    if (earlier_ && !is_last) earlier_->append_rest(rows);
    write_paper_stages(folder_, rows);
    write_paper_table(folder_, rows);
  }

  std::string size() const {
    std::string text = quick_ ? "**Quick size**: small variants of the scenes, not the paper's triangle counts."
                              : "Simulated scenes, where there are any, at full size: the paper's triangle counts.";
    if (length_ > 0) text += fmt::format(" Only the first {} frames of each simulated scene.", length_);
    for (const std::string& pair : most_steps_)
      text += fmt::format(" `{}`: at most {} steps of each length, evenly spread.", name_of(pair), value_of(pair));
    for (const std::string& pair : given_)
      text += fmt::format(" `{}`: frames that were given, not simulated here.", name_of(pair));
    return text;
  }

  std::string folder_;
  bool quick_ = false;
  std::vector<std::string> given_, scenes_;
  std::vector<std::string> most_steps_;
  bool resumes_ = false;
  std::optional<EarlierResults> earlier_;
  int length_ = 0;
  std::vector<SceneResult> results_;
};

}  // namespace

std::unique_ptr<cli::Verb> make_paper() { return std::make_unique<Paper>(); }

}  // namespace tamis::lab
