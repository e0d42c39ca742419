// `--out` of the verbs that show contacts: tables, files to look at, pictures.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "cli/option_list.hpp"
#include "io/picture/picture.hpp"

namespace tamis::cli {

/// The file to write, and how a picture looks.
class LookOutput {
 public:
  /// `path`: by default, "" for none. `otherwise`: a name with the extension that stands for unknown ones; "": refused.
  LookOutput(std::string path, std::string otherwise) : path_(std::move(path)), otherwise_(std::move(otherwise)) {}

  void declare(OptionList& options);
  /// Before anything is read: throws InvalidOptions if no output has this extension, or none can be made, or an option
  /// of pictures comes without one.
  void check() const;
  /// Before the work: throws as check() and require_output(), and if the output does not hold so many steps.
  void require(const std::vector<std::filesystem::path>& inputs, std::size_t steps) const;
  /// Nothing if there is no output.
  void write(const io::Recording& recording) const;

  const std::string& path() const { return path_; }

 private:
  io::PictureOptions picture() const;

  std::string path_;
  std::string otherwise_;
  Option time_option_;
  double time_ = io::PictureOptions().time;
  std::vector<double> from_;  ///< as given
  std::vector<int> size_;     ///< as given
};

}  // namespace tamis::cli
