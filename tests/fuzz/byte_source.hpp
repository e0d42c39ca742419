// A fuzzer's bytes as values; once they are used up, zeros.
#pragma once
#include <cmath>
#include <cstdint>
#include <cstring>
#include <span>

namespace tamis::fuzz {

class ByteSource {
 public:
  explicit ByteSource(std::span<const std::uint8_t> bytes) : left_(bytes) {}

  bool empty() const { return left_.empty(); }
  template <class T>
  T take() {
    T value{};
    const std::size_t size = left_.size() < sizeof(T) ? left_.size() : sizeof(T);
    if (size > 0) std::memcpy(&value, left_.data(), size);
    left_ = left_.subspan(size);
    return value;
  }
  /// In [0, count).
  int below(int count) { return take<std::uint8_t>() % count; }
  /// Any bits at all, as long as they are a finite double.
  double raw_double() {
    const auto value = take<double>();
    return std::isfinite(value) ? value : 0;
  }

 private:
  std::span<const std::uint8_t> left_;
};

}  // namespace tamis::fuzz
