// Errors of one rank are errors of all: before anybody goes on, the ranks tell each other how it went.
#pragma once
#include <exception>

#include "mpi/src/communicator.hpp"
#include "tamis/error.hpp"

namespace tamis::distributed {

/// What `work` throws, if it does.
template <class Work>
std::exception_ptr failure_of(const Work& work) {
  try {
    work();
  } catch (...) {
    return std::current_exception();
  }
  return nullptr;
}

/// Collective. Where any rank has failed, all throw the same: what the lowest of them did, as a type of
/// `tamis/error.hpp`, with a sentence that begins with the rank.
void agree(Communicator& communicator, const std::exception_ptr& failure);

/// Collective; `work` is of this rank alone.
template <class Work>
void together(Communicator& communicator, const Work& work) {
  agree(communicator, failure_of(work));
}

/// Ends all ranks: this one has failed where nobody agrees, and the others would wait for it for ever.
[[noreturn]] void end_all(MPI_Comm communicator);

/// Collective: what an entry point does. Errors that are agreed upon are the library's own types, others are not.
template <class Work>
auto agreed_or_ended(MPI_Comm communicator, const Work& work) {
  try {
    return work();
  } catch (const Error&) {
    throw;
  } catch (...) {
    end_all(communicator);
  }
}

}  // namespace tamis::distributed
