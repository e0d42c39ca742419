// tamis sequence: the contacts of each pair of consecutive frames, with one detector.
#include <memory>

#include "command/progress.hpp"
#include "command/start_check.hpp"
#include "command/verbs/sequence_steps.hpp"
#include "command/verbs/sequence_verb.hpp"

namespace tamis::cli {
namespace {

class Sequence final : public SequenceVerb {
 public:
  const char* name() const override { return "sequence"; }
  const char* summary() const override {
    return "Contacts of each consecutive pair of frames. Exit code 0: every step is free, 1: contact, 2: error";
  }
  const char* examples() const override {
    return "  tamis sequence frames/\n"
           "  tamis sequence 'frames/cloth*.ply' --threads 1\n"
           "  tamis sequence a1.ply a2.ply a10.ply --json\n"
           "  tamis sequence frames/ --substeps 20";
  }

  void declare(OptionList& options) override {
    SequenceVerb::declare(options);
    start_.declare(options);
  }

  int run() override {
    check();
    const MovingFrames frames(names_, 2, weld_distance());
    frames.note_gaps();
    Detector detector = detector_for(io::mesh_of(frames.first()));
    if (!start_.passes(detector, frames.first().positions)) return start_.refuse(detector, json_, Json::object());
    SequenceTable table(frames.paths(), substeps_, json_);
    table.print_head(detector);
    Progress progress(frames.paths().size() - 1, "steps");
    ask_steps(detector, frames, {1, frames.paths().size(), substeps_, scale()}, own(), [&](const SequenceStep& step) {
      progress.clear();
      table.add(step);
      progress.show(step.part == substeps_ ? step.end : step.end - 1);
    });
    progress.clear();
    if (!table.is_free()) note_coincident(detector.mesh(), frames.first().positions);
    table.print_totals(detector.options(), detector.statistics(), start_);
    return table.is_free() ? kSuccess : kNo;
  }

 private:
  StartCheck start_;
};

}  // namespace

std::unique_ptr<Verb> make_sequence() { return std::make_unique<Sequence>(); }

}  // namespace tamis::cli
