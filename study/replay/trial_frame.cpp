#include "study/replay/trial_frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "oc_core/base/conventions.h"
#include "oc_core/base/error.h"
#include "oc_core/drawing/drawing_error.h"
#include "oc_core/drawing/figure.h"
#include "study/replay/landmark_paint.h"

namespace ocelli {
namespace {

constexpr Paint kLight{1, 1, 1};
constexpr Paint kDark{0.1, 0.1, 0.1};
constexpr Paint kAnswer{0.85, 0.85, 0.85};
constexpr Paint kMarkPaint{0.9, 0.6, 0};  // orange of M. Okabe and K. Ito

uint32_t packed(const Rgb8& pixel) {
  return static_cast<uint32_t>(pixel.x) << 16 | static_cast<uint32_t>(pixel.y) << 8 | pixel.z;
}

TextLook lightText(double size) {
  TextLook look;
  look.size = size;
  look.paint = kLight;
  return look;
}

PlotBox boxAt(const PixelRect& rect) {
  return {rect.left, rect.top, rect.left + rect.width, rect.top + rect.height};
}

class Overlay {
 public:
  Overlay(Drawing& drawing, const TrialLayout& layout, const TrialScreen& screen)
      : drawing_(drawing), layout_(layout), bar_(promptHeight(screen)) {}

  void draw() {
    drawing_.text("prompt", {bar_ * 0.4, bar_ * 0.66}, layout_.prompt, lightText(bar_ * 0.45));
    sought();
    for (const TrialLayout::PathMap& map : layout_.maps) {
      drawMap(map);
    }
    for (const TrialLayout::Choice& choice : layout_.choices) {
      drawChoice(choice);
    }
    if (layout_.scale) {
      drawScale(*layout_.scale);
    }
    if (layout_.dial) {
      drawDial(*layout_.dial);
    }
    pointer();
  }

 private:
  /// The colour of what is sought, beside the prompt.
  void sought() {
    if (!layout_.targetObject || layout_.scene == nullptr) {
      return;
    }
    const double x = boxOf(drawing_.shapes().back()).right;
    const Landmark& object = layout_.scene->maze().landmarks[static_cast<size_t>(*layout_.targetObject)];
    drawing_.marker("sought",
                    {{x + bar_ * 0.6, bar_ * 0.5}, Marker::kCircle, bar_ * 0.28, paintOf(object.color), std::nullopt});
    drawing_.text("sought", {x + bar_ * 1.1, bar_ * 0.66}, nameOf(object.shape), lightText(bar_ * 0.45));
  }

  void drawMap(const TrialLayout::PathMap& map) {
    drawing_.box("map", boxAt(map.place), kLight);
    if (map.corners.empty()) {
      return;
    }
    glm::dvec2 lower = map.corners.front();
    glm::dvec2 upper = lower;
    for (const glm::dvec2& corner : map.corners) {
      lower = glm::min(lower, corner);
      upper = glm::max(upper, corner);
    }
    const double extent = std::max({upper.x - lower.x, upper.y - lower.y, 1e-6});
    const double scale = 0.8 * std::min(map.place.width, map.place.height) / extent;
    std::vector<PlotPoint> path;
    for (const glm::dvec2& corner : map.corners) {
      const glm::dvec2 at = map.place.center() + (corner - (lower + upper) / 2.0) * scale;
      path.push_back({at.x, at.y});
    }
    drawing_.polyline("map", path, {kDark, 4});
    drawing_.marker("map", {path.front(), Marker::kCircle, 7, kDark, std::nullopt});
  }

  void drawChoice(const TrialLayout::Choice& choice) {
    drawing_.box("answer", boxAt(choice.place), std::nullopt, Pen{kAnswer, choice.chosen ? 6.0 : 2.0});
    const double height = std::min(choice.place.height, bar_);
    TextLook look = lightText(height * 0.5);
    look.paint = kAnswer;
    drawing_.text("answer", {choice.place.left + 10, choice.place.top + height * 0.7}, choice.label, look);
  }

