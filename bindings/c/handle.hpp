// What all handles have in common: an object, and the outcome of the last call.
#pragma once
#include <new>
#include <string>

#include "c/failure.hpp"

namespace tamis::c {

/// Kept: std::optional or std::unique_ptr of the object.
template <class Kept>
struct Handle {
  Outcome outcome;
  Kept object;  ///< none if it could not be made; then the outcome's message says why
};

/// Makes a handle, then `fill`s it. A handle that could not be filled remains, so that its message can be read.
template <class AnyHandle, class Fill>
tamis_status make_handle(AnyHandle** handle, const Fill& fill) noexcept {
  if (!handle) return TAMIS_INVALID_ARGUMENT;
  *handle = new (std::nothrow) AnyHandle;
  if (!*handle) return TAMIS_OUT_OF_MEMORY;
  return attempt((*handle)->outcome, [&] { fill(**handle); });
}

/// Runs `work(object)`, unless there is none: then the handle keeps the message that says why.
template <class AnyHandle, class Work>
tamis_status with_object(AnyHandle* handle, const Work& work) noexcept {
  if (!handle) return TAMIS_INVALID_ARGUMENT;
  if (!handle->object) return handle->outcome.status();
  return attempt(handle->outcome, [&] { work(*handle->object); });
}

/// The object of a handle that is an argument of a call with another one. Throws `Refused` if there is none.
template <class Refused, class AnyHandle>
const auto& made(const AnyHandle* handle, const char* name) {
  if (!required(handle, name).object)
    throw Refused("the " + std::string(name) + " could not be made: " + handle->outcome.message());
  return *handle->object;
}

template <class AnyHandle>
const char* message_of(const AnyHandle* handle) {
  return handle ? handle->outcome.message() : "";
}

}  // namespace tamis::c
