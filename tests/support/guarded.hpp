// Memory that ends, or begins, at a forbidden page: reading or writing one element too far ends the test.
#pragma once
#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstring>
#include <new>
#include <span>
#include <type_traits>

namespace tamis::test {

enum class Guard : bool { before, behind };

/// A copy of some elements, right behind or right before a forbidden page.
template <class T>
class Guarded {
 public:
  static_assert(std::is_trivially_copyable_v<T>);

  Guarded(std::span<const T> elements, Guard guard) {
    const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE)), bytes = elements.size_bytes();
    const std::size_t pages = (bytes + page - 1) / page;
    size_ = (pages + 2) * page;
    block_ = static_cast<std::byte*>(mmap(nullptr, size_, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0));
    if (block_ == MAP_FAILED || (pages > 0 && mprotect(block_ + page, pages * page, PROT_READ | PROT_WRITE) != 0))
      throw std::bad_alloc();
    std::byte* first = block_ + page + (guard == Guard::behind ? pages * page - bytes : 0);
    if (bytes > 0) std::memcpy(first, elements.data(), bytes);
    data_ = reinterpret_cast<T*>(first);
  }
  ~Guarded() { munmap(block_, size_); }
  Guarded(const Guarded&) = delete;
  Guarded& operator=(const Guarded&) = delete;

  T* data() const { return data_; }

 private:
  std::byte* block_;
  std::size_t size_;
  T* data_;
};

}  // namespace tamis::test