  void drawScale(const TrialLayout::Scale& scale) {
    const double middle = scale.place.center().y;
    const double range = scale.most - scale.least;
    const auto upright = [&](double value, double height, const Pen& pen) {
      const double x = scale.place.left + (value - scale.least) / range * scale.place.width;
      drawing_.polyline("scale", {{x, middle - height}, {x, middle + height}}, pen);
      return x;
    };
    drawing_.polyline("scale", {{scale.place.left, middle}, {scale.place.right(), middle}}, {kAnswer, 2});
    const int numbers = static_cast<int>(std::floor(range / scale.step + 1e-9));
    for (int i = 0; i <= numbers; ++i) {
      const double value = scale.least + i * scale.step;
      const double x = upright(value, 6, {kAnswer, 2});
      drawing_.text("scale", {x, middle + bar_ * 0.5}, fmt::format("{:g}", value), lightText(bar_ * 0.3));
    }
    if (scale.mark) {
      upright(*scale.mark, 14, {kMarkPaint, 5});
    }
  }

  void drawDial(const TrialLayout::Dial& dial) {
    const glm::dvec2 center = dial.place.center();
    const auto pointAt = [&](double degrees, double share) {
      const double angle = radiansFromDegrees(degrees);
      const glm::dvec2 at = center + share * dial.place.width / 2 * glm::dvec2(std::sin(angle), -std::cos(angle));
      return PlotPoint{at.x, at.y};
    };
    std::vector<PlotPoint> circle;
    for (int degrees = 0; degrees <= 360; degrees += 5) {
      circle.push_back(pointAt(degrees, 1));
    }
    drawing_.polyline("dial", circle, {kAnswer, 2});
    for (int degrees = 0; degrees < 360; degrees += 15) {
      drawing_.polyline("dial", {pointAt(degrees, degrees % 90 == 0 ? 0.88 : 0.94), pointAt(degrees, 1)}, {kAnswer, 2});
    }
    if (dial.degrees) {
      drawing_.polyline("dial", {pointAt(0, 0), pointAt(*dial.degrees, 1)}, {kMarkPaint, 5});
    }
  }

  void pointer() {
    if (!layout_.pointer) {
      return;
    }
    const double x = layout_.pointer->x;
    const double y = layout_.pointer->y;
    for (const Pen& pen : {Pen{{0, 0, 0}, 5}, Pen{kLight, 2}}) {
      drawing_.path("pointer", {{{{x - 9, y}, {x + 9, y}}, {{x, y - 9}, {x, y + 9}}}, false, std::nullopt, pen});
    }
  }

  Drawing& drawing_;
  const TrialLayout& layout_;
  double bar_;
};

Pixels paintedPixels(const Figure& frame) {
  try {
    return pixelsOf(frame);
  } catch (const DrawingError& error) {
    throw WorkError(error.what(), "frame", "is there enough memory?");
  }
}

}  // namespace

Image<Rgb8> trialFrame(const TrialLayout& layout, const TrialScreen& screen, const StudyRenderer& renderer) {
  Image<Rgb8> image = viewsOf(layout, screen, renderer);
  Figure frame;
  frame.width = screen.width;
  frame.height = screen.height;
  Pixels views{screen.width, screen.height, {}};
  for (int y = 0; y < screen.height; ++y) {
    for (int x = 0; x < screen.width; ++x) {
      views.values.push_back(packed(image(x, y)));
    }
  }
  frame.drawing.image("views", {0, 0, frame.width, frame.height}, std::move(views));
  Overlay(frame.drawing, layout, screen).draw();
  const Pixels drawn = paintedPixels(frame);
  for (int y = 0; y < screen.height; ++y) {
    for (int x = 0; x < screen.width; ++x) {
      const uint32_t pixel = drawn.values[static_cast<size_t>(y) * static_cast<size_t>(screen.width) + x];
      image(x, y) = {static_cast<uint8_t>(pixel >> 16), static_cast<uint8_t>(pixel >> 8), static_cast<uint8_t>(pixel)};
    }
  }
  return image;
}

}  // namespace ocelli
