#include "distributed/src/agreement.hpp"

#include <cstdlib>
#include <new>
#include <string>

#include "tamis/error.hpp"

namespace tamis::distributed {
namespace {

enum class Kind : int { mesh, step, options, cancelled, busy, other };

struct Report {
  Kind kind;
  std::string sentence;
};

Report report_of(const std::exception_ptr& failure) {
  try {
    std::rethrow_exception(failure);
  } catch (const InvalidMesh& error) {
    return {Kind::mesh, error.what()};
  } catch (const InvalidStep& error) {
    return {Kind::step, error.what()};
  } catch (const InvalidOptions& error) {
    return {Kind::options, error.what()};
  } catch (const Cancelled& error) {
    return {Kind::cancelled, error.what()};
  } catch (const Busy& error) {
    return {Kind::busy, error.what()};
  } catch (const std::bad_alloc&) {
    return {Kind::other, "not enough memory: use more ranks, or larger machines"};
  } catch (const std::exception& error) {
    return {Kind::other, error.what()};
  } catch (...) {
    return {Kind::other, "an exception that is not a std::exception: throw one that says what is wrong"};
  }
}

[[noreturn]] void raise(Kind kind, const std::string& sentence) {
  switch (kind) {
    case Kind::mesh:
      throw InvalidMesh(sentence);
    case Kind::step:
      throw InvalidStep(sentence);
    case Kind::options:
      throw InvalidOptions(sentence);
    case Kind::cancelled:
      throw Cancelled(sentence);
    case Kind::busy:
      throw Busy(sentence);
    case Kind::other:
      break;
  }
  throw Error(sentence);
}

}  // namespace

void end_all(MPI_Comm communicator) {
  constexpr int kNoMemory = 12;  // ENOMEM: memory is all that can be missing there
  MPI_Abort(communicator, kNoMemory);
  std::abort();  // MPI_Abort does not return, but its declaration does not say so
}

void agree(Communicator& communicator, const std::exception_ptr& failure) {
  int first = failure ? communicator.rank() : communicator.size();
  communicator.reduce_to_least(std::span(&first, 1));
  if (first == communicator.size()) return;
  Packer packer;
  if (first == communicator.rank()) {
    const Report report = report_of(failure);
    packer.put(report.kind);
    packer.put_all(std::vector<char>(report.sentence.begin(), report.sentence.end()));
  }
  Bytes bytes = packer.take();
  communicator.broadcast(bytes, first);
  Unpacker unpacker(bytes);
  const Kind kind = unpacker.get<Kind>();
  const auto text = unpacker.get_all<char>();
  raise(kind, "rank " + std::to_string(first) + ": " + std::string(text.begin(), text.end()));
}

}  // namespace tamis::distributed
