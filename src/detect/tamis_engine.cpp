#include "detect/engine.hpp"

namespace tamis {

std::unique_ptr<Engine> make_tamis_engine(const Mesh& mesh, const Options& options) {
  return make_brute_engine(mesh, options);
}

}  // namespace tamis
