// Base of the methods that find contacts alone: leaves all other questions to the method `tamis`.
#pragma once
#include "query/engine.hpp"

namespace tamis::lab {

class ContactsEngine : public Engine {
 public:
  ContactsEngine(const Mesh& mesh, const tamis::Options& options) : asked_mesh_(mesh), asked_options_(options) {}

  SafeStep find_step_length(const Query& query, double fraction, Statistics& statistics) final {
    return others().find_step_length(query, fraction, statistics);
  }
  void find_step_ends(const Query& query, double fraction, std::vector<StepLimit>& ends, Statistics& statistics) final {
    others().find_step_ends(query, fraction, ends, statistics);
  }
  void find_near(const Query& query, std::vector<NearPair>& pairs, Statistics& statistics) final {
    others().find_near(query, pairs, statistics);
  }
  void find_intersections(const Query& query, std::vector<Intersection>& found, Statistics& statistics) final {
    others().find_intersections(query, found, statistics);
  }
  std::uint64_t memory_bytes() const final { return memory_for_contacts() + (others_ ? others_->memory_bytes() : 0); }

 private:
  virtual std::uint64_t memory_for_contacts() const = 0;

  Engine& others() {
    if (!others_) others_ = make_tamis_engine(asked_mesh_, asked_options_);
    return *others_;
  }

  const Mesh& asked_mesh_;
  const tamis::Options& asked_options_;
  std::unique_ptr<Engine> others_;  ///< made by the first question that needs it
};

}  // namespace tamis::lab
