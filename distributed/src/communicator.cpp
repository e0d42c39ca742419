#include "distributed/src/communicator.hpp"

#include <limits>

#include "tamis/error.hpp"

namespace tamis::distributed {
namespace {

/// MPI 3 counts with int.
int as_count(std::size_t count) {
  if (count > static_cast<std::size_t>(std::numeric_limits<int>::max()))
    throw Error("the ranks together publish more than 2^31 - 1 bytes: use fewer ranks");
  return static_cast<int>(count);
}

}  // namespace

Communicator::Communicator(MPI_Comm communicator) {
  MPI_Comm_dup(communicator, &raw_);
  // Callers may have chosen to check error codes themselves, as mpi4py does; here nobody checks them.
  MPI_Comm_set_errhandler(raw_, MPI_ERRORS_ARE_FATAL);
  MPI_Comm_rank(raw_, &rank_);
  MPI_Comm_size(raw_, &size_);
}

Communicator::~Communicator() {
  int is_over = 0;
  MPI_Finalized(&is_over);
  if (is_over == 0) MPI_Comm_free(&raw_);
}

void Communicator::reduce(void* numbers, std::size_t count, MPI_Datatype type, MPI_Op operation) {
  int size = 0;
  MPI_Type_size(type, &size);
  count_message(count * static_cast<std::size_t>(size));
  MPI_Allreduce(MPI_IN_PLACE, numbers, as_count(count), type, operation, raw_);
}

double Communicator::least(double number) {
  reduce_to_least(std::span(&number, 1));
  return number;
}

std::uint64_t Communicator::sum(std::uint64_t number) {
  reduce_to_sum(std::span(&number, 1));
  return number;
}

std::uint64_t Communicator::largest(std::uint64_t number) {
  reduce(&number, 1, MPI_UINT64_T, MPI_MAX);
  return number;
}

void Communicator::broadcast(Bytes& bytes, int root) {
  std::uint64_t size = bytes.size();
  MPI_Bcast(&size, 1, MPI_UINT64_T, root, raw_);
  bytes.resize(size);
  if (rank_ == root) count_message(size);
  MPI_Bcast(bytes.data(), as_count(size), MPI_BYTE, root, raw_);
}

std::vector<Bytes> Communicator::gather_for_all(const Bytes& mine) {
  const auto ranks = static_cast<std::size_t>(size_);
  std::vector<std::uint64_t> sizes(ranks);
  const std::uint64_t size = mine.size();
  MPI_Allgather(&size, 1, MPI_UINT64_T, sizes.data(), 1, MPI_UINT64_T, raw_);
  std::vector<int> counts, offsets;
  std::size_t total = 0;
  for (const std::uint64_t count : sizes) {
    offsets.push_back(as_count(total));
    counts.push_back(as_count(count));
    total += count;
  }
  Bytes all(static_cast<std::size_t>(as_count(total)));
  count_message(size);
  MPI_Allgatherv(mine.data(), as_count(size), MPI_BYTE, all.data(), counts.data(), offsets.data(), MPI_BYTE, raw_);
  std::vector<Bytes> result;
  for (std::size_t rank = 0; rank < ranks; ++rank)
    result.emplace_back(all.begin() + offsets[rank], all.begin() + offsets[rank] + counts[rank]);
  return result;
}

void Communicator::count_message(std::size_t bytes) {
  ++traffic_.messages;
  traffic_.bytes += bytes;
}

}  // namespace tamis::distributed
