// tamis-mpi sequence: the contacts of each pair of consecutive frames; each rank has a run of steps.
#include "command/verbs/sequence_steps.hpp"
#include "command/verbs/sequence_verb.hpp"
#include "distributed/command/ply_part.hpp"
#include "distributed/command/verbs.hpp"
#include "distributed/src/agreement.hpp"

namespace tamis::distributed {
namespace {

/// Every rank lists the files of all frames, which are few, and reads those of its own steps.
class Sequence final : public cli::SequenceVerb {
 public:
  const char* name() const override { return "sequence"; }
  const char* summary() const override {
    return "Contacts of each consecutive pair of frames, shared out over ranks. Exit code 0: every step is free, 1: "
           "contact, 2: error";
  }
  const char* examples() const override {
    return "  mpirun -n 4 tamis-mpi sequence frames/\n"
           "  mpirun -n 4 tamis-mpi sequence 'frames/cloth*.ply' --threads 1 --json";
  }

  int run() override {
    Communicator communicator(MPI_COMM_WORLD);
    std::optional<cli::MovingFrames> frames;
    std::optional<tamis::Detector> detector;
    Packer packer;
    together(communicator, [&] {
      check();
      frames.emplace(names_, 2, weld_distance());
      if (communicator.rank() == 0) frames->note_gaps();
      detector.emplace(detector_for(io::mesh_of(frames->first())));
      const std::uint64_t steps = frames->paths().size() - 1;
      const Block block{static_cast<std::uint64_t>(communicator.rank()),
                        static_cast<std::uint64_t>(communicator.size())};
      cli::ask_steps(*detector, *frames, {1 + block.first_of(steps), 1 + block.last_of(steps), substeps_, scale()},
                     own(), [&](const cli::SequenceStep& step) { packer.put(step); });
    });
    return print(communicator.gather_for_all(packer.take()), *frames, *detector) ? cli::kSuccess : cli::kNo;
  }

 private:
  /// Returns whether every step is free.
  bool print(const std::vector<Bytes>& of_ranks, const cli::MovingFrames& frames, const tamis::Detector& detector) {
    cli::SequenceTable table(frames.paths(), substeps_, json_);
    table.print_head(detector);
    for (const Bytes& bytes : of_ranks)
      for (Unpacker unpacker(bytes); !unpacker.empty();) table.add(unpacker.get<cli::SequenceStep>());
    table.print_totals(detector.options(), detector.statistics(), {});
    return table.is_free();
  }
};

}  // namespace

std::unique_ptr<cli::Verb> make_sequence() { return std::make_unique<Sequence>(); }

}  // namespace tamis::distributed
