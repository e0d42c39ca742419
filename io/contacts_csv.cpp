#include "io/contacts_csv.hpp"

#include <fmt/format.h>

#include "io/atomic_file.hpp"

namespace tamis::io {

void write_contacts_csv(const std::filesystem::path& path, std::span<const Contact> contacts) {
  // Rows are collected up to this size, not in full: a step may have millions.
  constexpr std::size_t kChunk = std::size_t{1} << 16;
  AtomicFile file(path);
  fmt::memory_buffer text;
  const auto flush = [&] {
    file.append({text.data(), text.size()});
    text.clear();
  };
  fmt::format_to(std::back_inserter(text), "kind,v0,v1,v2,v3,toi_lower,toi_upper,u,v,status\n");
  for (const Contact& c : contacts) {
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{},{},{},{}\n", name_of(c.kind), c.vertices[0],
                   c.vertices[1], c.vertices[2], c.vertices[3], c.toi_lower, c.toi_upper, c.u, c.v,
                   c.certainty == Certainty::certified ? "certified" : "unresolved");
    if (text.size() > kChunk) flush();
  }
  flush();
  file.commit();
}

}  // namespace tamis::io
