// An error of one rank is an error of all: before any rank goes on, the ranks tell each other whether they have failed.
#pragma once
#include <exception>

#include "distributed/src/communicator.hpp"
#include "tamis/error.hpp"

namespace tamis::distributed {

/// Returns the exception that `work` throws, or none.
template <class Work>
std::exception_ptr failure_of(const Work& work) {
  try {
    work();
  } catch (...) {
    return std::current_exception();
  }
  return nullptr;
}

/// Collective. If any rank has failed, all throw the exception of the lowest one that has, as a type of
/// `tamis/error.hpp`, with a message that begins with that rank.
void agree(Communicator& communicator, const std::exception_ptr& failure);

/// Collective: runs `work`, which needs no other rank, then agrees.
template <class Work>
void together(Communicator& communicator, const Work& work) {
  agree(communicator, failure_of(work));
}

/// Ends all ranks. For a rank that fails where ranks do not agree: the others would wait for it for ever.
[[noreturn]] void end_all(MPI_Comm communicator);

/// Collective: runs `work`, the body of an entry point. Errors that are agreed upon have the library's own types and
/// are thrown on; any other exception ends all ranks.
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
