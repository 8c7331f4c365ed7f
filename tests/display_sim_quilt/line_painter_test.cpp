#include "display_sim/quilt/line_painter.h"

#include <gtest/gtest.h>

namespace ocelli {
namespace {

constexpr glm::vec3 kRed{1, 0, 0};
constexpr glm::vec3 kBlue{0, 0, 1};

void addRun(SampleLine& line, float from, float to, float inverseZ, const glm::vec3& color) {
  for (const float u : {from, to}) {
    line.u.push_back(u);
    line.inverseZ.push_back(inverseZ);
    line.color.push_back(color);
    line.joinsNext.push_back(u == from ? 1 : 0);
  }
}

struct Painted {
  std::string colors;  ///< r, b, or . for black
  std::vector<float> inverseZ;
  size_t unknown = 0;
};

Painted paint(const SampleLine& line, const LineMap& map, int width, bool knowsEmpty, float emptyInverseZ = 0.01f) {
  static const SrgbEncoder encoder;
  const SampleLines lines{PinholeCamera(View{}, 8, 8), {}, emptyInverseZ, knowsEmpty};
  LinePainter painter(width);
  std::vector<Rgb8> colors(static_cast<size_t>(width));
  Painted painted;
  painted.inverseZ.resize(static_cast<size_t>(width));
  painter.draw(line, map);
  painted.unknown = painter.write(line, lines, encoder, colors.data(), painted.inverseZ.data());
  for (const Rgb8& c : colors) {
    painted.colors += c.r > 0 ? 'r' : c.b > 0 ? 'b' : '.';
  }
  return painted;
}

TEST(LinePainter, theNearerRunHidesTheFarther) {
  SampleLine line;
  addRun(line, 0, 8, 0.1f, kBlue);
  addRun(line, 2, 5, 0.2f, kRed);
  EXPECT_EQ(paint(line, {}, 8, true).colors, "bbrrrbbb");
}

TEST(LinePainter, runsMoveByTheirDepth) {
  SampleLine line;
  addRun(line, 0, 8, 0.1f, kBlue);
  addRun(line, 2, 5, 0.2f, kRed);
  // The far one stays, the near one moves two pixels to the right.
  EXPECT_EQ(paint(line, {1, 20, -2}, 8, true).colors, "bbbbrrrb");
}

TEST(LinePainter, gapsRepeatTheFartherSide) {
  SampleLine line;
  addRun(line, 0, 3, 0.1f, kBlue);
  addRun(line, 5, 8, 0.2f, kRed);
  const Painted painted = paint(line, {}, 8, true);
  EXPECT_EQ(painted.colors, "bbbbbrrr");
  EXPECT_EQ(painted.unknown, 2u);
  EXPECT_EQ(painted.inverseZ[4], 0);  // a colour, but no sample
  EXPECT_FLOAT_EQ(painted.inverseZ[5], 0.2f);
}

TEST(LinePainter, gapsStayBlackWhereNothingIsKnownOfWhatIsEmpty) {
  SampleLine line;
  addRun(line, 0, 3, 0.1f, kBlue);
  addRun(line, 5, 8, 0.2f, kRed);
  const Painted painted = paint(line, {}, 8, false);
  EXPECT_EQ(painted.colors, "bbb..rrr");
  EXPECT_EQ(painted.unknown, 2u);
}

TEST(LinePainter, whatWasSeenToBeEmptyStaysBlack) {
  SampleLine line;
  addRun(line, 0, 4, 0.2f, kRed);
  addRun(line, 4, 8, 0.01f, glm::vec3(0));
  const Painted painted = paint(line, {}, 10, true);
  EXPECT_EQ(painted.colors, "rrrr......");
  EXPECT_EQ(painted.unknown, 0u);  // what lies beyond the last one counts as empty, too
}

TEST(LinePainter, colorsOfARunThatRecedesAreThoseOfItsPlane) {
  // From z = 1 to z = 4: halfway in the image, the point is a fifth of the way along the run.
  SampleLine line;
  line.u = {0, 3};
  line.inverseZ = {1, 0.25f};
  line.color = {glm::vec3(0), glm::vec3(1)};
  line.joinsNext = {1, 0};
  static const SrgbEncoder encoder;
  const SampleLines lines{PinholeCamera(View{}, 8, 8), {}, 0.01f, true};
  LinePainter painter(3);
  std::vector<Rgb8> colors(3);
  painter.draw(line, {});
  painter.write(line, lines, encoder, colors.data(), nullptr);
  EXPECT_EQ(colors[1].r, encoder.byteFromLinear(0.2f));
}

TEST(LinePainter, aRunThatIsSeenFromItsBackIsDrawnToo) {
  SampleLine line;
  line.u = {1, 3};
  line.inverseZ = {0.2f, 0.1f};
  line.color = {kRed, kRed};
  line.joinsNext = {1, 0};
  // The first end moves by 8 pixels, the second by 4.
  EXPECT_EQ(paint(line, {1, 40, 0}, 12, true).colors.substr(5), "rrrrrrr");
}

TEST(LinePainter, manyPixelsBeyondTheBordersAreNotDrawn) {
  SampleLine line;
  addRun(line, -1e9f, 1e9f, 0.1f, kBlue);
  EXPECT_EQ(paint(line, {}, 4, true).colors, "bbbb");
  SampleLine aside;
  addRun(aside, 1e9f, 2e9f, 0.1f, kBlue);
  EXPECT_EQ(paint(aside, {}, 4, true).colors, "....");
}

}  // namespace
}  // namespace ocelli
