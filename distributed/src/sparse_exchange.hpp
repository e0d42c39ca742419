// Messages to some ranks, where no rank knows from which ranks it will receive: synchronous sends, and a barrier that a
// rank enters when all its messages have been received (NBX: Hoefler, Siebert, Lumsdaine 2010). No rank talks to all.
#pragma once
#include <vector>

#include "distributed/src/communicator.hpp"

namespace tamis::distributed {

struct Message {
  int rank;  ///< receiver or sender
  Bytes bytes;
};

class SparseExchange {
 public:
  /// Collective; the messages are on their way when it returns. At most one message to each rank.
  SparseExchange(Communicator& communicator, std::vector<Message> outgoing);
  SparseExchange(const SparseExchange&) = delete;
  SparseExchange& operator=(const SparseExchange&) = delete;

  /// Collective; to be called once, even after a failure. Returns the messages to this rank, by sender.
  std::vector<Message> finish();

 private:
  void send(const Message& message);
  bool all_sent();
  void receive_what_is_there();

  Communicator& communicator_;
  const int tag_;
  std::vector<Message> outgoing_, incoming_;
  std::vector<MPI_Request> requests_;
};

/// Collective: sends and receives in one call.
std::vector<Message> exchange(Communicator& communicator, std::vector<Message> outgoing);

}  // namespace tamis::distributed
