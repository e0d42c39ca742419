// The ranks that ask together: collective operations among them, and a count of what they send.
#pragma once
#include <mpi.h>

#include <cstdint>
#include <span>
#include <vector>

#include "distributed/src/bytes.hpp"

namespace tamis::distributed {

/// What this rank has sent.
struct Traffic {
  std::uint64_t messages = 0;
  std::uint64_t bytes = 0;
};

/// A duplicate of the caller's communicator, so that messages of the two never meet.
class Communicator {
 public:
  explicit Communicator(MPI_Comm communicator);
  ~Communicator();
  Communicator(const Communicator&) = delete;
  Communicator& operator=(const Communicator&) = delete;

  int rank() const { return rank_; }
  int size() const { return size_; }
  MPI_Comm raw() const { return raw_; }

  /// Collective: each number becomes the least, or the sum, of that of all ranks.
  void reduce_to_least(std::span<double> numbers) { reduce(numbers.data(), numbers.size(), MPI_DOUBLE, MPI_MIN); }
  void reduce_to_least(std::span<int> numbers) { reduce(numbers.data(), numbers.size(), MPI_INT, MPI_MIN); }
  void reduce_to_sum(std::span<std::uint64_t> numbers) {
    reduce(numbers.data(), numbers.size(), MPI_UINT64_T, MPI_SUM);
  }
  double least(double number);
  std::uint64_t sum(std::uint64_t number);
  std::uint64_t largest(std::uint64_t number);
  bool any(bool flag) { return largest(flag ? 1 : 0) > 0; }

  /// Collective: gives the bytes of rank `root`, at most 2^31 - 1, to all ranks.
  void broadcast(Bytes& bytes, int root);
  /// Collective: gives the bytes of every rank, together at most 2^31 - 1, to all ranks.
  std::vector<Bytes> gather_for_all(const Bytes& mine);

  /// A tag that no message under way has.
  int next_tag() { return tag_ = (tag_ + 1) % kTags; }
  void count_message(std::size_t bytes);
  const Traffic& traffic() const { return traffic_; }

 private:
  static constexpr int kTags = 1024;  // MPI guarantees 32767

  void reduce(void* numbers, std::size_t count, MPI_Datatype type, MPI_Op operation);

  MPI_Comm raw_ = MPI_COMM_NULL;
  int rank_ = 0, size_ = 1, tag_ = 0;
  Traffic traffic_;
};

}  // namespace tamis::distributed
