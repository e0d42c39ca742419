#include "files/view/columns.hpp"

#include <vector>

namespace tamis::io {

void append_differences(std::string& bytes, std::span<const std::uint32_t> column, std::size_t width) {
  std::vector<std::uint32_t> folded(column.size());
  for (std::size_t i = 0; i < column.size(); ++i) {
    const std::uint32_t difference = column[i] - (i < width ? 0 : column[i - width]);
    const std::uint32_t sign = difference >> 31;
    folded[i] = (difference << 1) ^ (0 - sign);
  }
  append_planes<std::uint32_t>(bytes, folded);
}

}  // namespace tamis::io
