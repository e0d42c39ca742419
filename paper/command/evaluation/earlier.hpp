// The rows of an evaluation that an earlier run of tamis-lab paper finished.
#pragma once
#include <filesystem>
#include <string_view>
#include <vector>

#include "files/file_bytes.hpp"
#include "paper/command/evaluation/run.hpp"

namespace tamis::lab {

class EarlierResults {
 public:
  /// Reads table1.csv and stages.csv of `folder`; without a table there are no rows. Throws FileError, naming the line,
  /// for a row that write_paper_table or write_paper_stages did not write.
  explicit EarlierResults(const std::filesystem::path& folder);
  // Names of stages are views of the files.
  EarlierResults(const EarlierResults&) = delete;
  EarlierResults& operator=(const EarlierResults&) = delete;

  /// Null if there is no such row.
  const SceneResult* find(std::string_view scene, int factor) const;
  /// Adds the rows that `results` lacks.
  void append_rest(std::vector<SceneResult>& results) const;

 private:
  void read_table(const std::filesystem::path& file);
  void read_stages(const std::filesystem::path& file);
  SceneResult& row(std::string_view scene, int factor);

  std::vector<io::FileBytes> files_;
  std::vector<SceneResult> results_;
};

}  // namespace tamis::lab
