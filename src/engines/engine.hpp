// What the methods have in common: a question goes in, contacts come out.
#pragma once
#include <memory>
#include <vector>

#include "tamis/detector.hpp"

namespace tamis {

enum class Question : std::uint8_t { all_contacts, earliest, is_free };

/// `earliest` keeps every contact that starts up to this factor after the end of a certified one: no bracket is so
/// wide that the first of two could be lost to rounding.
inline constexpr double kNearTie = 1 + 0x1p-16;

/// One per detector; keeps its hierarchy and its buffers from step to step.
class Engine {
 public:
  virtual ~Engine() = default;

  /// Writes to `contacts`, in any order: for `all_contacts` every contact, once; for `earliest` at least every
  /// contact that may be the first (it may skip those that start after a certified one); for `is_free` at least one
  /// if there is any. Adds stages, seconds (but `total`), counts and `rebuilt` to `statistics`.
  /// REQUIRES: a validated step. Runs in the caller's oneTBB arena.
  virtual void find(const Step& step, Question question, std::vector<Contact>& contacts, Statistics& statistics) = 0;

  /// Bytes held in the hierarchy and buffers.
  virtual std::uint64_t memory_bytes() const = 0;
};

/// The engines keep references: mesh and options must outlive them.
std::unique_ptr<Engine> make_tamis_engine(const Mesh& mesh, const Options& options);
std::unique_ptr<Engine> make_paper_engine(const Mesh& mesh, const Options& options);
std::unique_ptr<Engine> make_brute_engine(const Mesh& mesh, const Options& options);

}  // namespace tamis
