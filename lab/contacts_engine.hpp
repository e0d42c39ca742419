// A method that finds contacts, and leaves all other questions to the method `tamis`.
#pragma once
#include "engines/engine.hpp"

namespace tamis::lab {

class ContactsEngine : public Engine {
 public:
  ContactsEngine(const Mesh& mesh, const tamis::Options& options) : asked_mesh_(mesh), asked_options_(options) {}

  SafeStep find_step_length(const Step& step, const Separations& separations, double fraction,
                            Statistics& statistics) final {
    return others().find_step_length(step, separations, fraction, statistics);
  }
  void find_step_ends(const Step& step, const Separations& separations, double fraction, std::vector<StepLimit>& ends,
                      Statistics& statistics) final {
    others().find_step_ends(step, separations, fraction, ends, statistics);
  }
  void find_near(const Positions& positions, const Separations& separations, std::vector<NearPair>& pairs,
                 Statistics& statistics) final {
    others().find_near(positions, separations, pairs, statistics);
  }
  void find_intersections(const Positions& positions, Intersections wanted, std::vector<Intersection>& found,
                          Statistics& statistics) final {
    others().find_intersections(positions, wanted, found, statistics);
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
