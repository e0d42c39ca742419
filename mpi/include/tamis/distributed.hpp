// Continuous collision detection of one mesh whose parts are on many machines: MPI ranks ask together.
#pragma once
#include <mpi.h>

#include <cstdint>
#include <memory>
#include <vector>

#include "tamis/contact.hpp"
#include "tamis/mesh.hpp"
#include "tamis/options.hpp"
#include "tamis/step.hpp"
#include "tamis/step_length.hpp"

namespace tamis::distributed {

/// What one rank has of the mesh; it may have nothing. All numbers are those of the whole mesh, in [0, 2^31 - 1).
struct LocalMesh {
  /// Of each row of the positions that this rank gives. A vertex on a border may be given by several ranks, always with
  /// the same position; one that features here use may be given elsewhere alone.
  std::vector<Index> vertices;
  /// Each triangle on one rank.
  std::vector<Face> faces;
  std::vector<Edge> loose_edges = {};
  std::vector<Index> loose_points = {};
};

/// Wall-clock seconds of this rank, waiting for others included.
struct Seconds {
  double positions = 0;  ///< from who gives them to who needs them
  double decompose = 0;  ///< a new decomposition, where there was one
  double borrow = 0;     ///< boxes to all, features to where boxes meet
  double interior = 0;   ///< search among the rank's own features
  double border = 0;     ///< search against borrowed ones
  double deliver = 0;    ///< contacts to their ranks, answers to all
  double total = 0;
};

/// Of this rank and the last question. Features are counted as elements: a triangle with its edges and corners, a
/// loose edge with its ends, a loose point.
struct Statistics {
  std::uint64_t owned = 0;         ///< elements that are this rank's to search
  std::uint64_t borrowed = 0;      ///< elements that others sent, because boxes meet
  std::uint64_t pairs_tested = 0;  ///< pairs of features whose boxes meet, some of them in two searches
  std::uint64_t boxes = 0;         ///< moving boxes of all ranks, which every rank has
  std::uint64_t messages_sent = 0;
  std::uint64_t bytes_sent = 0;  ///< in messages, and given to collective operations
  bool decomposed_anew = false;
  Seconds seconds;
};

/// Largest over mean, of all ranks: 1 where work is shared evenly.
struct Balance {
  double pairs = 1;
  double owned = 1;
};

/// A `tamis::Detector` over all ranks of a communicator. Construction and every question are collective: all ranks
/// call them, in the same order and with the same options. The answers are bit for bit those of one `tamis::Detector`
/// with the whole mesh, whatever rank has what. An error on any rank is thrown on every rank, with the same sentence,
/// which names the rank; the next question may be asked. A second question on a rank that is answering one, of another
/// thread or of the filter, throws Busy there at once.
class Detector {
 public:
  /// Options::filter.group_of_vertex has one group a row of the positions; there is one ring; threads are those of a
  /// rank. `threads`, `isa`, `accepts` and `is_cancelled` may differ from rank to rank, what `accepts` says of a pair
  /// may not: it is asked on any rank, with the numbers of the whole mesh. Keeps a duplicate of the communicator, on
  /// which MPI's own errors are fatal, and which must be freed before MPI is. Throws InvalidMesh and InvalidOptions as
  /// `tamis::Detector` does, InvalidMesh also if no rank gives the position of a vertex that is used.
  Detector(MPI_Comm communicator, const LocalMesh& mesh, Options options = {});
  ~Detector();
  Detector(Detector&&) noexcept;
  Detector& operator=(Detector&&) noexcept;

  /// Every contact of the step, each on one rank: that which gives the position of its first vertex; of several, the
  /// lowest. By kind, then vertices. Valid until the next question. `step`: a row for each of LocalMesh::vertices.
  /// Every question throws InvalidStep as `tamis::Detector` does, and where positions of a vertex differ;
  /// InvalidOptions with AtStart::fail: ranks report what touches at t=0, or ignore it.
  const std::vector<Contact>& contacts(const Step& step, const QueryOptions& = {});
  /// The contacts of the last such question, of all ranks, in order, on rank `root`; none elsewhere. Collective. Throws
  /// InvalidOptions if there is no such rank.
  std::vector<Contact> gather_contacts(int root = 0);
  /// As in `tamis::Detector`; the same answer on every rank.
  EarliestContact earliest(const Step& step, const QueryOptions& = {});
  bool is_free(const Step& step, const QueryOptions& = {});
  SafeStep safe_step(const Step& step, double keep = 0.1, const QueryOptions& = {});

  /// Largest number of a vertex that is used, of all ranks, plus 1.
  Index vertex_count() const;
  /// Of the last question. Both throw Busy during one.
  const Statistics& statistics() const;
  const Balance& balance() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace tamis::distributed
