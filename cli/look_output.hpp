// `--out` of the verbs that show contacts or intersections: tables, files to look at, pictures.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "cli/command_line/option_list.hpp"
#include "io/picture/picture.hpp"
#include "io/view/outputs.hpp"

namespace tamis::cli {

enum class Shown { steps, pose };

/// The file to write, and how a picture looks.
class LookOutput {
 public:
  /// `path`: by default, "" for none. `shown`: for a pose there are fewer formats, and no time.
  LookOutput(std::string path, io::NoExtension without, Shown shown = Shown::steps)
      : path_(std::move(path)), without_(without), shown_(shown) {}

  void declare(OptionList& options);
  /// Before anything is read: throws io::FileError if no output has this extension, InvalidOptions if none can be made,
  /// or an option of pictures comes without one.
  void check() const;
  /// Before the work: throws as check() and require_output(), and if the output does not hold so many steps; none: a
  /// pose.
  void require(const std::vector<std::filesystem::path>& inputs, std::size_t steps, bool answer_is_alone) const;
  /// Nothing if there is no output.
  void write(const io::Recording& recording) const;

  const std::string& path() const { return path_; }

 private:
  std::vector<io::Output> choices() const;
  /// REQUIRES: a path.
  io::Output output() const;
  io::PictureOptions picture() const;

  std::string path_;
  io::NoExtension without_;
  Shown shown_;
  Option time_option_;
  double time_ = io::PictureOptions().time;
  std::vector<double> from_;  ///< as given
  std::vector<int> size_;     ///< as given
};

/// What is shown of a pose. Valid as long as the detector; it has just answered.
io::Recording recording_of(const Detector& detector, const std::filesystem::path& name, std::vector<Point> positions,
                           const std::vector<Intersection>& found);

}  // namespace tamis::cli
