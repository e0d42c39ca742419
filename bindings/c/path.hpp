// The handle of a path.
#pragma once
#include <memory>

#include "c/handle.hpp"
#include "tamis/path.hpp"

struct tamis_path : tamis::c::Handle<std::unique_ptr<const tamis::Path>> {};
