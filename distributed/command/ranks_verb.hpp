// The common part of verbs about one step: ranks read their parts, all ranks ask, and rank 0 prints (main.cpp).
#pragma once
#include "command/verbs/step_verb.hpp"
#include "distributed/command/ranks_report.hpp"
#include "distributed/command/step_parts.hpp"

namespace tamis::distributed {

class RanksVerb : public cli::StepVerb {
 protected:
  /// Collective: reads the parts, makes the detector, and calls `ask(detector, step)` as often as the user wants.
  template <class Ask>
  void ask_all(Communicator& communicator, const Ask& ask) {
    const Options options = this->options();
    if (weld_distance()) throw InvalidOptions("--weld needs the whole mesh: weld it first, and write it as a file");
    parts_ = read_step_parts(communicator, start_, end_, scale());
    detector_.emplace(communicator.raw(), std::move(parts_.mesh), options);
    for (int run = 0; run < repeat_; ++run) ask(*detector_, parts_.step());
  }

  /// Collective. Reports the answer, by `add(json)` or `print()`, then the ranks' statistics.
  template <class Add, class Print>
  void report(Communicator& communicator, const Add& add, const Print& print) {
    const RanksReport ranks(communicator, *detector_);
    if (json_) {
      cli::Json json;
      add(json);
      add_facts(json, parts_, options());
      ranks.add_to(json);
      return cli::print_json(json);
    }
    print_mesh(parts_);
    print();
    ranks.print();
  }

  StepParts parts_;
  std::optional<Detector> detector_;
};

}  // namespace tamis::distributed
