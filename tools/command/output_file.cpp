#include "command/output_file.hpp"

#include <fmt/format.h>

#include "files/atomic_file.hpp"
#include "files/format.hpp"
#include "files/system.hpp"
#include "tamis/error.hpp"

namespace tamis::cli {
namespace {

/// A pipe or terminal may take the answer and the output. A regular file would keep only the later of them.
void require_not_taken(const std::filesystem::path& output) {
  for (const auto stream : {system::Stream::out, system::Stream::err})
    if (system::shared_by(stream, output) == system::Shared::file)
      throw InvalidOptions(
          fmt::format("--out {} is where the answer or its notes go: give another name", output.string()));
}

void require_not_mixed(const std::filesystem::path& output) {
  if (system::shared_by(system::Stream::out, output) == system::Shared::pipe)
    throw InvalidOptions(
        fmt::format("--out {} is the pipe of the answer, which must not mix with anything (JSON, or rows one by one): "
                    "give another name, or in bash a pipe of its own, as in --out >(head)",
                    output.string()));
}

}  // namespace

void declare_output(OptionList& options, std::filesystem::path& path, const std::string& help) {
  options.add_path("--out", path, help).shown_as("FILE");
}

void require_output(const std::filesystem::path& output, const std::vector<std::filesystem::path>& inputs,
                    bool answer_is_alone, std::string_view extension) {
  if (output.empty()) return;
  std::error_code error;
  for (const std::filesystem::path& input : inputs)
    if (std::filesystem::equivalent(output, input, error))
      throw InvalidOptions(fmt::format("--out {} would overwrite an input: give another name", output.string()));
  require_not_taken(output);
  if (answer_is_alone) require_not_mixed(output);
  if (!extension.empty()) io::format_of(output, {&extension, 1});
  io::require_writable(output);
}

void require_two_outputs(const std::filesystem::path& first, const std::filesystem::path& second) {
  namespace fs = std::filesystem;
  if (first.empty() || second.empty()) return;
  std::error_code error;
  // The first compares files that are there already, by whatever links; the second names.
  const auto full_name = [](const fs::path& path) { return fs::weakly_canonical(fs::absolute(path)); };
  if (fs::equivalent(first, second, error) || full_name(first) == full_name(second))
    throw InvalidOptions(fmt::format("{} is named for two outputs: give each a name of its own", second.string()));
}

}  // namespace tamis::cli
