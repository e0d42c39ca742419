// tamis_distributed TRIANGLES_A_RANK (under mpirun): how much ranks own, borrow, send and test, as a line of CSV.
#include <mpi.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>

#include "benchmarks/distributed/layers.hpp"

namespace tamis::bench {
namespace {

/// Mean and maximum of a number over all ranks.
struct Spread {
  double mean, most;
};

Spread spread(std::uint64_t number, int ranks) {
  std::uint64_t sum = 0, most = 0;
  MPI_Allreduce(&number, &sum, 1, MPI_UINT64_T, MPI_SUM, MPI_COMM_WORLD);
  MPI_Allreduce(&number, &most, 1, MPI_UINT64_T, MPI_MAX, MPI_COMM_WORLD);
  return {static_cast<double>(sum) / ranks, static_cast<double>(most)};
}

void report(const char* question, double triangles, int ranks, int rank, const distributed::Detector& detector,
            std::uint64_t contacts) {
  const distributed::Statistics& s = detector.statistics();
  const Spread owned = spread(s.owned, ranks), borrowed = spread(s.borrowed, ranks);
  const Spread pairs = spread(s.pairs_tested, ranks), bytes = spread(s.bytes_sent, ranks);
  const Spread messages = spread(s.messages_sent, ranks), found = spread(contacts, ranks);
  if (rank > 0) return;
  std::printf("%s,%d,%.0f,%.0f,%.4f,%.4f,%.4f,%.4f,%.4f,%.0f,%.0f,%.1f,%.0f,%.0f,%.3f,%.3f,%.3f,%.3f,%.3f,%.3f\n",
              question, ranks, triangles, owned.mean, owned.most / owned.mean, borrowed.mean / owned.mean,
              borrowed.most / owned.mean, pairs.mean / owned.mean, pairs.mean > 0 ? pairs.most / pairs.mean : 1,
              bytes.mean, bytes.most, messages.mean, messages.most, static_cast<double>(s.boxes),
              found.mean / owned.mean, s.seconds.positions, s.seconds.borrow, s.seconds.interior, s.seconds.border,
              s.seconds.total);
  std::fflush(stdout);
}

constexpr const char* kHeader =
    "question,ranks,triangles,owned,owned_balance,borrowed,borrowed_most,pairs,pairs_balance,bytes,bytes_most,messages,"
    "messages_most,boxes,contacts,positions_s,borrow_s,interior_s,border_s,total_s";

/// Asks about the step and the way back in turn. The mesh is cut by elements first, and then by pairs; the questions
/// that are reported come after both cuts.
void run(double triangles, bool has_header) {
  int rank = 0, ranks = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  const LayersPart part = make_layers(triangles * ranks, rank, ranks);
  Options options;
  options.threads = 1;
  distributed::Detector detector(MPI_COMM_WORLD, part.mesh, options);
  constexpr int kQuestions = 4;
  std::uint64_t contacts = 0;
  for (int question = 0; question < kQuestions; ++question)
    contacts = detector.contacts(question % 2 == 0 ? part.step() : part.back()).size();
  if (rank == 0 && has_header) std::printf("%s\n", kHeader);
  report("contacts", triangles, ranks, rank, detector, contacts);
  (void)detector.earliest(part.step());
  report("earliest", triangles, ranks, rank, detector, 0);
  (void)detector.earliest(part.closing());
  report("earliest_closing", triangles, ranks, rank, detector, 0);
  (void)detector.safe_step(part.step(), 0.1);
  report("safe_step", triangles, ranks, rank, detector, 0);
}

}  // namespace
}  // namespace tamis::bench

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  try {
    tamis::bench::run(argc > 1 ? std::max(1.0, std::atof(argv[1])) : 1e4, argc <= 2);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "tamis_distributed: %s\n", error.what());
    MPI_Abort(MPI_COMM_WORLD, 2);
  }
  MPI_Finalize();
  return 0;
}
