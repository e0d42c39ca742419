// What the verbs `VERB FRAMES...` have in common.
#pragma once
#include <string>
#include <vector>

#include "cli/command_line/arguments.hpp"
#include "cli/command_line/verb.hpp"
#include "io/mesh/mesh_formats.hpp"

namespace tamis::cli {

class SequenceVerb : public Verb {
 public:
  void declare(OptionList& options) override {
    options
        .add_texts(
            "FRAMES", names_,
            "files, folders or patterns of " + io::mesh_format_names() + "; taken in natural order (2 before 10)")
        .required();
    detector_.declare(options);
    at_start_.declare(options);
    scale_.declare(options);
    options.add_number("--substeps", "N", substeps_, kRunCounts,
                       "cut each step into N equal ones, asked one after the other; default 1");
    declare_json(options, json_);
  }

 protected:
  /// Options are checked before any file is read.
  void check() const {
    detector_.check();
    own();
  }
  /// The options of each question. Throws InvalidOptions.
  QueryOptions own() const { return at_start_.own(); }
  Detector detector_for(Mesh mesh) const { return detector_.detector(std::move(mesh)); }
  double scale() const { return scale_.value(); }

  std::vector<std::string> names_;
  int substeps_ = 1;
  bool json_ = false;

 private:
  DetectorArguments detector_;
  AtStartArgument at_start_;
  ScaleArgument scale_;
};

}  // namespace tamis::cli
