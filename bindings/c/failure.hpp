// The outcome of the last call, which every handle has, and the one place where exceptions become codes.
#pragma once
#include <array>
#include <charconv>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>

#include "tamis/error.hpp"
#include "tamis/tamis.h"

namespace tamis::c {

/// An argument that no later layer could refuse: a pointer that is NULL, or a size out of range.
struct InvalidArgument : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

/// The shortest text that reads back as the same double.
inline std::string text_of(double number) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), number).ptr};
}

class Outcome {
 public:
  tamis_status status() const { return status_; }
  const char* message() const { return message_.c_str(); }

  void succeed() {
    status_ = TAMIS_OK;
    message_.clear();
  }
  /// A message for which there is no memory stays empty.
  void fail(tamis_status status, const char* message) noexcept {
    status_ = status;
    try {
      message_ = message;
    } catch (...) {
      message_.clear();
    }
  }

 private:
  tamis_status status_ = TAMIS_OK;
  std::string message_;
};

inline constexpr const char* kOutOfMemory = "out of memory: check the counts that were given, or query less at once";

/// Records the code and the message of the exception in flight.
inline void record_exception(Outcome& outcome) noexcept {
  try {
    throw;
  } catch (const InvalidArgument& e) {
    outcome.fail(TAMIS_INVALID_ARGUMENT, e.what());
  } catch (const Busy& e) {
    outcome.fail(TAMIS_BUSY, e.what());
  } catch (const InvalidMesh& e) {
    outcome.fail(TAMIS_INVALID_MESH, e.what());
  } catch (const InvalidStep& e) {
    outcome.fail(TAMIS_INVALID_STEP, e.what());
  } catch (const InvalidPath& e) {
    outcome.fail(TAMIS_INVALID_PATH, e.what());
  } catch (const InvalidOptions& e) {
    outcome.fail(TAMIS_INVALID_OPTIONS, e.what());
  } catch (const Cancelled& e) {
    outcome.fail(TAMIS_CANCELLED, e.what());
  } catch (const std::bad_alloc&) {
    outcome.fail(TAMIS_OUT_OF_MEMORY, kOutOfMemory);
  } catch (const std::length_error&) {  // thrown by a container that could never be so long
    outcome.fail(TAMIS_OUT_OF_MEMORY, kOutOfMemory);
  } catch (const std::exception& e) {
    outcome.fail(TAMIS_FAILED, e.what());
  } catch (...) {
    outcome.fail(TAMIS_FAILED, "an exception of an unknown type");
  }
}

/// Runs `work`; what it throws becomes the outcome.
template <class Work>
tamis_status attempt(Outcome& outcome, const Work& work) noexcept {
  try {
    work();
    outcome.succeed();
  } catch (...) {
    record_exception(outcome);
  }
  return outcome.status();
}

template <class T>
T& required(T* pointer, const char* name) {
  if (!pointer) throw InvalidArgument(std::string(name) + " is NULL: give a pointer");
  return *pointer;
}

}  // namespace tamis::c
