// Pictures of a step, looked at pixel by pixel: what is where, and what hides what.
#include "files/picture/picture.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#ifdef TAMIS_HAS_PICTURES
#include <png.h>
#include <tbb/global_control.h>
#endif

#include "files/output/colours.hpp"
#include "tamis/error.hpp"

namespace tamis::test {
namespace {

#ifndef TAMIS_HAS_PICTURES

TEST(Picture, SaysWhatIsMissing) { EXPECT_THROW(io::require_pictures(), InvalidOptions); }

#else

struct Pixels {
  int width = 0, height = 0;
  std::vector<std::uint8_t> bytes;

  int channel(int column, int row, int c) const {
    return bytes[3 * static_cast<std::size_t>(row * width + column) + static_cast<std::size_t>(c)];
  }
};

Pixels read_png(const std::filesystem::path& path) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  EXPECT_TRUE(png_image_begin_read_from_file(&png, path.c_str()));
  png.format = PNG_FORMAT_RGB;
  Pixels pixels{static_cast<int>(png.width), static_cast<int>(png.height), {}};
  pixels.bytes.resize(PNG_IMAGE_SIZE(png));
  EXPECT_TRUE(png_image_finish_read(&png, nullptr, pixels.bytes.data(), 0, nullptr));
  return pixels;
}

/// A square wall at z = 0, and a point before it that moves from its left to its right.
class Wall : public testing::Test {
 protected:
  Wall()
      : path_(std::filesystem::temp_directory_path() / testing::UnitTest::GetInstance()->current_test_info()->name()) {
    recording_.frames = {frame(-0.5), frame(0.5)};
    recording_.steps = {{{contact(0.45)}, {}}};
  }
  ~Wall() override { std::filesystem::remove(path_); }

  static std::vector<Point> frame(double x) { return {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {x, 0.5, 0.25}}; }
  static Contact contact(double time) {
    return {PairKind::vertex_face, Certainty::certified, {4, 0, 1, 2}, time, time, 0.5, 0.25, {0, 0, 1}};
  }
  Pixels picture(const io::PictureOptions& options = kFront) const { return picture_of(recording_, options); }
  Pixels picture_of(const io::Recording& recording, const io::PictureOptions& options) const {
    io::write_picture(path_, recording, options);
    return read_png(path_);
  }

  /// Where the contacts are seen: the pixels that they change.
  struct Spot {
    int pixels = 0;
    int change = 0;              ///< the largest
    double column = 0, row = 0;  ///< the mean, from -1 to 1, upwards
  };
  Spot spot(const io::PictureOptions& options = kFront) const {
    io::Recording bare = recording_;
    for (io::RecordedStep& step : bare.steps) step.contacts.clear();
    if (bare.pose) bare.pose->intersections.clear();
    const Pixels with = picture(options), without = picture_of(bare, options);
    Spot spot;
    for (int row = 0; row < with.height; ++row)
      for (int column = 0; column < with.width; ++column) {
        const int change = with.channel(column, row, 0) - without.channel(column, row, 0);
        if (change == 0) continue;
        ++spot.pixels;
        spot.change = std::max(spot.change, change);
        spot.column += 2.0 * column / with.width - 1;
        spot.row += 1 - 2.0 * row / with.height;
      }
    spot.column /= std::max(spot.pixels, 1);
    spot.row /= std::max(spot.pixels, 1);
    return spot;
  }

