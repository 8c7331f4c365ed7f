#include "oc_core/drawing/cairo_painter.h"

#include <cairo.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "oc_core/drawing/drawing_error.h"

namespace ocelli {
namespace {

void setPaint(cairo_t* context, const Paint& paint) {
  cairo_set_source_rgba(context, paint.red, paint.green, paint.blue, paint.opacity);
}

uint32_t* rowOf(cairo_surface_t* surface, int y) {
  const auto stride = static_cast<std::ptrdiff_t>(cairo_image_surface_get_stride(surface));
  return reinterpret_cast<uint32_t*>(cairo_image_surface_get_data(surface) + y * stride);
}

CairoSurface surfaceOf(const Pixels& pixels) {
  CairoSurface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, pixels.width, pixels.height));
  checkCairo(cairo_surface_status(surface.get()));
  for (int y = 0; y < pixels.height; ++y) {
    const auto first = pixels.values.begin() + static_cast<std::ptrdiff_t>(y) * pixels.width;
    std::copy(first, first + pixels.width, rowOf(surface.get(), y));
  }
  cairo_surface_mark_dirty(surface.get());
  return surface;
}

/// The path that stands is filled, stroked and gone.
void finishPath(cairo_t* context, const std::optional<Paint>& fill, const std::optional<Pen>& pen) {
  if (fill) {
    setPaint(context, *fill);
    cairo_fill_preserve(context);
  }
  if (pen) {
    setPaint(context, pen->paint);
    cairo_set_line_width(context, pen->width);
    cairo_set_line_cap(context, pen->roundEnds ? CAIRO_LINE_CAP_ROUND : CAIRO_LINE_CAP_BUTT);
    cairo_set_dash(context, pen->dash.data(), static_cast<int>(pen->dash.size()), 0);
    cairo_stroke_preserve(context);
  }
  cairo_new_path(context);
}

void paint(cairo_t* context, const PathShape& shape) {
  for (const std::vector<PlotPoint>& line : shape.lines) {
    cairo_new_sub_path(context);
    for (const PlotPoint& point : line) {
      cairo_line_to(context, point.x, point.y);
    }
    if (shape.closed) {
      cairo_close_path(context);
    }
  }
  finishPath(context, shape.fill, shape.pen);
}

void paint(cairo_t* context, const MarkerShape& shape) {
  const std::vector<PlotPoint> corners = markerCorners(shape.marker);
  const bool strokes = shape.marker == Marker::kPlus || shape.marker == Marker::kCross;
  if (corners.empty()) {
    cairo_arc(context, shape.at.x, shape.at.y, shape.radius, 0, 2 * std::numbers::pi);
  }
  for (size_t i = 0; i < corners.size(); ++i) {
    const double x = shape.at.x + shape.radius * corners[i].x;
    const double y = shape.at.y + shape.radius * corners[i].y;
    if (strokes && i % 2 == 0) {
      cairo_move_to(context, x, y);
    } else {
      cairo_line_to(context, x, y);
    }
  }
  if (!strokes) {
    cairo_close_path(context);
    finishPath(context, shape.fill, shape.pen);
  } else {
    // Strokes have no inside: they take the colour of what would fill them.
    const Pen own{shape.fill.value_or(Paint{}), 0.4 * shape.radius};
    finishPath(context, std::nullopt, shape.pen ? *shape.pen : own);
  }
}

