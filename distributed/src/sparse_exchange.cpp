#include "distributed/src/sparse_exchange.hpp"

#include <algorithm>
#include <thread>

namespace tamis::distributed {
namespace {

constexpr std::size_t kLongest = std::size_t{1} << 30;  // MPI 3 counts with int

}  // namespace

SparseExchange::SparseExchange(Communicator& communicator, std::vector<Message> outgoing)
    : communicator_(communicator), tag_(communicator.next_tag()), outgoing_(std::move(outgoing)) {
  for (Message& message : outgoing_)
    if (message.rank == communicator_.rank())
      incoming_.push_back(std::move(message));
    else
      send(message);
}

/// Sends a long message in parts, which arrive in order.
void SparseExchange::send(const Message& message) {
  std::size_t sent = 0;
  do {
    const std::size_t length = std::min(message.bytes.size() - sent, kLongest);
    MPI_Issend(message.bytes.data() + sent, static_cast<int>(length), MPI_BYTE, message.rank, tag_, communicator_.raw(),
               &requests_.emplace_back());
    communicator_.count_message(length);
    sent += length;
  } while (sent < message.bytes.size());
}

bool SparseExchange::all_sent() {
  int done = 0;
  MPI_Testall(static_cast<int>(requests_.size()), requests_.data(), &done, MPI_STATUSES_IGNORE);
  return done != 0;
}

void SparseExchange::receive_what_is_there() {
  int is_there = 0;
  MPI_Status status;
  for (;;) {
    MPI_Iprobe(MPI_ANY_SOURCE, tag_, communicator_.raw(), &is_there, &status);
    if (is_there == 0) return;
    int length = 0;
    MPI_Get_count(&status, MPI_BYTE, &length);
    auto message = std::ranges::find(incoming_, status.MPI_SOURCE, &Message::rank);
    if (message == incoming_.end()) message = incoming_.insert(message, {status.MPI_SOURCE, {}});
    const std::size_t before = message->bytes.size();
    message->bytes.resize(before + static_cast<std::size_t>(length));
    MPI_Recv(message->bytes.data() + before, length, MPI_BYTE, status.MPI_SOURCE, tag_, communicator_.raw(),
             MPI_STATUS_IGNORE);
  }
}

std::vector<Message> SparseExchange::finish() {
  MPI_Request barrier = MPI_REQUEST_NULL;
  for (int is_over = 0; is_over == 0;) {
    receive_what_is_there();
    if (barrier != MPI_REQUEST_NULL)
      MPI_Test(&barrier, &is_over, MPI_STATUS_IGNORE);
    else if (all_sent())
      MPI_Ibarrier(communicator_.raw(), &barrier);
    std::this_thread::yield();  // there may be more ranks than cores
  }
  std::ranges::sort(incoming_, {}, &Message::rank);
  return std::move(incoming_);
}

std::vector<Message> exchange(Communicator& communicator, std::vector<Message> outgoing) {
  return SparseExchange(communicator, std::move(outgoing)).finish();
}

}  // namespace tamis::distributed
