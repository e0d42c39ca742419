// Refuses to be compiled where products, sums or comparisons do not follow IEEE 754. Error bounds do not hold there.
#pragma once
#include <cfloat>

#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0) || \
    defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || defined(__NO_SIGNED_ZEROS__)
#error \
    "Tamis is compiled with -ffast-math or a part of it, and would miss contacts: add -fno-fast-math behind that option"
#endif
#if FLT_EVAL_METHOD != 0
#error \
    "Tamis is compiled where doubles are computed with another precision, and would miss contacts: add -mfpmath=sse -msse2"
#endif
