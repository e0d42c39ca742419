// `--out` of the verbs that show contacts or intersections: tables and files to look at.
#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "command/command_line/option_list.hpp"
#include "files/view/outputs.hpp"

namespace tamis::cli {

enum class Shown { steps, pose };

/// The file to write.
class LookOutput {
 public:
  /// `path`: the default, "" for none. `shown`: a pose has fewer formats.
  LookOutput(std::filesystem::path path, io::NoExtension without, Shown shown = Shown::steps)
      : path_(std::move(path)), without_(without), shown_(shown) {}

  void declare(OptionList& options);
  /// To be called before anything is read. Throws io::FileError if no output has this extension.
  void check() const;
  /// To be called before the work. Throws as check() and require_output() do, and if the output cannot hold so many
  /// steps; 0 steps: a pose.
  void require(const std::vector<std::filesystem::path>& inputs, std::size_t steps, bool answer_is_alone) const;
  /// Writes nothing if there is no output.
  void write(const io::Recording& recording) const;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::vector<io::Output> choices() const;
  /// REQUIRES: a path.
  io::Output output() const;

  std::filesystem::path path_;
  io::NoExtension without_;
  Shown shown_;
};

/// The recording of a pose. Valid as long as the detector. REQUIRES: the detector's last answer is `found`.
io::Recording recording_of(const Detector& detector, const std::filesystem::path& name, std::vector<Point> positions,
                           std::span<const Intersection> found);

}  // namespace tamis::cli
