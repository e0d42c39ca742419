#include "support/describe.hpp"

#include <sstream>

namespace tamis::test {

std::string describe(PairKind kind, const oracle::Motion& motion) {
  std::ostringstream out;
  out << name_of(kind) << std::hexfloat;
  for (const auto* points : {&motion.start, &motion.end}) {
    out << (points == &motion.start ? "\n  start" : "\n  end  ");
    for (const Point& p : *points) out << " {" << p[0] << ", " << p[1] << ", " << p[2] << "}";
  }
  return out.str();
}

}  // namespace tamis::test
