// What the verbs of one pose, `tamis VERB MESH`, have in common.
#pragma once
#include <string>
#include <vector>

#include "command/command_line/arguments.hpp"
#include "command/command_line/verb.hpp"
#include "command/step_files.hpp"
#include "files/mesh/mesh_formats.hpp"

namespace tamis::cli {

class PoseVerb : public Verb {
 public:
  void declare(OptionList& options) override {
    options.add_path("MESH", path_, io::mesh_format_names()).required();
    detector_.declare_means(options);
    weld_.declare(options);
    declare_repeat(options, repeat_);
    declare_json(options, json_);
  }

 protected:
  /// Options are checked before any file is read.
  io::MeshFile read() const {
    detector_.check();
    io::MeshFile file = read_with_notes(path_);
    weld(file, {}, weld_.distance());
    return file;
  }
  Detector detector_for(Mesh mesh) const { return detector_.detector(std::move(mesh)); }

  std::filesystem::path path_;
  int repeat_ = 1;
  bool json_ = false;

  DetectorArguments detector_;

 private:
  WeldArgument weld_;
};

}  // namespace tamis::cli
