#include "files/picture/legend.hpp"

#include <algorithm>
#include <string_view>

#include "files/output/colours.hpp"

namespace tamis::io {
namespace {

// In pixels. In smaller pictures the legend would cover the scene.
constexpr int kLeastWidth = 320;
constexpr int kLeastHeight = 180;
constexpr Rgb kInk{0xd8, 0xde, 0xe8};
constexpr int kAdvance = 6;  ///< dots from one character to the next

/// A character of five by seven dots: two numbers need no font.
struct Character {
  char name;
  std::array<std::string_view, 7> rows;
};
constexpr std::array kCharacters{
    Character{'t', {".#...", ".#...", "###..", ".#...", ".#...", ".#..#", "..##."}},
    Character{'=', {".....", ".....", "#####", ".....", "#####", ".....", "....."}},
    Character{'0', {".###.", "#...#", "#..##", "#.#.#", "##..#", "#...#", ".###."}},
    Character{'1', {"..#..", ".##..", "..#..", "..#..", "..#..", "..#..", ".###."}},
};

/// Where something is, in pixels from the upper left corner.
struct Area {
  int left, top, width, height;
};

class Pen {
 public:
  explicit Pen(Image& image) : image_(image) {}

  void fill(const Area& area, const Rgb& colour) {
    for (int row = area.top; row < area.top + area.height; ++row)
      for (int column = area.left; column < area.left + area.width; ++column)
        image_.pixels[static_cast<std::size_t>(row) * static_cast<std::size_t>(image_.width) +
                      static_cast<std::size_t>(column)] = colour;
  }

  /// Dots are squares of `dot` pixels.
  void write(std::string_view text, int left, int top, int dot) {
    for (const char name : text) {
      const auto found = std::find_if(kCharacters.begin(), kCharacters.end(), [&](auto& c) { return c.name == name; });
      for (std::size_t row = 0; row < found->rows.size(); ++row)
        for (std::size_t column = 0; column < found->rows[row].size(); ++column)
          if (found->rows[row][column] == '#')
            fill({left + static_cast<int>(column) * dot, top + static_cast<int>(row) * dot, dot, dot}, kInk);
      left += kAdvance * dot;
    }
  }

 private:
  Image& image_;
};

}  // namespace

void draw_legend(Image& image) {
  if (image.width < kLeastWidth || image.height < kLeastHeight) return;
  Pen pen(image);
  const int dot = std::max(1, std::min(image.width / 640, image.height / 360));
  const int margin = 12 * dot, gap = 5 * dot, high = 7 * dot, top = image.height - margin - high;
  const Area bar{margin + 3 * kAdvance * dot + gap, top, 100 * dot, high};
  pen.write("t=0", margin, top, dot);
  pen.fill({bar.left - dot, bar.top - dot, bar.width + 2 * dot, bar.height + 2 * dot}, kInk);
  for (int i = 0; i < bar.width; ++i)
    pen.fill({bar.left + i, bar.top, 1, bar.height}, colour_of_time((i + 0.5) / bar.width));
  pen.write("1", bar.left + bar.width + gap, top, dot);
}

}  // namespace tamis::io