  static constexpr io::PictureOptions kFront{.from = {0, 0, 1}, .width = 160, .height = 120};
  std::filesystem::path path_;
  Mesh mesh_{5, {{0, 1, 2}, {0, 2, 3}}, {}, {4}};
  Options options_;
  io::Recording recording_{mesh_, options_, 1, {}, {}, {}};
};

TEST_F(Wall, IsInTheMiddleAndTheBackgroundIsDark) {
  const Pixels p = picture();
  EXPECT_EQ(p.width, 160);
  EXPECT_EQ(p.height, 120);
  EXPECT_GT(p.channel(80, 100, 2), 80);
  EXPECT_LT(p.channel(1, 1, 2), 60);
}

// Bug: pictures that are mirrored or upside down.
TEST_F(Wall, TheContactIsWhereItsPointIs) {
  const Spot left = spot();
  EXPECT_GT(left.pixels, 0);
  EXPECT_LT(left.column, -0.1);
  EXPECT_GT(left.row, 0.2);
}

// Bug: a pose has no second frame to look for.
TEST_F(Wall, TheIntersectionOfAPoseIsWhereItsPointIs) {
  recording_.frames.pop_back();
  recording_.steps.clear();
  recording_.pose = {{{{0, 4}, {0, 1, 2}, 1, 1, 0, 0}}, {}};
  const Spot left = spot();
  EXPECT_GT(left.pixels, 0);
  EXPECT_LT(left.column, -0.1);
  EXPECT_GT(left.row, 0.2);
}

TEST_F(Wall, TheContactMovesWithTime) {
  io::PictureOptions options = kFront;
  options.time = 1;
  EXPECT_GT(spot(options).column, 0.1);
  options.time = 0.5;
  EXPECT_NEAR(spot(options).column, 0, 0.05);
  recording_.scale = 0.5;
  options.time = 1;
  EXPECT_NEAR(spot(options).column, 0, 0.05);
}

// Bug: a contact behind a surface is not seen at all, or looks as if it were before it.
TEST_F(Wall, AContactBehindASurfaceShinesThrough) {
  io::PictureOptions from_behind = kFront;
  from_behind.from = {0, 0, -1};
  const Spot before = spot(), behind = spot(from_behind);
  EXPECT_GT(behind.pixels, 0);
  EXPECT_GT(behind.column, 0.1) << "seen from behind left is right";
  EXPECT_LT(behind.change, before.change);
  EXPECT_GT(behind.change, 10);
}

TEST_F(Wall, EarlyIsBrightAndLateIsDark) {
  recording_.steps[0].contacts = {contact(0)};
  const Pixels early = picture();
  recording_.steps[0].contacts = {contact(1)};
  const Pixels late = picture();
  int brighter = 0;
  for (std::size_t i = 1; i < early.bytes.size(); i += 3) brighter += early.bytes[i] > late.bytes[i] + 100;
  EXPECT_GT(brighter, 0);
}

// Bug: colours that nothing explains, or a bar the wrong way round.
TEST_F(Wall, ALegendSaysWhatTheColoursMean) {
  const io::PictureOptions large{.from = {0, 0, 1}, .width = 320, .height = 180};
  const Pixels with = picture(large);
  const auto column_of = [&](const io::Rgb& colour) {
    for (int column = 0; column < with.width / 2; ++column)
      if (with.channel(column, 164, 0) == colour[0] && with.channel(column, 164, 1) == colour[1]) return column;
    return -1;
  };
  const int early = column_of(io::colour_of_time(0.005)), late = column_of(io::colour_of_time(0.995));
  EXPECT_GT(early, 0);
  EXPECT_EQ(late - early, 99);
  recording_.steps[0].contacts.clear();
  const Pixels without = picture(large);
  EXPECT_LT(without.channel(early, 164, 0), 60) << "nothing needs to be explained";
}

TEST_F(Wall, TheBytesDoNotDependOnTheThreads) {
  const std::vector<std::uint8_t> many = picture().bytes;
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(picture().bytes, many);
}

// Bug: a direction along the axis that is up, or coordinates whose differences overflow, give no picture.
TEST_F(Wall, AnyDirectionAndAnySizeGiveAPicture) {
  for (const Point& from : {Point{0, 1, 0}, Point{0, -1e300, 0}, Point{1e-300, 0, 0}})
    EXPECT_EQ(picture({.from = from, .width = 16, .height = 16}).width, 16);
  for (auto& frame : recording_.frames)
    for (Point& p : frame)
      for (double& x : p) x *= 1e308;
  EXPECT_GT(spot().pixels, 0);
}

TEST_F(Wall, AStepWithoutContactsOrFacesIsAPictureToo) {
  recording_.steps[0].contacts.clear();
  const Mesh rods(5, {}, {{0, 1}}, {4});
  const Pixels p = picture_of({rods, options_, 1, {}, recording_.frames, recording_.steps}, kFront);
  int seen = 0;
  for (const std::uint8_t byte : p.bytes) seen += byte > 80;
  EXPECT_GT(seen, 0);
}

#endif

}  // namespace
}  // namespace tamis::test
