// Memory that ends, or begins, at a forbidden page: reading or writing one element too far ends the test.
#pragma once
#if defined(_WIN32)
#define WIN32_LEAN_AND_MEAN
#if !defined(NOMINMAX)  // MinGW defines it itself
#define NOMINMAX
#endif
#include <windows.h>
#undef near
#undef far
#else
#include <sys/mman.h>
#include <unistd.h>
#endif

#include <cstddef>
#include <cstring>
#include <new>
#include <span>
#include <type_traits>

namespace tamis::test {

enum class Guard : bool { before, behind };

#if defined(_WIN32)
inline std::size_t page_size() {
  SYSTEM_INFO info{};
  GetSystemInfo(&info);
  return info.dwPageSize;
}
inline void* forbidden_memory(std::size_t size) { return VirtualAlloc(nullptr, size, MEM_RESERVE, PAGE_NOACCESS); }
inline bool allow(void* pages, std::size_t size) {
  return VirtualAlloc(pages, size, MEM_COMMIT, PAGE_READWRITE) != nullptr;
}
inline void release(void* memory, std::size_t /*size*/) { VirtualFree(memory, 0, MEM_RELEASE); }
#else
inline std::size_t page_size() { return static_cast<std::size_t>(sysconf(_SC_PAGESIZE)); }
/// Null if there is none.
inline void* forbidden_memory(std::size_t size) {
  void* const memory = mmap(nullptr, size, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  return memory == MAP_FAILED ? nullptr : memory;
}
inline bool allow(void* pages, std::size_t size) { return mprotect(pages, size, PROT_READ | PROT_WRITE) == 0; }
inline void release(void* memory, std::size_t size) { munmap(memory, size); }
#endif

/// A copy of some elements, right behind or right before a forbidden page.
template <class T>
class Guarded {
 public:
  static_assert(std::is_trivially_copyable_v<T>);

  Guarded(std::span<const T> elements, Guard guard) {
    const std::size_t page = page_size(), bytes = elements.size_bytes();
    const std::size_t pages = (bytes + page - 1) / page;
    size_ = (pages + 2) * page;
    block_ = static_cast<std::byte*>(forbidden_memory(size_));
    if (block_ == nullptr || (pages > 0 && !allow(block_ + page, pages * page))) throw std::bad_alloc();
    std::byte* first = block_ + page + (guard == Guard::behind ? pages * page - bytes : 0);
    if (bytes > 0) std::memcpy(first, elements.data(), bytes);
    data_ = reinterpret_cast<T*>(first);
  }
  ~Guarded() { release(block_, size_); }
  Guarded(const Guarded&) = delete;
  Guarded& operator=(const Guarded&) = delete;

  T* data() const { return data_; }

 private:
  std::byte* block_;
  std::size_t size_;
  T* data_;
};

}  // namespace tamis::test
