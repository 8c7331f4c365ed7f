#include "study/replay/trial_frame.h"

#include <cairo.h>
#include <fmt/format.h>

#include <algorithm>
#include <glm/common.hpp>
#include <memory>

#include "oc_core/base/color.h"
#include "oc_core/base/error.h"
#include "oc_core/worlds/landmark_solids.h"

namespace ocelli {
namespace {

struct DestroySurface {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};
struct DestroyContext {
  void operator()(cairo_t* context) const { cairo_destroy(context); }
};

uint32_t packed(const Rgb8& pixel) {
  return static_cast<uint32_t>(pixel.x) << 16 | static_cast<uint32_t>(pixel.y) << 8 | pixel.z;
}

class Overlay {
 public:
  Overlay(cairo_t* cairo, const TrialLayout& layout, const TrialScreen& screen)
      : cairo_(cairo), layout_(layout), bar_(promptHeight(screen)) {
    cairo_select_font_face(cairo_, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  }

  void draw() {
    cairo_set_source_rgb(cairo_, 1, 1, 1);
    cairo_set_font_size(cairo_, bar_ * 0.45);
    cairo_move_to(cairo_, bar_ * 0.4, bar_ * 0.66);
    cairo_show_text(cairo_, layout_.prompt.c_str());
    sought();
    for (const TrialLayout::PathMap& map : layout_.maps) {
      drawMap(map);
    }
    for (const TrialLayout::Choice& choice : layout_.choices) {
      drawChoice(choice);
    }
    pointer();
  }

 private:
  /// The colour of what is sought, beside the prompt.
  void sought() {
    if (!layout_.targetObject || layout_.scene == nullptr) {
      return;
    }
    double x = 0;
    double y = 0;
    cairo_get_current_point(cairo_, &x, &y);
    const Landmark& object = layout_.scene->maze().landmarks[static_cast<size_t>(*layout_.targetObject)];
    const glm::vec3 linear = colorOf(object.color);
    cairo_new_path(cairo_);
    cairo_arc(cairo_, x + bar_ * 0.6, bar_ * 0.5, bar_ * 0.28, 0, 6.2832);
    cairo_set_source_rgb(cairo_, static_cast<double>(srgbFromLinear(linear.x)),
                         static_cast<double>(srgbFromLinear(linear.y)), static_cast<double>(srgbFromLinear(linear.z)));
    cairo_fill(cairo_);
    cairo_set_source_rgb(cairo_, 1, 1, 1);
    cairo_move_to(cairo_, x + bar_ * 1.1, bar_ * 0.66);
    cairo_show_text(cairo_, nameOf(object.shape));
  }

  void drawMap(const TrialLayout::PathMap& map) {
    cairo_rectangle(cairo_, map.place.left, map.place.top, map.place.width, map.place.height);
    cairo_set_source_rgb(cairo_, 1, 1, 1);
    cairo_fill(cairo_);
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
    const auto on = [&](const glm::dvec2& corner) {
      return map.place.center() + (corner - (lower + upper) / 2.0) * scale;
    };
    for (const glm::dvec2& corner : map.corners) {
      cairo_line_to(cairo_, on(corner).x, on(corner).y);
    }
    cairo_set_source_rgb(cairo_, 0.1, 0.1, 0.1);
    cairo_set_line_width(cairo_, 4);
    cairo_stroke(cairo_);
    cairo_arc(cairo_, on(map.corners.front()).x, on(map.corners.front()).y, 7, 0, 6.2832);
    cairo_fill(cairo_);
  }

  void drawChoice(const TrialLayout::Choice& choice) {
    cairo_rectangle(cairo_, choice.place.left, choice.place.top, choice.place.width, choice.place.height);
    cairo_set_source_rgb(cairo_, 0.85, 0.85, 0.85);
    cairo_set_line_width(cairo_, choice.chosen ? 6 : 2);
    cairo_stroke(cairo_);
    cairo_set_font_size(cairo_, std::min(choice.place.height, bar_) * 0.5);
    cairo_move_to(cairo_, choice.place.left + 10, choice.place.top + std::min(choice.place.height, bar_) * 0.7);
    cairo_show_text(cairo_, choice.label.c_str());
  }

  void pointer() {
    if (!layout_.pointer) {
      return;
    }
    for (const double width : {5.0, 2.0}) {
      const double shade = width > 3 ? 0 : 1;
      cairo_set_source_rgb(cairo_, shade, shade, shade);
      cairo_set_line_width(cairo_, width);
      cairo_move_to(cairo_, layout_.pointer->x - 9, layout_.pointer->y);
      cairo_line_to(cairo_, layout_.pointer->x + 9, layout_.pointer->y);
      cairo_move_to(cairo_, layout_.pointer->x, layout_.pointer->y - 9);
      cairo_line_to(cairo_, layout_.pointer->x, layout_.pointer->y + 9);
      cairo_stroke(cairo_);
    }
  }

  cairo_t* cairo_;
  const TrialLayout& layout_;
  double bar_;
};

}  // namespace

Image<Rgb8> trialFrame(const TrialLayout& layout, const TrialScreen& screen, const StudyRenderer& renderer) {
  Image<Rgb8> pixels = viewsOf(layout, screen, renderer);
  const std::unique_ptr<cairo_surface_t, DestroySurface> surface(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, screen.width, screen.height));
  const std::unique_ptr<cairo_t, DestroyContext> context(cairo_create(surface.get()));
  if (cairo_status(context.get()) != CAIRO_STATUS_SUCCESS) {
    throw WorkError(fmt::format("a frame cannot be drawn: {}", cairo_status_to_string(cairo_status(context.get()))),
                    "frame", "is there enough memory?");
  }
  unsigned char* data = cairo_image_surface_get_data(surface.get());
  const auto stride = static_cast<size_t>(cairo_image_surface_get_stride(surface.get()));
  const auto row = [&](int y) { return reinterpret_cast<uint32_t*>(data + static_cast<size_t>(y) * stride); };
  for (int y = 0; y < screen.height; ++y) {
    for (int x = 0; x < screen.width; ++x) {
      row(y)[x] = packed(pixels(x, y));
    }
  }
  cairo_surface_mark_dirty(surface.get());
  Overlay(context.get(), layout, screen).draw();
  cairo_surface_flush(surface.get());
  for (int y = 0; y < screen.height; ++y) {
    for (int x = 0; x < screen.width; ++x) {
      const uint32_t pixel = row(y)[x];
      pixels(x, y) = {static_cast<uint8_t>(pixel >> 16), static_cast<uint8_t>(pixel >> 8), static_cast<uint8_t>(pixel)};
    }
  }
  return pixels;
}

}  // namespace ocelli
