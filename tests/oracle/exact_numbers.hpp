// Integers of any size and their fractions: GMP's where it is installed. So the oracle shares no integers with the
// library, and is ten times as fast as with Boost's, which it has elsewhere. Without expression templates: every result
// has one of these two types.
#pragma once
#ifdef TAMIS_ORACLE_GMP
#include <boost/multiprecision/gmp.hpp>
#else
#include <boost/multiprecision/cpp_int.hpp>
#endif

namespace tamis::oracle {

#ifdef TAMIS_ORACLE_GMP
using Integer = boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;
using Rational = boost::multiprecision::number<boost::multiprecision::gmp_rational, boost::multiprecision::et_off>;
#else
using Integer = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>, boost::multiprecision::et_off>;
using Rational =
    boost::multiprecision::number<boost::multiprecision::cpp_rational_backend, boost::multiprecision::et_off>;
#endif

}  // namespace tamis::oracle
