// The format that a file's name asks for.
#pragma once
#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>

namespace tamis::io {

/// May a name have no extension, as /dev/stdout? It then asks for the first format.
enum class NoExtension { is_first_format, is_refused };

/// The place in `extensions` ("csv", "html", ...) of what the name ends in. Throws FileError, which names them, for any
/// other ending: what is written is what the name says.
std::size_t format_of(const std::filesystem::path& path, std::span<const std::string_view> extensions,
                      NoExtension without = NoExtension::is_first_format);

}  // namespace tamis::io