void paint(cairo_t* context, const TextShape& shape) {
  setPaint(context, shape.paint);
  cairo_save(context);
  cairo_translate(context, shape.start.x, shape.start.y);
  if (shape.upward) {
    cairo_rotate(context, -std::numbers::pi / 2);
  }
  cairo_set_font_size(context, shape.size);
  double x = 0;
  for (const TextRun& run : textRuns(shape.text, shape.face, shape.size)) {
    cairo_select_font_face(context, run.substitute ? kSubstituteFamily : familyOf(shape.face),
                           isItalic(shape.face) && !run.substitute ? CAIRO_FONT_SLANT_ITALIC : CAIRO_FONT_SLANT_NORMAL,
                           isBold(shape.face) ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_move_to(context, x, 0);
    cairo_show_text(context, run.text.c_str());
    x += run.width;
  }
  cairo_restore(context);
  cairo_new_path(context);  // text leaves a point behind
}

void paint(cairo_t* context, const ImageShape& shape) {
  if (shape.pixels.values.empty()) {
    return;
  }
  const CairoSurface image = surfaceOf(shape.pixels);
  cairo_save(context);
  cairo_translate(context, shape.box.left, shape.box.top);
  cairo_scale(context, shape.box.width() / shape.pixels.width, shape.box.height() / shape.pixels.height);
  cairo_set_source_surface(context, image.get(), 0, 0);
  cairo_paint(context);
  cairo_restore(context);
}

void paint(cairo_t* context, const ClipShape& shape) {
  cairo_reset_clip(context);
  if (shape.box) {
    cairo_rectangle(context, shape.box->left, shape.box->top, shape.box->width(), shape.box->height());
    cairo_clip(context);
  }
}

}  // namespace

DrawingError::DrawingError(const std::string& what)
    : std::runtime_error(fmt::format("a drawing cannot be painted: {}", what)) {}

void DestroyCairo::operator()(_cairo* context) const {
  cairo_destroy(context);
}

void DestroyCairo::operator()(_cairo_surface* surface) const {
  cairo_surface_destroy(surface);
}

void paintDrawing(_cairo* context, const Drawing& drawing) {
  cairo_font_options_t* options = cairo_font_options_create();
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
  cairo_set_font_options(context, options);
  cairo_font_options_destroy(options);
  cairo_set_line_join(context, CAIRO_LINE_JOIN_ROUND);
  cairo_set_line_cap(context, CAIRO_LINE_CAP_BUTT);
  for (const Shape& shape : drawing.shapes()) {
    std::visit([&](const auto& what) { paint(context, what); }, shape.what);
  }
}

void appendBytes(void* closure, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(closure)->append(reinterpret_cast<const char*>(data), length);
}

void checkCairo(int status) {
  if (status != CAIRO_STATUS_SUCCESS) {
    throw DrawingError(cairo_status_to_string(static_cast<cairo_status_t>(status)));
  }
}

CairoSurface paintedSurface(const Drawing& drawing, double width, double height, double scale) {
  CairoSurface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(std::ceil(width * scale)),
                                                  static_cast<int>(std::ceil(height * scale))));
  const CairoContext context(cairo_create(surface.get()));
  cairo_set_source_rgb(context.get(), 1, 1, 1);
  cairo_paint(context.get());
  cairo_scale(context.get(), scale, scale);
  paintDrawing(context.get(), drawing);
  checkCairo(cairo_status(context.get()));
  return surface;
}

Pixels pixelsOf(_cairo_surface* surface) {
  cairo_surface_flush(surface);
  Pixels pixels{cairo_image_surface_get_width(surface), cairo_image_surface_get_height(surface), {}};
  for (int y = 0; y < pixels.height; ++y) {
    const uint32_t* row = rowOf(surface, y);
    std::transform(row, row + pixels.width, std::back_inserter(pixels.values),
                   [](uint32_t pixel) { return pixel & 0xffffffU; });
  }
  return pixels;
}

std::string bytesOfSurface(const std::function<_cairo_surface*(void* closure)>& makeSurface,
                           const std::function<void(_cairo_surface*, _cairo*)>& work) {
  std::string bytes;
  const CairoSurface surface(makeSurface(&bytes));
  checkCairo(cairo_surface_status(surface.get()));
  const CairoContext context(cairo_create(surface.get()));
  work(surface.get(), context.get());
  checkCairo(cairo_status(context.get()));
  cairo_surface_finish(surface.get());
  checkCairo(cairo_surface_status(surface.get()));
  return bytes;
}

}  // namespace ocelli
