// tamis-mpi earliest: how far the step may go.
#include "cli/answers.hpp"
#include "cli/start_check.hpp"
#include "mpi/command/ranks_verb.hpp"
#include "mpi/command/verbs.hpp"

namespace tamis::distributed {
namespace {

class StepLength final : public RanksVerb {
 public:
  const char* name() const override { return "step"; }
  const char* summary() const override { return "The earliest contact: how far the step may go"; }
  const char* examples() const override {
    return "  mpirun -n 4 tamis-mpi earliest cloth1.ply cloth2.ply\n"
           "  mpirun -n 4 tamis-mpi safe-step cloth1.ply cloth2.ply --keep 0.1";
  }

  void declare(cli::OptionList& options) override {
    StepVerb::declare(options);
    kept_.declare(options);
  }

  int run() override {
    Communicator communicator(MPI_COMM_WORLD);
    if (kept_.is_asked()) return safe_step(communicator);
    EarliestContact first;
    ask_all(communicator, [&](Detector& detector, const Step& step) { first = detector.earliest(step, own()); });
    report(
        communicator, [&](cli::Json& json) { cli::add_earliest(json, first); }, [&] { print(first); });
    return cli::kSuccess;
  }

 private:
  static void print(const EarliestContact& first) {
    cli::print_earliest(first);
    if (!first.contact) cli::StartCheck().print();
  }

  void print(const SafeStep& safe) const {
    cli::print_safe_step(safe, kept_.fraction(), options().min_separation);
    if (!safe.pair) cli::StartCheck().print();
  }

  int safe_step(Communicator& communicator) {
    SafeStep safe;
    ask_all(communicator, [&](Detector& detector, const Step& step) {
      safe = detector.safe_step(step, kept_.fraction(), own());
    });
    report(
        communicator, [&](cli::Json& json) { cli::add_safe_step(json, safe, kept_.fraction()); }, [&] { print(safe); });
    return cli::kSuccess;
  }

  cli::KeepArgument kept_;
};

}  // namespace

std::unique_ptr<cli::Verb> make_step() { return std::make_unique<StepLength>(); }

}  // namespace tamis::distributed
