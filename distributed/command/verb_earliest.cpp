// tamis-mpi earliest: the first contact of a step.
#include "command/answers.hpp"
#include "command/start_check.hpp"
#include "distributed/command/ranks_verb.hpp"
#include "distributed/command/verbs.hpp"

namespace tamis::distributed {
namespace {

class Earliest final : public RanksVerb {
 public:
  const char* name() const override { return "earliest"; }
  const char* summary() const override { return "The earliest contact: how far the step may go"; }
  const char* examples() const override { return "  mpirun -n 4 tamis-mpi earliest cloth1.ply cloth2.ply"; }

  int run() override {
    Communicator communicator(MPI_COMM_WORLD);
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
};

}  // namespace

std::unique_ptr<cli::Verb> make_earliest() { return std::make_unique<Earliest>(); }

}  // namespace tamis::distributed
