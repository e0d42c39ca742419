// The command `tamis-mpi`: those verbs of `tamis` that many ranks can answer together.
#include <fcntl.h>
#include <mpi.h>
#include <unistd.h>

#include <chrono>
#include <exception>
#include <thread>

#include "command/command_line/messages.hpp"
#include "command/command_line/run_command.hpp"
#include "distributed/command/verbs.hpp"

namespace tamis::distributed {
namespace {

/// Silences this rank: all ranks print the same, and one is enough.
void be_silent() {
  const int nowhere = open("/dev/null", O_WRONLY);
  if (nowhere < 0) return;
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
  close(nowhere);
}

/// Returns true when all ranks have called it. Every rank comes here at the end, also after an error, as errors are
/// agreed upon. Returns false after some time if this rank has failed alone (it had no memory to agree): then the
/// others wait for it elsewhere, for ever.
bool all_have_come(bool has_failed) {
  constexpr auto kLongestWait = std::chrono::seconds(10);
  const auto start = std::chrono::steady_clock::now();
  MPI_Request barrier = MPI_REQUEST_NULL;
  MPI_Ibarrier(MPI_COMM_WORLD, &barrier);
  for (int have_come = 0;;) {
    MPI_Test(&barrier, &have_come, MPI_STATUS_IGNORE);
    if (have_come != 0) return true;
    if (has_failed && std::chrono::steady_clock::now() - start > kLongestWait) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

int run(int argc, char** argv) {
  cli::Command command{
      "tamis-mpi", "Tamis on many machines: start it with mpirun, or what stands for it on your cluster.", {}};
  command.verbs.push_back(make_contacts());
  command.verbs.push_back(make_earliest());
  command.verbs.push_back(make_safe_step());
  command.verbs.push_back(make_is_free());
  command.verbs.push_back(make_sequence());
  return cli::run_command(command, argc, argv);
}

}  // namespace
}  // namespace tamis::distributed

int main(int argc, char** argv) {
  namespace distributed = tamis::distributed;
  try {
    MPI_Init(&argc, &argv);
    int rank = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    if (rank > 0) distributed::be_silent();
    const int code = distributed::run(argc, argv);
    if (!distributed::all_have_come(code == tamis::cli::kError)) MPI_Abort(MPI_COMM_WORLD, code);
    MPI_Finalize();
    // mpirun passes on the exit code of one rank, and complains about each rank whose code is not zero.
    return rank == 0 ? code : 0;
  } catch (const std::exception& error) {
    return tamis::cli::fail(error.what());
  }
}
