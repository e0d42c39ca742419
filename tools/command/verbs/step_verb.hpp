// What the verbs of one step, `tamis VERB START END`, have in common.
#pragma once
#include <string>

#include "command/step_files.hpp"
#include "command/verbs/motion_verb.hpp"
#include "files/mesh/mesh_formats.hpp"

namespace tamis::cli {

class StepVerb : public MotionVerb {
 public:
  void declare(OptionList& options) override {
    options.add_path("START", start_, "the mesh at t=0: " + io::mesh_format_names()).required();
    options.add_path("END", end_, "the same mesh at t=1").required();
    declare_motion(options);
    declare_repeat(options, repeat_);
    declare_json(options, json_);
  }

 protected:
  StepFiles read() const {
    check();
    return read_step(start_, end_, scale(), weld_distance());
  }

  std::filesystem::path start_;
  std::filesystem::path end_;
  int repeat_ = 1;
};

}  // namespace tamis::cli
