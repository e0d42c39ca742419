// The handle of a mesh.
#pragma once
#include <optional>

#include "c/handle.hpp"
#include "tamis/mesh.hpp"

struct tamis_mesh : tamis::c::Handle<std::optional<tamis::Mesh>> {};
