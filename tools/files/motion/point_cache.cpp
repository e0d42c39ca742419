#include "files/motion/point_cache.hpp"

#include <bit>
#include <cstring>

#include "files/error.hpp"
#include "files/extension.hpp"
#include "numbers/floating_point_state.hpp"

namespace tamis::io {
namespace {

constexpr std::size_t kNumber = 4;  ///< bytes of every number in a cache

std::uint32_t word_at(const char* bytes, bool is_big_endian) {
  std::uint32_t word = 0;
  for (std::size_t i = 0; i < kNumber; ++i)
    word |= std::uint32_t{static_cast<unsigned char>(bytes[i])} << (8 * (is_big_endian ? kNumber - 1 - i : i));
  return word;
}

float float_at(const char* bytes, bool is_big_endian) { return std::bit_cast<float>(word_at(bytes, is_big_endian)); }

std::vector<char> take(std::ifstream& file, const std::string& name, std::size_t count) {
  std::vector<char> bytes(count);
  if (!file.read(bytes.data(), static_cast<std::streamsize>(count)))
    throw FileError(name, "", "the file ends in its header: it was cut short, write or copy it again");
  return bytes;
}

/// Refuses a count of frames that cannot be true: a cache that was cut short still holds a frame or a part of one; in a
/// file that is no cache the count may be anything.
void require_room(const PointCacheHeader& header, const std::string& name, std::uintmax_t size) {
  if (header.frames == 0 || header.frames > size)
    throw FileError(name, "", fmt::format("its header names {} frames: export it again", header.frames));
}

/// 12 characters, version, vertices, first frame, frames a sample, samples.
PointCacheHeader read_pc2(std::ifstream& file, const std::string& name, std::uintmax_t size) {
  constexpr std::size_t kSize = 32;
  const std::vector<char> bytes = take(file, name, kSize);
  if (std::memcmp(bytes.data(), "POINTCACHE2", 12) != 0)
    throw FileError(name, "", "a PC2 file begins with POINTCACHE2: export it again");
  PointCacheHeader header{word_at(&bytes[16], false), word_at(&bytes[28], false), {}, false};
  require_room(header, name, size);
  const double first = float_at(&bytes[20], false), rate = float_at(&bytes[24], false);
  for (std::uint32_t i = 0; i < header.frames; ++i) header.names.push_back(fmt::format("{:g}", first + i * rate));
  return header;
}

/// Frames, vertices, a time in seconds for each frame.
PointCacheHeader read_mdd(std::ifstream& file, const std::string& name, std::uintmax_t size) {
  const std::vector<char> counts = take(file, name, 2 * kNumber);
  PointCacheHeader header{word_at(&counts[kNumber], true), word_at(counts.data(), true), {}, true};
  require_room(header, name, size);
  const std::vector<char> times = take(file, name, kNumber * header.frames);
  header.notes.resize(header.frames);
  const auto time = [&](std::uint32_t i) { return float_at(&times[kNumber * i], true); };
  for (std::uint32_t i = 0; i < header.frames; ++i) {
    header.names.push_back(fmt::format("{:g} s", time(i)));
    if (i > 0 && !(time(i) > time(i - 1)))
      header.notes[i] = fmt::format(
          "its time does not come after {:g} s, the time of the frame before: are frames in order?", time(i - 1));
  }
  return header;
}

void require_fits(const PointCacheHeader& header, const Mesh& mesh, const std::string& name) {
  if (header.vertices != static_cast<std::uint32_t>(mesh.vertex_count()))
    throw FileError(name, "",
                    fmt::format("it has {} vertices a frame, the mesh {}: give the mesh that it was exported from",
                                header.vertices, mesh.vertex_count()));
}

}  // namespace

bool is_point_cache_name(const std::filesystem::path& path) {
  const std::string extension = extension_of(path);
  return extension == ".pc2" || extension == ".mdd";
}

PointCache::PointCache(const std::filesystem::path& path, std::shared_ptr<const audit::AuditedMesh> mesh)
    : file_(path, std::ios::binary), mesh_(std::move(mesh)) {
  const std::string name = path.string();
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (!file_ || error) throw FileError(name, "", "cannot be read: check the path and its permissions");
  header_ = extension_of(path) == ".pc2" ? read_pc2(file_, name, size) : read_mdd(file_, name, size);
  require_fits(header_, mesh_->mesh(), name);
}

audit::FramePointer PointCache::next() {
  const ComputingState state;
  if (next_ == header_.frames) return std::exchange(has_ended_, true) ? nullptr : what_is_left();
  audit::Frame frame{header_.names[next_], {}, mesh_};
  if (!header_.notes.empty()) frame.note = header_.notes[next_];
  if (read(frame.positions)) {
    ++next_;
  } else {
    frame.problem = fmt::format("the file ends here: it was cut short, and {} of its {} frames are not there",
                                header_.frames - next_, header_.frames);
    next_ = header_.frames;
    has_ended_ = true;
  }
  return std::make_shared<const audit::Frame>(std::move(frame));
}

audit::FramePointer PointCache::what_is_left() {
  if (file_.peek() == std::ifstream::traits_type::eof()) return nullptr;
  audit::Frame frame{"rest", {}, mesh_};
  frame.problem =
      fmt::format("the file continues after the {} frames that its header names: export it again", header_.frames);
  return std::make_shared<const audit::Frame>(std::move(frame));
}

bool PointCache::read(std::vector<Point>& positions) {
  std::vector<char> bytes(3 * kNumber * header_.vertices);
  if (!file_.read(bytes.data(), static_cast<std::streamsize>(bytes.size()))) return false;
  positions.resize(header_.vertices);
  const char* number = bytes.data();
  for (Point& point : positions)
    for (double& x : point) x = float_at(std::exchange(number, number + kNumber), header_.is_big_endian);
  return true;
}

}  // namespace tamis::io
