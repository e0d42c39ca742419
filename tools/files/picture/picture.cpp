#include "files/picture/picture.hpp"

#include <tbb/parallel_for.h>

#include "files/picture/legend.hpp"
#include "files/picture/png.hpp"
#include "files/picture/scenery.hpp"
#include "numbers/floating_point_state.hpp"

namespace tamis::io {
namespace {

/// Another angle for each pixel (a hash by Wellons, public domain).
float turn_of(std::uint32_t pixel) {
  pixel = (pixel ^ pixel >> 16U) * 0x7feb352dU;
  pixel = (pixel ^ pixel >> 15U) * 0x846ca68bU;
  pixel ^= pixel >> 16U;
  constexpr float kTurn = 6.2831853F;
  return kTurn * static_cast<float>(pixel >> 8U) / static_cast<float>(1U << 24U);
}

/// The mean over four places of a pixel, each of which looks at another part of the sky.
Rgb pixel_at(const Scenery& scenery, const PictureOptions& options, int column, int row) {
  constexpr std::size_t kPlaces = 4;
  const float turn = turn_of(static_cast<std::uint32_t>(row * options.width + column));
  Light sum{};
  for (std::size_t place = 0; place < kPlaces; ++place) {
    const float dx = place % 2 == 0 ? 0.25F : 0.75F, dy = place < 2 ? 0.25F : 0.75F;
    const float x = 2 * (static_cast<float>(column) + dx) / static_cast<float>(options.width) - 1;
    const float y = 1 - 2 * (static_cast<float>(row) + dy) / static_cast<float>(options.height);
    sum = sum + scenery.seen_at(x, y, turn, place);
  }
  return screen_of((1.0F / kPlaces) * sum);
}

}  // namespace

void require_pictures() {}

void write_picture(const std::filesystem::path& path, const Recording& recording, const PictureOptions& options) {
  const ComputingState state;
  const Scenery scenery(recording, options);
  Image image{options.width, options.height, {}};
  image.pixels.resize(static_cast<std::size_t>(options.width) * static_cast<std::size_t>(options.height));
  const auto draw = [&](int row) {
    for (int column = 0; column < options.width; ++column)
      image.pixels[static_cast<std::size_t>(row) * static_cast<std::size_t>(options.width) +
                   static_cast<std::size_t>(column)] = pixel_at(scenery, options, column, row);
  };
  tbb::parallel_for(0, options.height, as_task(draw));
  if (!recording.pose && !recording.steps.front().contacts.empty()) draw_legend(image);  // of times: a pose has none
  write_png(path, image);
}

}  // namespace tamis::io
