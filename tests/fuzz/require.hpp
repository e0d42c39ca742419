// How a fuzz target says that a promise is broken: the fuzzer keeps the input that led there.
#pragma once
#include <cstdio>
#include <cstdlib>
#include <string>

namespace tamis::fuzz {

template <class Describe>
void require(bool promise, const char* what, const Describe& describe) {
  if (promise) return;
  std::fprintf(stderr, "%s\n%s\n", what, std::string(describe()).c_str());
  std::abort();
}

}  // namespace tamis::fuzz
