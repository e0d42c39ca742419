// Integers of any size and their fractions. Without expression templates: every result has one of these two types.
#pragma once
#include <boost/multiprecision/cpp_int.hpp>

namespace tamis::oracle {

using Integer = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>, boost::multiprecision::et_off>;
using Rational =
    boost::multiprecision::number<boost::multiprecision::cpp_rational_backend, boost::multiprecision::et_off>;

}  // namespace tamis::oracle
