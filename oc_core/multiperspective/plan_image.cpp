#include "oc_core/multiperspective/plan_image.h"

#include <cairo-svg.h>
#include <cairo.h>
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <memory>

#include "oc_core/base/error.h"
#include "oc_core/base/output_file.h"

namespace ocelli {
namespace {

constexpr double kPageMargin = 24;
constexpr double kTitleHeight = 34;
constexpr double kLegendWidth = 300;
constexpr double kLegendLine = 22;
constexpr double kGroundShare = 0.35;  // of the ground's colours; the rest is white, so that lines stand out

using Color = std::array<double, 3>;

/// Told apart by colour-blind people (after Okabe and Ito, 2008), dark enough for lines on white; the root comes first.
const std::array<Color, 7> kColors{{{0.80, 0.25, 0.0},
                                    {0.0, 0.45, 0.70},
                                    {0.0, 0.55, 0.41},
                                    {0.72, 0.38, 0.60},
                                    {0.82, 0.55, 0.0},
                                    {0.20, 0.58, 0.80},
                                    {0.35, 0.35, 0.35}}};

/// The root has its own colour; the others alternate.
const Color& colorOf(size_t part) {
  return part == 0 ? kColors[0] : kColors[1 + (part - 1) % (kColors.size() - 1)];
}

struct DestroySurface {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};
struct DestroyContext {
  void operator()(cairo_t* context) const { cairo_destroy(context); }
};
using Surface = std::unique_ptr<cairo_surface_t, DestroySurface>;
using Context = std::unique_ptr<cairo_t, DestroyContext>;

class Painter {
 public:
  Painter(cairo_t* cairo, const CameraPlan& plan, const ImageOptions& options, double scale)
      : cairo_(cairo), plan_(plan), options_(options), scale_(scale) {
    cairo_select_font_face(cairo_, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_line_join(cairo_, CAIRO_LINE_JOIN_ROUND);
    cairo_set_line_cap(cairo_, CAIRO_LINE_CAP_ROUND);
  }

  void paint() {
    color({1, 1, 1});
    cairo_paint(cairo_);
    const double top = kPageMargin + (options_.title.empty() ? 0 : kTitleHeight);
    if (!options_.title.empty()) {
      color({0.1, 0.1, 0.1});
      text(kPageMargin, kPageMargin + 16, 19, options_.title);
    }
    const glm::dvec2 size = glm::dvec2(plan_.upper - plan_.lower) * scale_;
    cairo_save(cairo_);
    cairo_translate(cairo_, kPageMargin, top);
    cairo_rectangle(cairo_, 0, 0, size.x, size.y);
    cairo_clip(cairo_);
    ground(size);
    section();
    for (size_t i = 0; i < plan_.parts.size(); ++i) {
      outlines(i);
    }
    rays();
    for (size_t i = 0; i < plan_.parts.size(); ++i) {
      viewpoint(i, size);
    }
    cairo_restore(cairo_);
    color({0.55, 0.55, 0.55});
    cairo_set_line_width(cairo_, 1);
    cairo_rectangle(cairo_, kPageMargin, top, size.x, size.y);
    cairo_stroke(cairo_);
    legend(kPageMargin + size.x + kPageMargin, top);
    scaleBar(kPageMargin, top + size.y + 20);
  }

 private:
  void color(const Color& c, double alpha = 1) { cairo_set_source_rgba(cairo_, c[0], c[1], c[2], alpha); }
  glm::dvec2 place(const glm::vec2& p) const { return glm::dvec2(p - plan_.lower) * scale_; }
  void moveTo(const glm::vec2& p) { cairo_move_to(cairo_, place(p).x, place(p).y); }
  void lineTo(const glm::vec2& p) { cairo_line_to(cairo_, place(p).x, place(p).y); }
  void text(double x, double y, double size, const std::string& what) {
    cairo_set_font_size(cairo_, size);
    cairo_move_to(cairo_, x, y);
    cairo_show_text(cairo_, what.c_str());
  }

  void ground(const glm::dvec2& size) {
    if (plan_.ground.empty()) {
      return;
    }
    const Surface image(cairo_image_surface_create(CAIRO_FORMAT_RGB24, plan_.ground.width(), plan_.ground.height()));
    unsigned char* data = cairo_image_surface_get_data(image.get());
    const int stride = cairo_image_surface_get_stride(image.get());
    for (int y = 0; y < plan_.ground.height(); ++y) {
      auto* row = reinterpret_cast<uint32_t*>(data + static_cast<std::ptrdiff_t>(y) * stride);
      for (int x = 0; x < plan_.ground.width(); ++x) {
        uint32_t packed = 0;
        for (int k = 0; k < 3; ++k) {
          packed =
              packed << 8 | static_cast<uint32_t>(255 - kGroundShare * (255 - static_cast<int>(plan_.ground(x, y)[k])));
        }
        row[x] = packed;
      }
    }
    cairo_surface_mark_dirty(image.get());
    cairo_save(cairo_);
    cairo_scale(cairo_, size.x / plan_.ground.width(), size.y / plan_.ground.height());
    cairo_set_source_surface(cairo_, image.get(), 0, 0);
    cairo_paint(cairo_);
    cairo_restore(cairo_);
  }

  void section() {
    for (const SectionLine& line : plan_.section) {
      moveTo(line[0]);
      lineTo(line[1]);
    }
    color({0.15, 0.15, 0.15});
    cairo_set_line_width(cairo_, 1.2);
    cairo_stroke(cairo_);
  }

  void outlines(size_t part) {
    for (const std::vector<glm::vec2>& outline : plan_.parts[part].outlines) {
      moveTo(outline.front());
      for (const glm::vec2& point : outline) {
        lineTo(point);
      }
      cairo_close_path(cairo_);
      color(colorOf(part), 0.13);
      cairo_fill_preserve(cairo_);
      color(colorOf(part), 0.75);
      cairo_set_line_width(cairo_, 1.4);
      cairo_stroke(cairo_);
    }
  }

  void rays() {
    for (const CameraPlan::Ray& ray : plan_.rays) {
      for (const CameraPlan::Ray::Piece& piece : ray.pieces) {
        moveTo(piece.points.front());
        for (const glm::vec2& point : piece.points) {
          lineTo(point);
        }
        color(colorOf(static_cast<size_t>(piece.part)), 0.9);
        cairo_set_line_width(cairo_, 0.9);
        cairo_stroke(cairo_);
      }
      if (ray.meetsSurface && !ray.pieces.empty()) {
        const glm::dvec2 end = place(ray.pieces.back().points.back());
        cairo_arc(cairo_, end.x, end.y, 2.2, 0, 6.2832);
        color({0.1, 0.1, 0.1});
        cairo_fill(cairo_);
      }
    }
  }

  /// A disc with the number of the part, where it lies within the frame.
  void viewpoint(size_t part, const glm::dvec2& size) {
    const glm::dvec2 at = place(plan_.parts[part].viewpoint);
    if (at.x < 0 || at.y < 0 || at.x > size.x || at.y > size.y) {
      return;
    }
    cairo_arc(cairo_, at.x, at.y, part == 0 ? 8 : 6, 0, 6.2832);
    color(colorOf(part));
    cairo_fill_preserve(cairo_);
    color({1, 1, 1});
    cairo_set_line_width(cairo_, 1.5);
    cairo_stroke(cairo_);
  }

  void legend(double x, double y) {
    const size_t shown = std::min(plan_.parts.size(), static_cast<size_t>(options_.maxLegendLines));
    for (size_t i = 0; i < shown; ++i) {
      const double line = y + static_cast<double>(i) * kLegendLine;
      color(colorOf(i));
      cairo_rectangle(cairo_, x, line, 14, 14);
      cairo_fill(cairo_);
      color({0.1, 0.1, 0.1});
      text(x + 22, line + 12, 14, fitting(plan_.parts[i].name));
    }
    if (shown < plan_.parts.size()) {
      color({0.35, 0.35, 0.35});
      text(x, y + static_cast<double>(shown) * kLegendLine + 12, 14,
           fmt::format("and {} more", plan_.parts.size() - shown));
    }
  }

  /// The text, cut where it is wider than the legend.
  std::string fitting(std::string what) {
    cairo_set_font_size(cairo_, 14);
    cairo_text_extents_t extents;
    cairo_text_extents(cairo_, what.c_str(), &extents);
    const bool fits = extents.x_advance <= kLegendWidth - 30;
    while (extents.x_advance > kLegendWidth - 40 && !what.empty() && !fits) {
      // A character of UTF-8 is a first byte and those that go on with it.
      while ((static_cast<unsigned char>(what.back()) & 0xc0) == 0x80) {
        what.pop_back();
      }
      what.pop_back();
      cairo_text_extents(cairo_, what.c_str(), &extents);
    }
    return fits ? what : what + "...";
  }

  /// As long as 1, 2 or 5 times a power of ten, about a fifth of the plan.
  void scaleBar(double x, double y) {
    const double wanted = static_cast<double>(plan_.upper.x - plan_.lower.x) / 5;
    const double power = std::pow(10.0, std::floor(std::log10(wanted)));
    const double length = wanted >= 5 * power ? 5 * power : wanted >= 2 * power ? 2 * power : power;
    color({0.1, 0.1, 0.1});
    cairo_set_line_width(cairo_, 2);
    cairo_move_to(cairo_, x, y);
    cairo_line_to(cairo_, x + length * scale_, y);
    cairo_stroke(cairo_);
    text(x + length * scale_ + 8, y + 5, 14, fmt::format("{:g}", length));
  }

  cairo_t* cairo_;
  const CameraPlan& plan_;
  const ImageOptions& options_;
  double scale_;
};

cairo_status_t append(void* text, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

Image<Rgb8> pixelsOf(cairo_surface_t* surface) {
  cairo_surface_flush(surface);
  Image<Rgb8> image(cairo_image_surface_get_width(surface), cairo_image_surface_get_height(surface));
  const unsigned char* data = cairo_image_surface_get_data(surface);
  for (int y = 0; y < image.height(); ++y) {
    const auto* row = reinterpret_cast<const uint32_t*>(data + static_cast<std::ptrdiff_t>(y) *
                                                                   cairo_image_surface_get_stride(surface));
    for (int x = 0; x < image.width(); ++x) {
      image(x, y) = {static_cast<uint8_t>(row[x] >> 16), static_cast<uint8_t>(row[x] >> 8),
                     static_cast<uint8_t>(row[x])};
    }
  }
  return image;
}

void requireDrawn(cairo_t* cairo) {
  if (cairo_status(cairo) != CAIRO_STATUS_SUCCESS) {
    throw WorkError(std::string("the plan cannot be drawn: ") + cairo_status_to_string(cairo_status(cairo)), "plan",
                    "make it smaller");
  }
}

}  // namespace

void writePlan(const std::filesystem::path& path, const CameraPlan& plan, const ImageOptions& options) {
  const glm::dvec2 frame(plan.upper - plan.lower);
  const double scale = options.planPixels / std::max(frame.x, frame.y);
  const size_t lines = std::min(plan.parts.size(), static_cast<size_t>(options.maxLegendLines) + 1);
  const double width = frame.x * scale + 3 * kPageMargin + kLegendWidth;
  const double height = std::max(frame.y * scale, static_cast<double>(lines) * kLegendLine) + 2 * kPageMargin + 20 +
                        (options.title.empty() ? 0 : kTitleHeight);
  if (path.extension() == ".svg" || (path.extension() != ".png" && isStream(path))) {
    std::string bytes;
    {
      const Surface surface(cairo_svg_surface_create_for_stream(append, &bytes, width, height));
      const Context context(cairo_create(surface.get()));
      Painter(context.get(), plan, options, scale).paint();
      requireDrawn(context.get());
      cairo_surface_finish(surface.get());
    }
    OutputFile file(path);
    file.write(bytes);
    file.commit();
  } else if (path.extension() == ".png") {
    const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(std::ceil(width)),
                                                     static_cast<int>(std::ceil(height))));
    const Context context(cairo_create(surface.get()));
    Painter(context.get(), plan, options, scale).paint();
    requireDrawn(context.get());
    writePng(path, pixelsOf(surface.get()));
  } else {
    throw InputError("a plan is an SVG or a PNG", path.string(), "end its name in .svg or .png");
  }
}

}  // namespace ocelli
