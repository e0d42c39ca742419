#include "numbers/wide_double.hpp"

#include "numbers/integer.hpp"

namespace tamis {

WideDouble WideDouble::of(const Integer& a) {
  WideDouble result;
  result.mantissa = a.fraction(result.exponent);
  return result;
}

}  // namespace tamis
