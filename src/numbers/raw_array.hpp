// Memory that is not initialized. Filling it with zeros first would take as long as writing it.
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <type_traits>

#include "numbers/assert.hpp"

namespace tamis {

/// As std::make_unique_for_overwrite, which libc++ has from version 16 on.
template <class T>
std::unique_ptr<T> make_raw() {
  return std::unique_ptr<T>(new T);
}

/// An array of fixed size whose elements are not initialized.
template <class T>
class RawArray {
  static_assert(std::is_trivially_default_constructible_v<T>);

 public:
  RawArray() = default;
  explicit RawArray(std::size_t size) : elements_(new T[size]), size_(size) {}

  std::size_t size() const { return size_; }
  T* data() { return elements_.get(); }
  const T* data() const { return elements_.get(); }
  T& operator[](std::size_t i) {
    TAMIS_ASSERT(i < size_);
    return elements_[i];
  }
  const T& operator[](std::size_t i) const {
    TAMIS_ASSERT(i < size_);
    return elements_[i];
  }
  std::span<const T> all() const { return {data(), size_}; }
  std::uint64_t memory_bytes() const { return size_ * sizeof(T); }

 private:
  std::unique_ptr<T[]> elements_;
  std::size_t size_ = 0;
};

}  // namespace tamis
