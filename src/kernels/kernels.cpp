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

}  // namespace

const Kernels& kernels(Isa isa) {
  if (isa == Isa::best)
    isa = is_available(Isa::avx512) ? Isa::avx512 : is_available(Isa::avx2) ? Isa::avx2 : Isa::baseline;
  if (!is_available(isa)) throw InvalidOptions("this machine has no " + std::string(name_of(isa)) + ": use 'best'");
#ifdef TAMIS_X86_KERNELS
  if (isa == Isa::avx512) return avx512::kKernels;
  if (isa == Isa::avx2) return avx2::kKernels;
#endif
  return baseline::kKernels;
}

}  // namespace tamis
