#include "bench/street_cameras.h"

#include <string>

namespace ocelli {
namespace {

/// The street's own frame: x to the right and d ahead, in units of the way to the first crossing.
class Frame {
 public:
  Frame(const Street& street, const PinholeCamera& camera)
      : eye_(camera.eye()), right_(camera.right()), ahead_(camera.forward()), unit_(street.toCrossing) {}

  glm::dvec3 point(double x, double d) const { return eye_ + (right_ * x + ahead_ * d) * unit_; }
  Plane plane(double x, double d, double normalX, double normalD) const {
    return Plane::through(point(x, d), right_ * normalX + ahead_ * normalD);
  }

 private:
  glm::dvec3 eye_;
  glm::dvec3 right_;
  glm::dvec3 ahead_;
  double unit_;
};

}  // namespace

GraphCamera streetGraph(const Street& street, int width, int height) {
  const PinholeCamera camera(street.view, width, height);
  const Frame frame(street, camera);
  GraphCamera graph(camera);
  // Columns of pixels in which the way so far to the right, for each unit ahead, is seen.
  const auto column = [&](double slope) {
    return static_cast<double>(camera.centerPixels().x) + slope * static_cast<double>(camera.focalPixels());
  };
  const double bottom = height;
  const auto columns = [&](double from, double to) {
    return GraphCamera::Part{{from, 0}, {to, 0}, {to, bottom}, {from, bottom}};
  };
  const double left = column(-0.08);
  const double right = column(0.08);
  graph.bend(0, {frame.plane(-0.08, 0.92, -1, 1), frame.point(0.27, 0.93)}, "left", columns(0, left));
  graph.bend(0, {frame.plane(0.08, 0.92, 1, 1), frame.point(-0.27, 0.93)}, "right", columns(right, width));
  const int ahead = graph.bend(0, {frame.plane(0, 1.27, 0, 1), frame.point(0, 0.18)}, "ahead", columns(left, right));
  const double farLeft = column(-0.03);
  const double farRight = column(0.03);
  graph.bend(ahead, {frame.plane(-0.1, 2.5, -1, 1), frame.point(0.3, 2.55)}, "far left", columns(left, farLeft));
  graph.bend(ahead, {frame.plane(0.1, 2.5, 1, 1), frame.point(-0.3, 2.55)}, "far right", columns(farRight, right));
  graph.bend(ahead, {frame.plane(0, 2.9, 0, 1), frame.point(0, 0.6)}, "far ahead", columns(farLeft, farRight));
  return graph;
}

GraphCamera columnsGraph(const Street& street, int width, int height, int frusta) {
  const PinholeCamera camera(street.view, width, height);
  const Frame frame(street, camera);
  GraphCamera graph(camera);
  const int levels = (frusta - 1) % 2 == 0 ? 2 : 1;
  const int columns = (frusta - 1) / levels;
  const auto slopeOf = [&](double column) {
    return (column - static_cast<double>(camera.centerPixels().x)) / static_cast<double>(camera.focalPixels());
  };
  const double bottom = height;
  for (int i = 0; i < columns; ++i) {
    const double from = static_cast<double>(width) * i / columns;
    const double to = static_cast<double>(width) * (i + 1) / columns;
    const GraphCamera::Part part{{from, 0}, {to, 0}, {to, bottom}, {from, bottom}};
    const double middle = slopeOf((from + to) / 2);
    const double aside = i % 2 == 0 ? 0.06 : -0.06;
    int last = 0;
    for (int level = 0; level < levels; ++level) {
      const double d = 0.9 + level;
      last = graph.bend(last, {frame.plane(0, d, 0, 1), frame.point(middle * (d - 0.6) + aside, d - 0.6)},
                        "column " + std::to_string(i) + ", " + std::to_string(level), part);
    }
  }
  return graph;
}

GraphCamera graphOf(const Street& street, int width, int height, int frusta) {
  return frusta == 1   ? GraphCamera(PinholeCamera(street.view, width, height))
         : frusta == 7 ? streetGraph(street, width, height)
                       : columnsGraph(street, width, height, frusta);
}

CurvedRayCamera streetCurves(const Street& street, int width, int height, int turns) {
  const PinholeCamera camera(street.view, width, height);
  const Frame frame(street, camera);
  CurvedRayCamera curved(camera);
  for (int i = 0; i < turns; ++i) {
    const double side = i % 2 == 0 ? 1 : -1;
    const double d = 1 + 0.35 * i;
    const double lean = 0.02 * side;
    const double x = 4 * side;
    curved.bend({frame.plane(x, d, -lean, 1), frame.plane(x, d, 0, 1), frame.plane(x, d, lean, 1)},
                frame.point(side > 0 ? -0.3 : 0, 0.1 * (i + 1)));
  }
  return curved;
}

}  // namespace ocelli
