#include "detect/engine.hpp"
#include "tamis/error.hpp"

namespace tamis {

std::unique_ptr<Engine> make_paper_engine(const Mesh&, const Options&) {
  throw InvalidOptions("the method 'paper' is not built yet: use 'tamis'");
}

}  // namespace tamis
