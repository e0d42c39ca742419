#include "search/kernels/kernels.hpp"

#include <string>

#include "numbers/platform.hpp"
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

/// The kernels of an instruction set. Null if this machine or this build has none. The compiler names a set that is
/// missing here.
const Kernels* kernels_if_here(Isa isa) {
  switch (isa) {
#ifdef TAMIS_X86_KERNELS
    case Isa::avx512:
      return has_avx512() ? &avx512::kKernels : nullptr;
    case Isa::avx2:
      return has_avx2() ? &avx2::kKernels : nullptr;
#else
    case Isa::avx512:
    case Isa::avx2:
      return nullptr;
#endif
    case Isa::best:
      for (const Isa wide : {Isa::avx512, Isa::avx2})  // the widest first
        if (const Kernels* const here = kernels_if_here(wide)) return here;
      [[fallthrough]];
    case Isa::baseline:
      return &baseline::kKernels;
  }
  return nullptr;  // `isa` is no enumerator
}

}  // namespace

const Kernels& kernels(Isa isa) {
  if (const Kernels* const here = kernels_if_here(isa)) return *here;
  throw InvalidOptions("this machine has no " + std::string(name_of(isa)) + ": use 'best'");
}

}  // namespace tamis
