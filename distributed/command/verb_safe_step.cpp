// tamis-mpi safe-step: how far a step may go so that every pair keeps a part of its distance.
#include "command/answers.hpp"
#include "command/start_check.hpp"
#include "distributed/command/ranks_verb.hpp"
#include "distributed/command/verbs.hpp"

namespace tamis::distributed {
namespace {

class SafeStepLength final : public RanksVerb {
 public:
  const char* name() const override { return "safe-step"; }
  const char* summary() const override {
    return "How far the step may go so that every pair keeps a part of its distance";
  }
  const char* examples() const override { return "  mpirun -n 4 tamis-mpi safe-step cloth1.ply cloth2.ply --keep 0.1"; }

  void declare(cli::OptionList& options) override {
    StepVerb::declare(options);
    keep_.declare(options);
  }

  int run() override {
    Communicator communicator(MPI_COMM_WORLD);
    SafeStep safe;
    ask_all(communicator,
            [&](Detector& detector, const Step& step) { safe = detector.safe_step(step, keep_.part(), own()); });
    report(
        communicator, [&](cli::Json& json) { cli::add_safe_step(json, safe, keep_.part()); }, [&] { print(safe); });
    return cli::kSuccess;
  }

 private:
  void print(const SafeStep& safe) const {
    cli::print_safe_step(safe, keep_.part(), options().min_separation);
    if (!safe.pair) cli::StartCheck().print();
  }

  cli::KeepArgument keep_;
};

}  // namespace

std::unique_ptr<cli::Verb> make_safe_step() { return std::make_unique<SafeStepLength>(); }

}  // namespace tamis::distributed
