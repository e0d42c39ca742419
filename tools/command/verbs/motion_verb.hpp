// What the verbs about moving meshes have in common.
#pragma once
#include "command/command_line/arguments.hpp"
#include "command/command_line/verb.hpp"

namespace tamis::cli {

class MotionVerb : public Verb {
 protected:
  void declare_motion(OptionList& options) {
    detector_.declare(options);
    at_start_.declare(options);
    scale_.declare(options);
    weld_.declare(options);
  }
  /// Options are checked before any file is read.
  void check() const {
    detector_.check();
    own();
  }
  Detector detector_for(Mesh mesh) const {
    Options options = options_for(mesh);
    return detector_for(std::move(mesh), std::move(options));
  }
  /// `options`: those for the mesh, or for one of which the mesh is a part.
  virtual Detector detector_for(Mesh mesh, Options options) const {
    return Detector(std::move(mesh), std::move(options));
  }
  Options options_for(const Mesh& mesh) const { return detector_.options_for(mesh); }
  /// The options where no one has the whole mesh.
  Options options() const { return detector_.options(); }
  /// The options of each question. Throws InvalidOptions.
  QueryOptions own() const { return at_start_.own(); }
  double scale() const { return scale_.value(); }
  std::optional<double> weld_distance() const { return weld_.distance(); }

  bool json_ = false;

 private:
  DetectorArguments detector_;
  AtStartArgument at_start_;
  ScaleArgument scale_;
  WeldArgument weld_;
};

}  // namespace tamis::cli
