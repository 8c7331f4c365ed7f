// A drawing as plain data: what is painted where, in points (1/72 inch) from the top left, later things on top. Charts,
// plans and pages make drawings without knowing Cairo; figure.h and pdf_file.h paint them; tests and other readers find
// things in them by the part that they play.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "oc_core/drawing/typeface.h"
#include "oc_core/page/page_colors.h"

namespace ocelli {

inline constexpr double kPointsPerInch = 72;
inline constexpr double kPointsPerMillimetre = kPointsPerInch / 25.4;

struct PlotPoint {
  double x = 0;
  double y = 0;
};

struct PlotBox {
  double left = 0;
  double top = 0;
  double right = 0;
  double bottom = 0;

  double width() const { return right - left; }
  double height() const { return bottom - top; }
  double middleX() const { return (left + right) / 2; }
  double middleY() const { return (top + bottom) / 2; }
  bool overlaps(const PlotBox& o) const { return left < o.right && o.left < right && top < o.bottom && o.top < bottom; }
  /// `slack` in points.
  bool contains(const PlotBox& o, double slack = 0) const {
    return o.left >= left - slack && o.right <= right + slack && o.top >= top - slack && o.bottom <= bottom + slack;
  }
};

/// sRGB, 0 to 1.
struct Paint {
  double red = 0;
  double green = 0;
  double blue = 0;
  double opacity = 1;

  Paint faded(double newOpacity) const { return {red, green, blue, newOpacity}; }
};

constexpr Paint paintOf(uint32_t rgb) {
  return {(rgb >> 16 & 0xff) / 255.0, (rgb >> 8 & 0xff) / 255.0, (rgb & 0xff) / 255.0};
}
/// As on light pages.
constexpr Paint paintOf(const PageColor& color) {
  return paintOf(color.light);
}

using Dash = std::vector<double>;  ///< lengths on and off, points; empty for a full line

struct Pen {
  Paint paint;
  double width = 0.75;
  Dash dash = {};
  bool roundEnds = false;  ///< else cut off at the end points
};

enum class Marker { kCircle, kSquare, kTriangle, kDiamond, kTriangleDown, kPlus, kCross };

struct PathShape {
  std::vector<std::vector<PlotPoint>> lines;
  bool closed = false;
  std::optional<Paint> fill;
  std::optional<Pen> pen;
};

struct MarkerShape {
  PlotPoint at;
  Marker marker = Marker::kCircle;
  double radius = 2;  ///< of the circle; the others look as large
  std::optional<Paint> fill;
  std::optional<Pen> pen;
};

struct TextShape {
  PlotPoint start;  ///< of the baseline
  std::string text;
  Face face = Face::kSans;
  double size = 8;
  Paint paint;
  bool upward = false;  ///< turned by 90 degrees, to be read from below
};

/// sRGB as 0xRRGGBB, row by row from the top.
struct Pixels {
  int width = 0;
  int height = 0;
  std::vector<uint32_t> values;
};

struct ImageShape {
  PlotBox box;
  Pixels pixels;
};

/// Of what follows, only what lies in the box is painted; without a box everything again.
struct ClipShape {
  std::optional<PlotBox> box;
};

struct Shape {
  std::string part;  ///< "point", "interval", "tick label": what it stands for
  std::variant<PathShape, MarkerShape, TextShape, ImageShape, ClipShape> what;
};

enum class Across { kLeft, kMiddle, kRight };
enum class Down { kTop, kMiddle, kBaseline, kBottom };

struct TextLook {
  double size = 8;
  Face face = Face::kSans;
  Paint paint = paintOf(page_color::kText);
  Across across = Across::kLeft;  ///< which part of the text is at the given place
  Down down = Down::kBaseline;
  bool upward = false;  ///< then across is along the upward direction
};

class Drawing {
 public:
  const std::vector<Shape>& shapes() const { return shapes_; }

  void path(std::string part, PathShape shape);
  void line(std::string part, PlotPoint from, PlotPoint to, const Pen& pen);
  void polyline(std::string part, std::vector<PlotPoint> points, const Pen& pen);
  void box(std::string part, const PlotBox& box, std::optional<Paint> fill, std::optional<Pen> pen = std::nullopt);
  void marker(std::string part, const MarkerShape& shape);
  void text(std::string part, PlotPoint at, std::string_view text, const TextLook& look);
  void image(std::string part, const PlotBox& box, Pixels pixels);
  void clip(std::optional<PlotBox> box);
  /// Everything of `other`, scaled and then moved.
  void add(const Drawing& other, PlotPoint offset, double scale = 1);

 private:
  std::vector<Shape> shapes_;
};

/// What a shape covers: of lines the points themselves, of text its line, of markers the circle, of clips nothing.
PlotBox boxOf(const Shape& shape);

/// Whether all its numbers are finite: what is not cannot be painted.
bool isFinite(const Drawing& drawing);

/// The corners of a marker, in its own units: the circle has radius 1. Of crosses, ends of strokes in pairs.
std::vector<PlotPoint> markerCorners(Marker marker);

}  // namespace ocelli
