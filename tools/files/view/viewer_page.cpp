#include "files/view/viewer_page.hpp"

#include <b64/encode.h>
#include <zlib.h>

#include <string_view>

#include "files/atomic_file.hpp"
#include "files/error.hpp"
#include "files/view/quantised.hpp"
#include "files/view/scene_bytes.hpp"
#include "numbers/floating_point_state.hpp"

// The built page becomes part of the program, or of the module for Python.
asm(".section .rodata\n"
    "tamis_page_begin: .incbin \"" TAMIS_VIEWER_PAGE
    "\"\n"
    "tamis_page_end: .byte 0\n"
    ".global tamis_page_begin, tamis_page_end\n"
    ".hidden tamis_page_begin, tamis_page_end\n"
    ".text\n");
extern "C" __attribute__((visibility("hidden"))) const char tamis_page_begin[];
extern "C" __attribute__((visibility("hidden"))) const char tamis_page_end[];

namespace tamis::io {
namespace {

std::string compressed(const std::string& bytes) {
  std::string result(compressBound(bytes.size()), '\0');
  uLongf size = result.size();
  // zlib fails only for want of memory here: the result is large enough for any input.
  if (compress2(reinterpret_cast<Bytef*>(result.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
                bytes.size(), Z_DEFAULT_COMPRESSION) != Z_OK)
    throw std::bad_alloc();
  result.resize(size);
  return result;
}

void append_base64(AtomicFile& file, std::string_view bytes) {
  constexpr std::size_t kChunk = std::size_t{1} << 16;
  base64::base64_encodestate state;
  base64::base64_init_encodestate(&state);
  std::string text(2 * kChunk, '\0');
  for (; !bytes.empty(); bytes.remove_prefix(std::min(kChunk, bytes.size()))) {
    const int size = static_cast<int>(std::min(kChunk, bytes.size()));
    const int length = base64::base64_encode_block(bytes.data(), size, text.data(), &state);
    file.append({text.data(), static_cast<std::size_t>(length)});
  }
  const int length = base64::base64_encode_blockend(text.data(), &state);
  file.append({text.data(), static_cast<std::size_t>(length)});
}

}  // namespace

void write_viewer_page(const std::filesystem::path& path, const Recording& recording) {
  const ComputingState state;
  if (const std::string_view why = why_not_quantised(recording); !why.empty())
    throw FileError(path.string(), "", fmt::format("{}, or write csv or vtp", why));
  const std::string_view page(tamis_page_begin, static_cast<std::size_t>(tamis_page_end - tamis_page_begin));
  constexpr std::string_view kPlace = "<!--SCENE-->";
  const std::size_t place = page.find(kPlace);
  AtomicFile file(path);
  file.append(page.substr(0, place));
  append_base64(file, compressed(scene_bytes(recording)));
  file.append(page.substr(place + kPlace.size()));
  file.commit();
}

}  // namespace tamis::io
