// The one check of every file that a verb is told to write.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "command/command_line/option_list.hpp"

namespace tamis::cli {

/// `--out FILE`. `help` says what is written, and in which formats.
void declare_output(OptionList& options, std::filesystem::path& path, const std::string& help);

/// To be called before the work. Throws InvalidOptions if `output` is one of the inputs, by whatever link or spelling,
/// or the file that stdout or stderr goes to; io::FileError if its name has another extension than `extension` ("csv";
/// empty: any), or if it cannot be written. An empty `output` means no output, and is fine. A pipe that is stdout as
/// well gets the file first, then the answer. With `answer_is_alone` (JSON, or rows that are printed during the work)
/// such a pipe is refused.
void require_output(const std::filesystem::path& output, const std::vector<std::filesystem::path>& inputs,
                    bool answer_is_alone, std::string_view extension = {});

/// Throws InvalidOptions if both outputs are one file: the second would take the place of the first. Either may be
/// empty.
void require_two_outputs(const std::filesystem::path& first, const std::filesystem::path& second);

}  // namespace tamis::cli
