// What the methods have in common: a question goes in, contacts come out.
#pragma once
#include <memory>

#include "engines/found_contacts.hpp"

namespace tamis {

class RestEngine;

/// One per detector; keeps its hierarchy and its buffers from step to step.
class Engine {
 public:
  virtual ~Engine() = default;

  /// Adds to `found` what its step and question ask for: for `all_contacts` every contact, once; for `earliest` at
  /// least every contact that may be the first; for `is_free` at least one if there is any. A pair that `found` does
  /// not want need not be decided. Adds stages, seconds (but `total`), counts and `rebuilt` to `statistics`. REQUIRES:
  /// positions of the mesh's vertices. REQUIRES (not checked: O(n)): a validated step. Runs in the caller's oneTBB
  /// arena. After an exception (of the caller's filter, or for want of memory) the engine can be asked again.
  virtual void find(FoundContacts& found, Statistics& statistics) = 0;

  /// The same engine for questions about a mesh at rest; null if this method leaves them to `tamis`.
  virtual RestEngine* at_rest() { return nullptr; }

  /// Bytes held in the hierarchy and buffers.
  virtual std::uint64_t memory_bytes() const = 0;
};

/// The engines keep references: mesh and options must outlive them.
std::unique_ptr<Engine> make_tamis_engine(const Mesh& mesh, const Options& options);
std::unique_ptr<Engine> make_paper_engine(const Mesh& mesh, const Options& options);
std::unique_ptr<Engine> make_brute_engine(const Mesh& mesh, const Options& options);

}  // namespace tamis
