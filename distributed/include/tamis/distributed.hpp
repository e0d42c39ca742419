// Continuous collision detection of one mesh whose parts are on several MPI ranks, which ask together.
#pragma once
#include <mpi.h>

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "tamis/contact.hpp"
#include "tamis/mesh.hpp"
#include "tamis/options.hpp"
#include "tamis/step.hpp"
#include "tamis/step_length.hpp"

namespace tamis::distributed {

/// The part of the mesh that one rank gives; it may be empty. All vertices are given by their numbers in the whole
/// mesh, in [0, 2^31 - 1).
struct LocalMesh {
  /// For each row of this rank's positions the number of its vertex. Several ranks may give a vertex on a border,
  /// always with the same position. Features of this rank may use vertices that only other ranks give.
  std::vector<Index> vertices;
  /// Each triangle is given by one rank.
  std::vector<Face> faces;
  std::vector<Edge> loose_edges = {};
  std::vector<Index> loose_points = {};
};

/// Wall-clock seconds of this rank, including those in which it waits for others.
struct Seconds {
  double positions = 0;  ///< sending positions from ranks that give them to ranks that need them
  double decompose = 0;  ///< a new decomposition, if there was one
  double borrow = 0;     ///< sending boxes to all ranks, and features to ranks where boxes meet
  double interior = 0;   ///< search among the rank's own features
  double border = 0;     ///< search against borrowed features
  double deliver = 0;    ///< sending contacts to their ranks, and answers to all
  double total = 0;
};

/// The cost of the last question on this rank. Features are counted as elements: a triangle with its edges and corners,
/// a loose edge with its ends, or a loose point.
struct Statistics {
  std::uint64_t owned = 0;         ///< elements that this rank owns, and searches
  std::uint64_t borrowed = 0;      ///< elements that other ranks sent because boxes meet
  std::uint64_t pairs_tested = 0;  ///< pairs of features whose boxes meet; some are counted in two searches
  std::uint64_t boxes = 0;         ///< moving boxes of all ranks together, which every rank holds
  std::uint64_t messages_sent = 0;
  std::uint64_t bytes_sent = 0;  ///< in messages and in collective operations
  bool decomposed_anew = false;
  Seconds seconds;
};

/// The largest number of any rank over the mean; 1 if work is shared evenly.
struct Balance {
  double pairs = 1;
  double owned = 1;
};

/// A `tamis::Detector` over all ranks of a communicator. Construction and every question are collective: all ranks call
/// them, in the same order and with the same options. The answers are bit for bit those of one `tamis::Detector` with
/// the whole mesh, however the mesh is distributed. An error on any rank is thrown on every rank, with the same
/// message, which names the rank; the next question may be asked. A second question on a rank that is still answering
/// one, from another thread or from the filter, throws Busy there at once.
class Detector {
 public:
  /// Of the options, filter.group_of_vertex has one group for each row of this rank's positions; filter.rings must be
  /// 1; `threads` is the number of each rank. `threads`, `isa`, `accepts` and `is_cancelled` may differ from rank to
  /// rank. What `accepts` returns for a pair may not: any rank may ask it, with the numbers of the whole mesh. Keeps a
  /// duplicate of the communicator, on which MPI's own errors are fatal; destroy the detector before MPI_Finalize.
  /// Throws InvalidMesh and InvalidOptions as `tamis::Detector` does, and InvalidMesh if no rank gives the position of
  /// a vertex that is used.
  Detector(MPI_Comm communicator, const LocalMesh& mesh, Options options = {});
  ~Detector();
  Detector(Detector&&) noexcept;
  Detector& operator=(Detector&&) noexcept;

  /// Finds every contact of the step, each on one rank: the rank that gives the position of its first vertex, or the
  /// lowest of several. `step`: a row for each of LocalMesh::vertices.
  /// Returns this rank's contacts, sorted by kind, then vertices. The list is valid until the next question.
  /// Throws InvalidStep as `tamis::Detector` does, and if ranks give one vertex different positions. Throws
  /// InvalidOptions with AtStart::fail: ranks report pairs that touch at t=0, or ignore them. So do the other
  /// questions.
  [[nodiscard]] std::span<const Contact> contacts(const Step& step, const QueryOptions& = {});
  /// Gathers the contacts of all ranks from the last question for contacts. Collective.
  /// Returns them sorted on rank `root`, an empty list on all others.
  /// Throws InvalidOptions if there is no such rank.
  [[nodiscard]] std::vector<Contact> gather_contacts(int root = 0);
  /// Find what `tamis::Detector` finds.
  /// Return the same answer on every rank.
  [[nodiscard]] EarliestContact earliest(const Step& step, const QueryOptions& = {});
  [[nodiscard]] bool is_free(const Step& step, const QueryOptions& = {});
  [[nodiscard]] SafeStep safe_step(const Step& step, double keep = 0.1, const QueryOptions& = {});

  /// Returns the largest number of a vertex that any rank gives or uses, plus 1.
  [[nodiscard]] Index vertex_count() const;
  /// Return cost and balance of the last question.
  /// Throw Busy while a question is answered.
  [[nodiscard]] const Statistics& statistics() const;
  [[nodiscard]] const Balance& balance() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace tamis::distributed
