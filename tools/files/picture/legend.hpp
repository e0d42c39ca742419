// The legend for the colours of contacts.
#pragma once
#include "files/picture/png.hpp"

namespace tamis::io {

/// Draws a bar with the colours of times 0 to 1 into the lower left corner, with these numbers at its ends. A picture
/// of less than 320 by 180 pixels stays as it is.
void draw_legend(Image& image);

}  // namespace tamis::io
