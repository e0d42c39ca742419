// tamis audit: is a recorded motion free, and if not, where?
#include <fmt/format.h>

#include <chrono>
#include <memory>

#include "audit/audit.hpp"
#include "command/command_line/arguments.hpp"
#include "command/command_line/messages.hpp"
#include "command/command_line/printable.hpp"
#include "command/command_line/verb.hpp"
#include "command/output_file.hpp"
#include "command/progress.hpp"
#include "command/step_files.hpp"
#include "command/verbs/audit_report.hpp"
#include "command/verbs/moving_frames.hpp"
#include "files/format.hpp"
#include "files/mesh/frames.hpp"
#include "files/mesh/mesh_formats.hpp"
#include "files/motion/motion.hpp"
#include "files/motion/welded_frames.hpp"
#include "files/output/audit_csv.hpp"
#include "files/view/audit_page.hpp"

namespace tamis::cli {
namespace {

constexpr std::array<std::string_view, 2> kFormats{"csv", "html"};
constexpr std::uint64_t kMostPairs = 1'000'000'000'000;

class Audit final : public Verb {
 public:
  const char* name() const override { return "audit"; }
  const char* summary() const override {
    return "Is a recorded motion free, and if not, where? Exit code 0: free, 1: contact or intersection, 2: error";
  }
  const char* examples() const override {
    return "  tamis audit frames/\n"
           "  tamis audit 'frames/cloth*.ply' --out report.html\n"
           "  tamis audit cloth.obj cloth.pc2 --out pairs.csv --out-frames frames.csv\n"
           "  tamis audit frames/ --no-contacts --json";
  }

  void declare(OptionList& options) override {
    options
        .add_texts("FRAMES", names_,
                   "files, folders or patterns of " + io::mesh_format_names() +
                       ", in natural order (2 before 10); or a mesh file and a "
                       "point cache, .pc2 or .mdd")
        .required();
    declare_output(options, out_, "the file to write: csv, the pairs, or html, a page that shows them");
    options.add_path("--out-frames", out_frames_, "a table of the frames to write: csv").shown_as("FILE");
    options.add_number("--threads", "N", options_.threads, kThreadCounts, "threads to use; 0, the default: all");
    declare_min_separation(options, options_.min_separation);
    options.add_flag("--no-intersections", no_intersections_, "find contacts alone");
    options.add_flag("--no-contacts", no_contacts_, "find intersections alone, in each frame by itself");
    options.add_number("--ring-limit", "N", options_.ring_limit, NumberRange<Index>{1, 1000},
                       "search paths of up to N edges between the features of a pair; default 10");
    options.add_number("--pairs", "N", options_.listed_pairs, NumberRange<std::uint64_t>{0, kMostPairs},
                       "list no more than N pairs; all are counted; default 1000000");
    weld_.declare(options);
    options.add_flag("--new", only_new_, "exit code 1 only for pairs that the frame before did not have");
    declare_json(options, json_);
  }

  int run() override {
    options_.intersections = !no_intersections_;
    options_.contacts = !no_contacts_;
    audit::require_sound(options_);
    if (!is_page()) options_.kept_bytes = 0;
    const io::MotionFiles files = io::motion_files(names_);
    require_output(out_, files.all(), json_);
    require_output(out_frames_, files.all(), json_, "csv");
    require_two_outputs(out_, out_frames_);
    const auto source = open(files);
    if (io::has_own_order(names_)) note(kNaturalOrder);
    const auto start = std::chrono::steady_clock::now();
    const audit::Report report = audited(*source);
    if (report.ended_by && !is_bad(report)) std::rethrow_exception(report.ended_by);  // outputs stay as they were
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    write(report);
    say(report, seconds.count());
    return verdict(report);
  }

 private:
  std::unique_ptr<audit::FrameSource> open(const io::MotionFiles& files) const {
    auto source = io::open_motion(files);
    if (!weld_.distance()) return source;
    const auto scout = io::open_motion(files);
    auto welded = std::make_unique<io::WeldedFrames>(std::move(source), *scout, *weld_.distance());
    note_weld(welded->joined_count(), 0);
    return welded;
  }

  bool is_page() const { return !out_.empty() && kFormats[io::format_of(out_, kFormats)] == "html"; }

  audit::Report audited(audit::FrameSource& source) {
    Progress progress(source.count(), "frames");
    options_.progress = [&](std::size_t frames) { progress.show(frames); };
    return audit::audit(source, options_);
  }

  void write(const audit::Report& report) const {
    if (is_page())
      io::write_audit_page(out_, report);
    else if (!out_.empty())
      io::write_audit_pairs_csv(out_, report);
    if (!out_frames_.empty()) io::write_audit_frames_csv(out_frames_, report);
  }

  void say(const audit::Report& report, double seconds) const {
    note_frames(report);
    if (json_) return print_json(audit_json(report, seconds));
    print_audit(report, seconds);
    for (const std::filesystem::path& path : {out_, out_frames_})
      if (!path.empty()) fmt::print("written to      {}\n", printable(path.string()));
  }

  bool is_bad(const audit::Report& report) const {
    return (only_new_ ? report.first_new() : report.first_bad()).has_value();
  }

  /// A contact or intersection decides, even if other frames could not be asked about.
  int verdict(const audit::Report& report) const {
    if (is_bad(report)) return kNo;
    return report.problems == 0 ? kSuccess : fail(problem_of(report));
  }

  std::vector<std::string> names_;
  std::filesystem::path out_, out_frames_;
  audit::Options options_;
  bool no_intersections_ = false, no_contacts_ = false, only_new_ = false;
  WeldArgument weld_;
  bool json_ = false;
};

}  // namespace

std::unique_ptr<Verb> make_audit() { return std::make_unique<Audit>(); }

}  // namespace tamis::cli
