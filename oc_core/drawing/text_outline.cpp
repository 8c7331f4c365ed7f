#include "oc_core/drawing/text_outline.h"

#include <cairo.h>

#include <algorithm>
#include <utility>

#include "oc_core/base/utf8.h"
#include "oc_core/drawing/cairo_painter.h"

namespace ocelli {
namespace {

/// Outlines are taken at this size, where Cairo's fixed numbers (1/256) are fine enough.
constexpr double kOutlineSize = 1000;
constexpr double kCurveTolerance = 3;

class OutlineContext {
 public:
  OutlineContext()
      : surface_(cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1)), context_(cairo_create(surface_.get())) {
    cairo_font_options_t* options = cairo_font_options_create();
    cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
    cairo_set_font_options(context_.get(), options);
    cairo_font_options_destroy(options);
    cairo_set_tolerance(context_.get(), kCurveTolerance);
    checkCairo(cairo_status(context_.get()));
  }

  void select(Face face, bool isSubstitute) {
    cairo_select_font_face(context_.get(), isSubstitute ? kSubstituteFamily : familyOf(face),
                           isItalic(face) && !isSubstitute ? CAIRO_FONT_SLANT_ITALIC : CAIRO_FONT_SLANT_NORMAL,
                           isBold(face) ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(context_.get(), kOutlineSize);
  }

  /// At `x`, at size 1.
  GlyphOutline outlineOf(char32_t code, double x) {
    cairo_new_path(context_.get());
    cairo_move_to(context_.get(), 0, 0);
    cairo_text_path(context_.get(), utf8FromCodePoint(code).c_str());
    cairo_path_t* path = cairo_copy_path_flat(context_.get());
    GlyphOutline outline;
    bool isOpen = false;
    for (int i = 0; i < path->num_data; i += path->data[i].header.length) {
      const cairo_path_data_t* data = path->data + i;
      if (data->header.type == CAIRO_PATH_CLOSE_PATH) {
        isOpen = false;
        continue;
      }
      if (data->header.type == CAIRO_PATH_MOVE_TO || !isOpen) {
        outline.emplace_back();
        isOpen = true;
      }
      outline.back().push_back({x + data[1].point.x / kOutlineSize, -data[1].point.y / kOutlineSize});
    }
    const cairo_status_t status = path->status;
    cairo_path_destroy(path);
    checkCairo(status);
    std::erase_if(outline, [](const std::vector<PlotPoint>& corners) { return corners.size() < 3; });
    return outline;
  }

 private:
  CairoSurface surface_;
  CairoContext context_;
};

}  // namespace

std::vector<GlyphOutline> textOutlines(std::string_view text, Face face) {
  OutlineContext context;
  std::vector<GlyphOutline> glyphs;
  double x = 0;
  for (const TextRun& run : textRuns(text, face, 1)) {
    context.select(face, run.substitute);
    for (const char32_t code : codePoints(run.text)) {
      if (GlyphOutline outline = context.outlineOf(code, x); !outline.empty()) {
        glyphs.push_back(std::move(outline));
      }
      x += textWidth(utf8FromCodePoint(code), face, 1);
    }
  }
  return glyphs;
}

double capitalHeight(Face face) {
  double height = 0;
  for (const GlyphOutline& glyph : textOutlines("H", face)) {
    for (const std::vector<PlotPoint>& corners : glyph) {
      for (const PlotPoint& corner : corners) {
        height = std::max(height, corner.y);
      }
    }
  }
  return height;
}

}  // namespace ocelli
