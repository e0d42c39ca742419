// tamis bodies: the contacts of bodies that stay, move as a whole, or deform.
#include <fmt/format.h>

#include <array>
#include <memory>
#include <optional>
#include <string_view>

#include "command/command_line/arguments.hpp"
#include "command/command_line/verb.hpp"
#include "command/output_file.hpp"
#include "command/progress.hpp"
#include "command/start_check.hpp"
#include "command/step_files.hpp"
#include "command/verbs/bodies/bodies_film.hpp"
#include "command/verbs/bodies/bodies_table.hpp"
#include "files/bodies/bodies_csv.hpp"
#include "files/format.hpp"

namespace tamis::cli {
namespace {

constexpr std::array<std::string_view, 2> kShownAs{"csv", "html"};

class Bodies final : public Verb {
 public:
  const char* name() const override { return "bodies"; }
  const char* summary() const override {
    return "Contacts of bodies, static, rigid or deforming, in each step of a file. Exit code 0: every step is free, "
           "1: "
           "contact, 2: error";
  }
  const char* examples() const override {
    return "  tamis bodies throw.json\n"
           "  tamis bodies throw.json --out contacts.csv\n"
           "  tamis bodies throw.json --out throw.html\n"
           "  tamis bodies throw.json --first --out firsts.csv\n"
           "  tamis bodies throw.json --check-start\n"
           "  tamis bodies throw.json --min-separation 1e-3 --at-start ignore --json";
  }

  void declare(OptionList& options) override {
    options.add_path("SCENE", path_, "JSON: bodies, their meshes and how they move; see docs/files-and-command.md")
        .required();
    detector_.declare_for_bodies(options);
    at_start_.declare(options);
    start_.declare_for_bodies(options);
    options.add_flag("--first", first_,
                     "of each step and pair of bodies the first contact alone, which is sooner known");
    declare_output(options, out_, "the contacts of all steps: a table (.csv), or a page that shows them (.html)");
    declare_repeat(options, repeat_);
    declare_json(options, json_);
  }

  int run() override {
    detector_.check();
    const PathOptions own{.at_start = at_start_.own().at_start};
    MovingBodies bodies(path_);
    require_output(out_, bodies.inputs(), true);
    const bool is_film = !out_.empty() && io::format_of(out_, kShownAs) == 1;
    World world = asked_of(step_text(1), [&] { return bodies.world(detector_.options()); });
    BodiesTable table(bodies, json_);
    bodies.leave_out_collapsed(world);
    if (!start_.passes(world)) return table.refuse(start_);
    std::optional<io::BodiesCsv> csv;
    std::optional<BodiesFilm> film;
    if (is_film)
      film.emplace(bodies, detector_.options(), own.at_start);
    else if (!out_.empty())
      csv.emplace(out_);
    table.print_head();
    Progress progress(bodies.step_count(), "steps");
    for (std::size_t step = 1; step <= bodies.step_count(); ++step) {
      std::vector<BodyContact> contacts;
      const Timing timing = asked_of(step_text(step), [&] {
        if (step > 1) {
          bodies.go_on(world);
          bodies.leave_out_collapsed(world);
        }
        return ask_repeatedly(world, repeat_,
                              [&] { contacts = first_ ? world.first_contacts(own) : world.contacts(own); });
      });
      if (csv) csv->add(step, contacts, bodies.names());
      if (film) film->add(step, contacts, world.statistics().ignored);
      progress.clear();
      table.add(contacts, world.statistics(), timing);
      progress.show(step);
    }
    progress.clear();
    if (csv) csv->commit();
    if (film) film->write(out_);
    table.print_totals(detector_.options(), world.statistics(), start_, repeat_);
    return table.is_free() ? kSuccess : kNo;
  }

 private:
  /// For sentences of the library, which knows bodies by their numbers.
  std::string step_text(std::size_t step) const {
    return fmt::format("{}: step {}, bodies counted from 0", path_.string(), step);
  }

  std::filesystem::path path_, out_;
  int repeat_ = 1;
  bool first_ = false, json_ = false;
  DetectorArguments detector_;
  AtStartArgument at_start_;
  StartCheck start_;
};

}  // namespace

std::unique_ptr<Verb> make_bodies() { return std::make_unique<Bodies>(); }

}  // namespace tamis::cli
