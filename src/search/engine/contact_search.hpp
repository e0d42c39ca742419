// Conducts contacts, earliest and is_free. Where the mesh moves as before, pairs that may touch are listed for several
// steps. Then the list serves the query. Else the trees are searched.
#pragma once
#include "numbers/held_bytes.hpp"
#include "search/coherence/pairs_ahead.hpp"
#include "search/engine/candidate_search.hpp"
#include "search/engine/contact_consumer.hpp"
#include "search/engine/thread_streams.hpp"

namespace tamis {

class ContactSearch {
 public:
  /// Keeps a reference.
  explicit ContactSearch(Workspace& workspace)
      : workspace_(workspace), ahead_(workspace.mesh), streams_(workspace), candidates_(workspace) {}

  /// As Engine::find.
  void find(const Query& query, ContactCollector& answer, Statistics& statistics);
  std::uint64_t memory_bytes() const { return held_bytes(ahead_, streams_, candidates_); }

 private:
  void search_lists(ContactCollector& answer);
  bool search_beginnings(ContactCollector& answer, Statistics& statistics);
  void search_trees(ContactCollector& answer);
  float gather(ContactCollector& answer);

  Workspace& workspace_;
  PairsAhead ahead_;
  ThreadStreams<ContactConsumer> streams_;
  CandidateSearch candidates_;
};

}  // namespace tamis
