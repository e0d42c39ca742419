// The memory that parts of an object hold on the heap, which each memory_bytes() adds up.
#pragma once
#include <cstdint>
#include <type_traits>

namespace tamis {

/// An object's memory_bytes(). For a pointer or an optional: the bytes of its object, if any. For a vector of numbers:
/// its capacity. For other containers: the sum over their elements, or a map's values.
template <class Part>
std::uint64_t held_bytes(const Part& part) {
  if constexpr (requires { part.memory_bytes(); }) {
    return part.memory_bytes();
  } else if constexpr (requires { part.second; }) {
    return held_bytes(part.second);
  } else if constexpr (requires { *part; }) {
    return part ? held_bytes(*part) : 0;
  } else if constexpr (requires { part.capacity(); } && std::is_trivially_copyable_v<typename Part::value_type>) {
    return part.capacity() * sizeof(typename Part::value_type);
  } else {
    std::uint64_t bytes = 0;
    for (const auto& element : part) bytes += held_bytes(element);
    return bytes;
  }
}

/// The sum over all parts.
template <class... Parts>
requires(sizeof...(Parts) > 1) std::uint64_t held_bytes(const Parts&... parts) { return (held_bytes(parts) + ...); }

}  // namespace tamis
