#include "files/view/viewer_page.hpp"

#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <new>
#include <string>
#include <string_view>

#include "files/atomic_file.hpp"
#include "files/error.hpp"
#include "files/view/page_text.hpp"
#include "files/view/quantised.hpp"
#include "files/view/scene_bytes.hpp"
#include "numbers/floating_point_state.hpp"

namespace tamis::io {
namespace {

std::string compressed(const std::string& bytes) {
  // zlib counts in unsigned long, which has 32 bits on Windows.
  const auto length = static_cast<uLong>(bytes.size());
  if (length != bytes.size()) throw std::bad_alloc();
  uLongf size = compressBound(length);
  std::string result(size, '\0');
  // zlib fails only for want of memory here: the result is large enough for any input.
  if (compress2(reinterpret_cast<Bytef*>(result.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()), length,
                Z_DEFAULT_COMPRESSION) != Z_OK)
    throw std::bad_alloc();
  result.resize(size);
  return result;
}

/// As in RFC 4648, without ends of lines.
std::string base64(std::string_view bytes) {
  constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  constexpr std::size_t kBytes = 3, kBits = 6;
  std::string text;
  text.reserve((bytes.size() + kBytes - 1) / kBytes * 4);
  for (; !bytes.empty(); bytes.remove_prefix(std::min(kBytes, bytes.size()))) {
    std::uint32_t group = 0;
    for (std::size_t i = 0; i < kBytes; ++i)
      group = group << 8U | (i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : 0U);
    for (std::size_t i = 0; i <= kBytes; ++i)
      text += i <= bytes.size() ? kDigits[group >> (kBits * (kBytes - i)) & 63U] : '=';
  }
  return text;
}

void append_texts(AtomicFile& file, const char* const* texts) {
  for (; *texts != nullptr; ++texts) file.append(*texts);
}

}  // namespace

void write_viewer_page(const std::filesystem::path& path, const Recording& recording) {
  const ComputingState state;
  if (const std::string_view why = why_not_quantised(recording); !why.empty())
    throw FileError(path.string(), "", fmt::format("{}, or write csv or vtp", why));
  AtomicFile file(path);
  append_texts(file, kPageBeforeScene);
  file.append(base64(compressed(scene_bytes(recording))));
  append_texts(file, kPageAfterScene);
  file.commit();
}

}  // namespace tamis::io
