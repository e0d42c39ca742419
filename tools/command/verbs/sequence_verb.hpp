// What the verbs `VERB FRAMES...` have in common.
#pragma once
#include <string>
#include <vector>

#include "command/verbs/motion_verb.hpp"
#include "files/mesh/mesh_formats.hpp"

namespace tamis::cli {

class SequenceVerb : public MotionVerb {
 public:
  void declare(OptionList& options) override {
    options
        .add_texts(
            "FRAMES", names_,
            "files, folders or patterns of " + io::mesh_format_names() + "; taken in natural order (2 before 10)")
        .required();
    declare_motion(options);
    options.add_number("--substeps", "N", substeps_, kRunCounts,
                       "cut each step into N equal ones, tested one after the other; default 1");
    declare_json(options, json_);
  }

 protected:
  std::vector<std::string> names_;
  int substeps_ = 1;
};

}  // namespace tamis::cli
