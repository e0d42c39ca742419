// JSON whose keys stay in the order in which they were added.
#pragma once
#include <nlohmann/json.hpp>

namespace tamis::io {

using Json = nlohmann::ordered_json;

}  // namespace tamis::io
