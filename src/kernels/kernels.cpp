#include "kernels/kernels.hpp"

#include <string>

#include "tamis/error.hpp"

namespace tamis {

namespace baseline {
extern const Kernels kKernels;
}
#ifdef TAMIS_X86_KERNELS
namespace avx2 {
extern const Kernels kKernels;
}
namespace avx512 {
extern const Kernels kKernels;
}
#endif

namespace {

bool is_available([[maybe_unused]] Isa isa) {
#ifdef TAMIS_X86_KERNELS
  if (isa == Isa::avx512)
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512cd") &&
           __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw") &&
           __builtin_cpu_supports("avx512vl");
  if (isa == Isa::avx2) return __builtin_cpu_supports("avx2");
#endif
  return isa == Isa::baseline;
}

/// The widest first.
constexpr const Kernels* kAll[] = {
#ifdef TAMIS_X86_KERNELS
    &avx512::kKernels, &avx2::kKernels,
#endif
    &baseline::kKernels};

}  // namespace

const Kernels& kernels(Isa isa) {
  for (const Kernels* const some : kAll)
    if ((isa == Isa::best || isa == some->isa) && is_available(some->isa)) return *some;
  throw InvalidOptions("this machine has no " + std::string(name_of(isa)) + ": use 'best'");
}

}  // namespace tamis
