// The library's exceptions. Every message names the fault, the place, and the remedy.
#pragma once
#include <stdexcept>

namespace tamis {

/// Base of all exceptions of this library.
struct Error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A topology that cannot be used: an index out of range, no feature at all.
struct InvalidMesh : Error {
  using Error::Error;
};

/// Positions that do not fit the mesh, or are not finite.
struct InvalidStep : Error {
  using Error::Error;
};

/// A path that does not fit the mesh, or breaks its promises. A promise is broken by a bound that is negative or not a
/// number, by positions that are not finite, or by a vertex that deviates farther than its bound.
struct InvalidPath : Error {
  using Error::Error;
};

/// An option outside its documented range, or an unknown name.
struct InvalidOptions : Error {
  using Error::Error;
};

/// Options::is_cancelled ended the question. The detector may be queried again.
struct Cancelled : Error {
  using Error::Error;
};

/// A question to a detector or world that is still answering another one. The second question comes from another
/// thread, or from a filter or path that the first question calls.
struct Busy : Error {
  using Error::Error;
  Busy() : Error("another question is being answered: give each thread a detector, or a world, of its own") {}
};

}  // namespace tamis
