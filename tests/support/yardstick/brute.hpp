// The tests' yardstick: an engine that decides every pair.
#pragma once
#include "search/query/engine.hpp"

namespace tamis::yardstick {

/// Keeps references: mesh and options must outlive it.
std::unique_ptr<Engine> make_brute_engine(const Mesh& mesh, const tamis::Options& options);

}  // namespace tamis::yardstick
