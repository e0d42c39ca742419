// no_memory FIRST: the last rank runs out of memory at one place of all questions after the other, from FIRST on. Every
// rank throws the same then, and goes on as if nothing had been; or all are ended by MPI_Abort, with kEnded, and
// no_memory.sh starts again behind the place that was printed last. Nobody waits for ever.
#include <mpi.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <string>

#include "distributed/tests/same_answers.hpp"
#include "scenes/scene_list.hpp"
#include "support/copied.hpp"
#include "tamis/error.hpp"

namespace {

/// Small pieces are there nearly always.
constexpr std::size_t kLarge = 1024;
constexpr long kNever = -1;
std::atomic<long> left = kNever;  ///< large pieces until there are no more

void* allocated(std::size_t size) {
  if (size >= kLarge && left != kNever && left-- <= 0) {
    left = 0;
    throw std::bad_alloc();
  }
  void* piece = std::malloc(size > 0 ? size : 1);
  if (piece == nullptr) throw std::bad_alloc();
  return piece;
}

}  // namespace

void* operator new(std::size_t size) { return allocated(size); }
void* operator new[](std::size_t size) { return allocated(size); }
void operator delete(void* piece) noexcept { std::free(piece); }
void operator delete[](void* piece) noexcept { std::free(piece); }
void operator delete(void* piece, std::size_t) noexcept { std::free(piece); }
void operator delete[](void* piece, std::size_t) noexcept { std::free(piece); }

namespace tamis::test {
namespace {

class Lack {
 public:
  explicit Lack(long place) {
    if (rank_of() == rank_count() - 1) left = place;
  }
  ~Lack() { left = kNever; }
  Lack(const Lack&) = delete;
  Lack& operator=(const Lack&) = delete;
  /// Everything went well before the place was reached.
  static bool is_over() {
    int over = left > 0 ? 1 : 0;
    MPI_Bcast(&over, 1, MPI_INT, rank_count() - 1, MPI_COMM_WORLD);
    return over != 0;
  }
};

struct Asked {
  const scenes::Scene scene = scenes::scene_by_name("folded-cloth", 2000, 1);
  const Part part = part_of(scene, cuts()[1]);
  const std::size_t contacts = contacts_of(Detector(scene.mesh(), one_thread()), scene.step()).size();

  std::uint64_t found_by(distributed::Detector& many) const {
    std::uint64_t count = many.contacts(part.step()).size();
    MPI_Allreduce(MPI_IN_PLACE, &count, 1, MPI_UINT64_T, MPI_SUM, MPI_COMM_WORLD);
    return count;
  }
  void require(bool holds, const char* what) const {
    if (holds) return;
    std::fprintf(stderr, "no_memory: rank %d: %s\n", rank_of(), what);
    MPI_Abort(MPI_COMM_WORLD, 1);
  }
};

/// False: there was enough.
bool run_out(const Asked& asked, distributed::Detector& kept, long place) {
  const std::string expected = "rank " + std::to_string(rank_count() - 1) + ": not enough memory";
  try {
    const Lack lack(place);
    distributed::Detector fresh(MPI_COMM_WORLD, asked.part.mesh, one_thread());
    (void)fresh.earliest(asked.part.step());
    (void)kept.contacts(asked.part.step());
    (void)kept.gather_contacts(0);
    (void)kept.safe_step(asked.part.step(), 0.1);
    (void)kept.is_free(asked.part.step());
    if (Lack::is_over()) return false;
    asked.require(false, "the place was reached, and nothing was thrown");
  } catch (const Error& error) {
    asked.require(std::string(error.what()).starts_with(expected), error.what());
  }
  asked.require(asked.found_by(kept) == asked.contacts, "another answer than before");
  return true;
}

void run(long first) {
  const Asked asked;
  distributed::Detector kept(MPI_COMM_WORLD, asked.part.mesh, one_thread());
  asked.require(asked.found_by(kept) == asked.contacts, "a wrong answer");
  constexpr long kDense = 12;  // places that follow each other, then fewer
  for (long place = first;; place += 1 + place / kDense) {
    if (rank_of() == 0) std::printf("place %ld\n", place);
    std::fflush(stdout);
    if (!run_out(asked, kept, place)) break;
  }
}

}  // namespace
}  // namespace tamis::test

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  tamis::test::run(argc > 1 ? std::atol(argv[1]) : 0);
  MPI_Finalize();
  return 0;
}
