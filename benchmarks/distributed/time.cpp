// tamis_ranks_time TRIANGLES [THREADS]: milliseconds of each question, a line of CSV for each. The ranks of mpirun ask
// with one thread each; with THREADS, one process asks without MPI's help.
#include <mpi.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>

#include "benchmarks/distributed/layers.hpp"
#include "benchmarks/timing.hpp"
#include "tamis/detector.hpp"

namespace tamis::bench {
namespace {

constexpr int kQuestions = 21;

/// The median time of a question; the slowest rank's time counts. Calls ask(step) with the step and the way back in
/// turn. The first questions are not timed: from them the ranks learn how to share the work.
template <class Ask>
double median_ms(const LayersPart& part, const Ask& ask) {
  constexpr int kWarm = 4;
  std::vector<double> times;
  for (int question = 0; question < kWarm + kQuestions; ++question) {
    const Step step = question % 2 == 0 ? part.step() : part.back();
    MPI_Barrier(MPI_COMM_WORLD);
    const double start = MPI_Wtime();
    ask(step);
    double seconds = MPI_Wtime() - start;
    MPI_Allreduce(MPI_IN_PLACE, &seconds, 1, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
    if (question >= kWarm) times.push_back(1e3 * seconds);
  }
  return median(std::move(times));
}

template <class AnyDetector>
void report(AnyDetector& detector, const LayersPart& part, const char* who, int count, double triangles) {
  const double contacts = median_ms(part, [&](const Step& step) { (void)detector.contacts(step); });
  const double earliest = median_ms(part, [&](const Step& step) { (void)detector.earliest(step); });
  const double keep = median_ms(part, [&](const Step& step) { (void)detector.safe_step(step, 0.1); });
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (rank > 0) return;
  for (const auto& [question, ms] :
       {std::pair{"contacts", contacts}, std::pair{"earliest", earliest}, std::pair{"safe_step", keep}})
    std::printf("%s,%s,%d,%.0f,%.2f\n", question, who, count, triangles, ms);
}

void run(double triangles, int threads) {
  int rank = 0, ranks = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  const LayersPart part = make_layers(triangles, rank, ranks);
  Options options;
  options.threads = std::max(threads, 1);
  if (threads > 0) {
    // The part of a single rank holds all vertices, in order of their numbers.
    Detector detector(Mesh(static_cast<Index>(part.start.size()), part.mesh.faces), options);
    report(detector, part, "threads", threads, triangles);
  } else {
    distributed::Detector detector(MPI_COMM_WORLD, part.mesh, options);
    report(detector, part, "ranks", ranks, triangles);
  }
}

}  // namespace
}  // namespace tamis::bench

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  try {
    tamis::bench::run(argc > 1 ? std::max(1.0, std::atof(argv[1])) : 1e4, argc > 2 ? std::atoi(argv[2]) : 0);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "tamis_ranks_time: %s\n", error.what());
    MPI_Abort(MPI_COMM_WORLD, 2);
  }
  MPI_Finalize();
  return 0;
}
