#include "oc_core/drawing/drawing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oc_core/drawing/drawing_error.h"
#include "oc_core/drawing/figure.h"

namespace ocelli {
namespace {

constexpr Paint kRed{1, 0, 0};

Figure figureOf(double width, double height) {
  Figure figure;
  figure.width = width;
  figure.height = height;
  return figure;
}

TEST(Drawing, aPixelIsAPointAndTheGroundIsWhite) {
  Figure figure = figureOf(4, 3);
  figure.drawing.box("box", {1, 1, 3, 2}, kRed);
  const Pixels pixels = pixelsOf(figure);
  EXPECT_EQ(pixels.width, 4);
  EXPECT_EQ(pixels.height, 3);
  EXPECT_THAT(pixels.values, testing::ElementsAre(0xffffff, 0xffffff, 0xffffff, 0xffffff,  //
                                                  0xffffff, 0xff0000, 0xff0000, 0xffffff,  //
                                                  0xffffff, 0xffffff, 0xffffff, 0xffffff));
}

TEST(Drawing, anImageKeepsItsPixels) {
  Figure figure = figureOf(2, 2);
  const Pixels image{2, 2, {0x102030, 0x000000, 0xffffff, 0xabcdef}};
  figure.drawing.image("image", {0, 0, 2, 2}, image);
  EXPECT_EQ(pixelsOf(figure).values, image.values);
}

TEST(Drawing, aClipHoldsUntilTheNext) {
  Figure figure = figureOf(3, 1);
  figure.drawing.clip(PlotBox{1, 0, 2, 1});
  figure.drawing.box("all", {0, 0, 3, 1}, kRed);
  EXPECT_THAT(pixelsOf(figure).values, testing::ElementsAre(0xffffff, 0xff0000, 0xffffff));
  figure.drawing.clip(std::nullopt);
  figure.drawing.box("left", {0, 0, 1, 1}, kRed);
  EXPECT_THAT(pixelsOf(figure).values, testing::ElementsAre(0xff0000, 0xff0000, 0xffffff));
}

TEST(Drawing, whatIsAddedIsScaledAndMoved) {
  Drawing inner;
  inner.image("image", {0, 0, 1, 1}, {1, 1, {0xff0000}});
  inner.clip(PlotBox{0, 0, 1, 1});
  Drawing outer;
  outer.add(inner, {10, 20}, 2);
  for (const size_t i : {0U, 1U}) {
    const Shape& shape = outer.shapes()[i];
    const PlotBox box = i == 0 ? boxOf(shape) : *std::get<ClipShape>(shape.what).box;
    EXPECT_EQ(box.left, 10);
    EXPECT_EQ(box.top, 20);
    EXPECT_EQ(box.right, 12);
    EXPECT_EQ(box.bottom, 22);
  }
}

TEST(Drawing, roundEndsReachBeyondTheirPoints) {
  Figure figure = figureOf(6, 2);
  figure.drawing.line("line", {2, 1}, {4, 1}, {kRed, 2});
  const Pixels cut = pixelsOf(figure);
  EXPECT_EQ(cut.values[1], 0xffffffU);
  figure.drawing.line("line", {2, 1}, {4, 1}, {kRed, 2, {}, true});
  EXPECT_NE(pixelsOf(figure).values[1], 0xffffffU);
}

TEST(Drawing, oneThatIsTooLargeIsAnError) {
  // Cairo's images have less than 32768 pixels a side.
  EXPECT_THROW(pixelsOf(figureOf(1e6, 10)), DrawingError);
}

}  // namespace
}  // namespace ocelli
