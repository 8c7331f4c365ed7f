#include "oc_core/drawing/drawing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "oc_core/base/utf8.h"

namespace ocelli {
namespace {

PlotPoint moved(PlotPoint point, PlotPoint offset, double scale) {
  return {offset.x + scale * point.x, offset.y + scale * point.y};
}

void scalePen(std::optional<Pen>& pen, double scale) {
  if (pen) {
    pen->width *= scale;
    for (double& length : pen->dash) {
      length *= scale;
    }
  }
}

void place(PathShape& shape, PlotPoint offset, double scale) {
  for (std::vector<PlotPoint>& line : shape.lines) {
    for (PlotPoint& point : line) {
      point = moved(point, offset, scale);
    }
  }
  scalePen(shape.pen, scale);
}

void place(MarkerShape& shape, PlotPoint offset, double scale) {
  shape.at = moved(shape.at, offset, scale);
  shape.radius *= scale;
  scalePen(shape.pen, scale);
}

void place(TextShape& shape, PlotPoint offset, double scale) {
  shape.start = moved(shape.start, offset, scale);
  shape.size *= scale;
}

PlotBox moved(const PlotBox& box, PlotPoint offset, double scale) {
  const PlotPoint first = moved(PlotPoint{box.left, box.top}, offset, scale);
  const PlotPoint last = moved(PlotPoint{box.right, box.bottom}, offset, scale);
  return {first.x, first.y, last.x, last.y};
}

void place(ImageShape& shape, PlotPoint offset, double scale) {
  shape.box = moved(shape.box, offset, scale);
}

void place(ClipShape& shape, PlotPoint offset, double scale) {
  if (shape.box) {
    shape.box = moved(*shape.box, offset, scale);
  }
}

bool isFinite(PlotPoint point) {
  return std::isfinite(point.x) && std::isfinite(point.y);
}

bool isFinite(const std::optional<Pen>& pen) {
  return !pen || (std::isfinite(pen->width) &&
                  std::all_of(pen->dash.begin(), pen->dash.end(), [](double length) { return std::isfinite(length); }));
}

bool isFinite(const PathShape& shape) {
  return isFinite(shape.pen) && std::all_of(shape.lines.begin(), shape.lines.end(), [](const auto& line) {
           return std::all_of(line.begin(), line.end(), [](PlotPoint point) { return isFinite(point); });
         });
}

bool isFinite(const MarkerShape& shape) {
  return isFinite(shape.at) && std::isfinite(shape.radius) && isFinite(shape.pen);
}

bool isFinite(const TextShape& shape) {
  return isFinite(shape.start) && std::isfinite(shape.size);
}

bool isFinite(const PlotBox& box) {
  return isFinite(PlotPoint{box.left, box.top}) && isFinite(PlotPoint{box.right, box.bottom});
}

bool isFinite(const ImageShape& shape) {
  return isFinite(shape.box);
}

bool isFinite(const ClipShape& shape) {
  return !shape.box || isFinite(*shape.box);
}

PlotBox coverOfNothing() {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  return {kFar, kFar, -kFar, -kFar};
}

PlotBox cover(const ImageShape& shape) {
  return shape.box;
}

PlotBox cover(const ClipShape&) {
  return coverOfNothing();
}

PlotBox cover(const PathShape& shape) {
  PlotBox box = coverOfNothing();
  for (const std::vector<PlotPoint>& line : shape.lines) {
    for (const PlotPoint& point : line) {
      box = {std::min(box.left, point.x), std::min(box.top, point.y), std::max(box.right, point.x),
             std::max(box.bottom, point.y)};
    }
  }
  return box;
}

PlotBox cover(const MarkerShape& shape) {
  return {shape.at.x - shape.radius, shape.at.y - shape.radius, shape.at.x + shape.radius, shape.at.y + shape.radius};
}

PlotBox cover(const TextShape& shape) {
  const double width = textWidth(shape.text, shape.face, shape.size);
  if (shape.upward) {
    return {shape.start.x - ascentOf(shape.size), shape.start.y - width, shape.start.x + descentOf(shape.size),
            shape.start.y};
  }
  return {shape.start.x, shape.start.y - ascentOf(shape.size), shape.start.x + width,
          shape.start.y + descentOf(shape.size)};
}

}  // namespace

void Drawing::path(std::string part, PathShape shape) {
  shapes_.push_back({std::move(part), std::move(shape)});
}

void Drawing::line(std::string part, PlotPoint from, PlotPoint to, const Pen& pen) {
  polyline(std::move(part), {from, to}, pen);
}

void Drawing::polyline(std::string part, std::vector<PlotPoint> points, const Pen& pen) {
  path(std::move(part), {{std::move(points)}, false, std::nullopt, pen});
}

void Drawing::box(std::string part, const PlotBox& box, std::optional<Paint> fill, std::optional<Pen> pen) {
  path(std::move(part), {{{{box.left, box.top}, {box.right, box.top}, {box.right, box.bottom}, {box.left, box.bottom}}},
                         true,
                         fill,
                         std::move(pen)});
}

void Drawing::marker(std::string part, const MarkerShape& shape) {
  shapes_.push_back({std::move(part), shape});
}

void Drawing::text(std::string part, PlotPoint at, std::string_view text, const TextLook& look) {
  std::string clean = cleanText(text);
  const double width = textWidth(clean, look.face, look.size);
  const double back = look.across == Across::kLeft ? 0 : look.across == Across::kMiddle ? width / 2 : width;
  double lower = 0;  // from the given place to the baseline
  switch (look.down) {
    case Down::kTop:
      lower = ascentOf(look.size);
      break;
    case Down::kMiddle:
      lower = (ascentOf(look.size) - descentOf(look.size)) / 2;
      break;
    case Down::kBaseline:
      break;
    case Down::kBottom:
      lower = -descentOf(look.size);
      break;
  }
  const PlotPoint start = look.upward ? PlotPoint{at.x + lower, at.y + back} : PlotPoint{at.x - back, at.y + lower};
  shapes_.push_back(
      {std::move(part), TextShape{start, std::move(clean), look.face, look.size, look.paint, look.upward}});
}

void Drawing::image(std::string part, const PlotBox& box, Pixels pixels) {
  shapes_.push_back({std::move(part), ImageShape{box, std::move(pixels)}});
}

void Drawing::clip(std::optional<PlotBox> box) {
  shapes_.push_back({"clip", ClipShape{box}});
}

void Drawing::add(const Drawing& other, PlotPoint offset, double scale) {
  for (const Shape& shape : other.shapes_) {
    shapes_.push_back(shape);
    std::visit([&](auto& what) { place(what, offset, scale); }, shapes_.back().what);
  }
}

bool isFinite(const Drawing& drawing) {
  return std::all_of(drawing.shapes().begin(), drawing.shapes().end(), [](const Shape& shape) {
    return std::visit([](const auto& what) { return isFinite(what); }, shape.what);
  });
}

PlotBox boxOf(const Shape& shape) {
  return std::visit([](const auto& what) { return cover(what); }, shape.what);
}

std::vector<PlotPoint> markerCorners(Marker marker) {
  switch (marker) {
    case Marker::kCircle:
      return {};
    case Marker::kSquare:
      return {{-0.89, -0.89}, {0.89, -0.89}, {0.89, 0.89}, {-0.89, 0.89}};
    case Marker::kTriangle:
      return {{0, -1.25}, {1.15, 0.8}, {-1.15, 0.8}};
    case Marker::kDiamond:
      return {{0, -1.3}, {1.3, 0}, {0, 1.3}, {-1.3, 0}};
    case Marker::kTriangleDown:
      return {{0, 1.25}, {1.15, -0.8}, {-1.15, -0.8}};
    case Marker::kPlus:
      return {{-1, 0}, {1, 0}, {0, -1}, {0, 1}};
    case Marker::kCross:
      return {{-0.8, -0.8}, {0.8, 0.8}, {-0.8, 0.8}, {0.8, -0.8}};
  }
  return {};
}

}  // namespace ocelli
