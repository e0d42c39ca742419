// What the verbs of one step, `tamis VERB START END`, have in common.
#pragma once
#include <string>

#include "cli/command_line/arguments.hpp"
#include "cli/command_line/verb.hpp"
#include "cli/step_files.hpp"
#include "io/mesh/mesh_formats.hpp"

namespace tamis::cli {

class StepVerb : public Verb {
 public:
  void declare(OptionList& options) override {
    options.add_text("START", start_, "the mesh at t=0: " + io::mesh_format_names()).required();
    options.add_text("END", end_, "the same mesh at t=1").required();
    detector_.declare(options);
    at_start_.declare(options);
    scale_.declare(options);
    declare_repeat(options, repeat_, "ask N times, report the median time of the runs after the first; default 1");
    declare_json(options, json_);
  }

 protected:
  /// Options are checked before any file is read.
  StepFiles read() const {
    detector_.check();
    own();
    return read_step(start_, end_, scale());
  }
  virtual Detector detector_for(Mesh mesh) const { return detector_.detector(std::move(mesh)); }
  Options options_for(const Mesh& mesh) const { return detector_.options_for(mesh); }
  /// The options where no one has the whole mesh.
  Options options() const { return detector_.options(); }
  /// The options of each question. Throws InvalidOptions.
  QueryOptions own() const { return at_start_.own(); }
  double scale() const { return scale_.value(); }

  std::string start_;
  std::string end_;
  int repeat_ = 1;
  bool json_ = false;

 private:
  DetectorArguments detector_;
  AtStartArgument at_start_;
  ScaleArgument scale_;
};

}  // namespace tamis::cli
