// tamis-mpi is-free: is the step free of contacts? Answers by exit code, too.
#include "command/answers.hpp"
#include "command/start_check.hpp"
#include "distributed/command/ranks_verb.hpp"
#include "distributed/command/verbs.hpp"

namespace tamis::distributed {
namespace {

class IsFree final : public RanksVerb {
 public:
  const char* name() const override { return "is-free"; }
  const char* summary() const override {
    return "Is the step free of contacts? Exit code 0: free, 1: contact, 2: error";
  }
  const char* examples() const override {
    return "  mpirun -n 4 tamis-mpi is-free cloth1.ply cloth2.ply && echo may go";
  }

  int run() override {
    Communicator communicator(MPI_COMM_WORLD);
    bool is_free = false;
    ask_all(communicator, [&](Detector& detector, const Step& step) { is_free = detector.is_free(step, own()); });
    report(
        communicator, [&](cli::Json& json) { json["free"] = is_free; }, [&] { print(is_free); });
    return is_free ? cli::kSuccess : cli::kNo;
  }

 private:
  static void print(bool is_free) {
    cli::print_free(is_free, "the step");
    if (is_free) cli::StartCheck().print();
  }
};

}  // namespace

std::unique_ptr<cli::Verb> make_is_free() { return std::make_unique<IsFree>(); }

}  // namespace tamis::distributed
