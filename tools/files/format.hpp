// The format that a file's name asks for.
#pragma once
#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>

namespace tamis::io {

/// May a name have no extension, as /dev/stdout? It then asks for the first format.
enum class NoExtension { is_first_format, is_refused };

/// The place in `extensions` ("csv", "html", ...) of the name's extension. Throws FileError, which lists them, for any
/// other extension: a file never has another format than its name says.
std::size_t format_of(const std::filesystem::path& path, std::span<const std::string_view> extensions,
                      NoExtension without = NoExtension::is_first_format);

}  // namespace tamis::io
