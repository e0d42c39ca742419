// Numbers as bytes of a message, and back. All ranks run one program on one kind of machine.
#pragma once
#include <cstddef>
#include <cstring>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace tamis::distributed {

using Bytes = std::vector<std::byte>;

class Packer {
 public:
  template <class T>
  void put(const T& value) {
    append(&value, 1);
  }
  /// Puts the length first.
  template <class T>
  void put_all(const std::vector<T>& values) {
    put(values.size());
    append(values.data(), values.size());
  }
  bool empty() const { return bytes_.empty(); }
  Bytes take() { return std::move(bytes_); }

 private:
  template <class T>
  void append(const T* values, std::size_t count) {
    static_assert(std::is_trivially_copyable_v<T>);
    const auto* first = reinterpret_cast<const std::byte*>(values);
    bytes_.insert(bytes_.end(), first, first + count * sizeof(T));
  }

  Bytes bytes_;
};

/// REQUIRES: reads the values that a Packer put, in the same order. Keeps a reference.
class Unpacker {
 public:
  explicit Unpacker(std::span<const std::byte> bytes) : rest_(bytes) {}

  template <class T>
  T get() {
    T value;
    copy(&value, 1);
    return value;
  }
  template <class T>
  std::vector<T> get_all() {
    std::vector<T> values(get<std::size_t>());
    copy(values.data(), values.size());
    return values;
  }
  bool empty() const { return rest_.empty(); }

 private:
  template <class T>
  void copy(T* values, std::size_t count) {
    static_assert(std::is_trivially_copyable_v<T>);
    if (count > 0) std::memcpy(values, rest_.data(), count * sizeof(T));
    rest_ = rest_.subspan(count * sizeof(T));
  }

  std::span<const std::byte> rest_;
};

}  // namespace tamis::distributed
