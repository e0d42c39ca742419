#include "cli/output_file.hpp"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "io/atomic_file.hpp"
#include "io/format.hpp"
#include "tamis/error.hpp"

namespace tamis::cli {
namespace {

/// A pipe or terminal may take both; of a file only the one that comes last would be left.
bool is_taken_by(int stream, const std::filesystem::path& output) {
  struct stat of_stream {
  }, of_output{};
  return fstat(stream, &of_stream) == 0 && stat(output.c_str(), &of_output) == 0 && S_ISREG(of_stream.st_mode) &&
         of_stream.st_dev == of_output.st_dev && of_stream.st_ino == of_output.st_ino;
}

}  // namespace

void declare_output(OptionList& options, std::string& path, const std::string& help) {
  options.add_text("--out", path, help).shown_as("FILE");
}

void require_output(const std::filesystem::path& output, const std::vector<std::filesystem::path>& inputs,
                    std::string_view extension) {
  if (output.empty()) return;
  std::error_code error;
  for (const std::filesystem::path& input : inputs)
    if (std::filesystem::equivalent(output, input, error))
      throw InvalidOptions(fmt::format("--out {} would overwrite an input: give another name", output.string()));
  for (const int stream : {STDOUT_FILENO, STDERR_FILENO})
    if (is_taken_by(stream, output))
      throw InvalidOptions(
          fmt::format("--out {} is where the answer or its notes go: give another name", output.string()));
  if (!extension.empty()) io::format_of(output, {&extension, 1});
  io::require_writable(output);
}

}  // namespace tamis::cli
