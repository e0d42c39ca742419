// tamis-mpi contacts: all contacts of a step.
#include <fmt/format.h>

#include "command/answers.hpp"
#include "command/command_line/printable.hpp"
#include "command/output_file.hpp"
#include "command/start_check.hpp"
#include "distributed/command/ranks_verb.hpp"
#include "distributed/command/verbs.hpp"
#include "distributed/src/agreement.hpp"
#include "files/output/contacts_csv.hpp"

namespace tamis::distributed {
namespace {

class Contacts final : public RanksVerb {
 public:
  const char* name() const override { return "contacts"; }
  const char* summary() const override { return "All contacts of the step from START to END"; }
  const char* examples() const override {
    return "  mpirun -n 4 tamis-mpi contacts cloth1.ply cloth2.ply --out contacts.csv\n"
           "  mpirun -n 4 tamis-mpi contacts cloth1.ply cloth2.ply --repeat 4 --json";
  }
  void declare(cli::OptionList& options) override {
    StepVerb::declare(options);
    cli::declare_output(options, out_, "write the contacts to a CSV file, which rank 0 does");
  }

  int run() override {
    Communicator communicator(MPI_COMM_WORLD);
    together(communicator, [&] {
      if (communicator.rank() == 0) cli::require_output(out_, {start_, end_}, json_, "csv");
    });
    std::span<const Contact> contacts;
    ask_all(communicator, [&](Detector& detector, const Step& step) { contacts = detector.contacts(step, own()); });
    const cli::Tally tally = tally_of_all(communicator, contacts);
    if (!out_.empty()) write(communicator);
    report(
        communicator, [&](cli::Json& json) { cli::add_tally(json, tally); }, [&] { print(tally); });
    return cli::kSuccess;
  }

 private:
  void write(Communicator& communicator) {
    const std::vector<Contact> contacts = detector_->gather_contacts(0);
    together(communicator, [&] {
      if (communicator.rank() == 0) io::write_contacts_csv(out_, contacts);
    });
  }

  void print(const cli::Tally& tally) const {
    cli::print_tally(tally);
    if (tally.is_free()) cli::StartCheck().print();
    if (!out_.empty()) fmt::print("written to      {}\n", cli::printable(out_));
  }

  std::string out_;
};

}  // namespace

std::unique_ptr<cli::Verb> make_contacts() { return std::make_unique<Contacts>(); }

}  // namespace tamis::distributed
