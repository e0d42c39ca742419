// A cloth falls on another; each rank has a strip of both. Prints the same for any number of ranks:
// mpirun -n 4 build/dev/bin/tamis_on_ranks
#include <mpi.h>

#include <cmath>
#include <cstdio>
#include <exception>
#include <vector>

#include "tamis/distributed.hpp"

namespace {

constexpr int kSide = 64;  // squares along a side of each cloth

/// What this rank gives: its rows of squares of both cloths, and the positions of their corners at start and end.
struct Part {
  tamis::distributed::LocalMesh mesh;
  std::vector<tamis::Point> start, end;
};

void add_row(int cloth, int row, Part& part) {
  for (int column = 0; column <= kSide; ++column) {
    const double x = column / double(kSide), y = row / double(kSide);
    const double wave = 0.02 * std::sin(9 * x) * std::cos(7 * y);
    part.mesh.vertices.push_back((cloth * (kSide + 1) + row) * (kSide + 1) + column);
    part.start.push_back({x, y, cloth == 0 ? wave : 0.1 - wave});
    part.end.push_back({x, y, cloth == 0 ? wave : -0.1 - wave});
  }
}

void add_squares(int cloth, int row, Part& part) {
  for (int column = 0; column < kSide; ++column) {
    const tamis::Index a = (cloth * (kSide + 1) + row) * (kSide + 1) + column, b = a + kSide + 1;
    part.mesh.faces.push_back({a, a + 1, b});
    part.mesh.faces.push_back({b, a + 1, b + 1});
  }
}

Part part_of(int rank, int ranks) {
  Part part;
  const int first = kSide * rank / ranks, last = kSide * (rank + 1) / ranks;
  for (int cloth = 0; cloth < 2; ++cloth)
    for (int row = first; row <= last; ++row) {
      add_row(cloth, row, part);
      if (row < last) add_squares(cloth, row, part);
    }
  return part;
}

void ask(int rank, int ranks) {
  const Part part = part_of(rank, ranks);
  tamis::distributed::Detector detector(MPI_COMM_WORLD, part.mesh, {.threads = 1});
  const tamis::Step step{part.start, part.end};
  unsigned long long mine = detector.contacts(step).size(), all = 0;  // those whose first vertex this rank gives
  MPI_Allreduce(&mine, &all, 1, MPI_UNSIGNED_LONG_LONG, MPI_SUM, MPI_COMM_WORLD);
  const double safe = detector.safe_step(step, 0.1).toi_lower;  // the same on every rank
  if (rank == 0) std::printf("%llu contacts; every pair keeps a tenth of its distance until %.17g\n", all, safe);
}

}  // namespace

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  int rank = 0, ranks = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  try {
    ask(rank, ranks);
  } catch (const std::exception& error) {
    if (rank == 0) std::fprintf(stderr, "%s\n", error.what());
    MPI_Abort(MPI_COMM_WORLD, 1);
  }
  MPI_Finalize();
}
