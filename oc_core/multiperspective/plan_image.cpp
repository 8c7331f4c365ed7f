#include "oc_core/multiperspective/plan_image.h"

#include <fmt/format.h>

#include <cmath>
#include <glm/common.hpp>

#include "oc_core/base/utf8.h"
#include "oc_core/drawing/series_style.h"
#include "oc_core/multiperspective/figure_file.h"

namespace ocelli {
namespace {

constexpr double kPageMargin = 24;
constexpr double kTitleHeight = 34;
constexpr double kLegendWidth = 300;
constexpr double kLegendLine = 22;
constexpr double kLegendText = 14;
constexpr double kGroundShare = 0.35;  // of the ground's colours; the rest is white, so that lines stand out

constexpr Paint kPlanInk = paintOf(page_color::kText);
constexpr Paint kPlanWhite{1, 1, 1};

/// The root has its own colour; the others alternate.
Paint partPaint(size_t part) {
  return seriesStyle(part == 0 ? 0 : 1 + (part - 1) % 6).paint;
}

Pen planPen(const Paint& paint, double width) {
  return {paint, width, {}, true};
}

class PlanDrawing {
 public:
  PlanDrawing(const CameraPlan& plan, const ImageOptions& options)
      : plan_(plan),
        options_(options),
        scale_(options.planPixels / static_cast<double>(std::max(frame().x, frame().y))),
        top_(kPageMargin + (options.title.empty() ? 0 : kTitleHeight)),
        size_(frame() * scale_) {}

  Figure figure() {
    const size_t lines = std::min(plan_.parts.size(), static_cast<size_t>(options_.maxLegendLines) + 1);
    Figure figure;
    figure.title = options_.title.empty() ? "Plan of a camera" : options_.title;
    figure.description =
        fmt::format("{} frusta and {} rays over a section of the scene.", plan_.parts.size(), plan_.rays.size());
    figure.width = size_.x + 3 * kPageMargin + kLegendWidth;
    figure.height = std::max(size_.y, static_cast<double>(lines) * kLegendLine) + kPageMargin + 20 + top_;
    if (!options_.title.empty()) {
      drawing_.text("title", {kPageMargin, kPageMargin + 16}, options_.title, look(19));
    }
    const PlotBox box{kPageMargin, top_, kPageMargin + size_.x, top_ + size_.y};
    drawing_.clip(box);
    ground(box);
    section();
    for (size_t i = 0; i < plan_.parts.size(); ++i) {
      outlines(i);
    }
    rays();
    for (size_t i = 0; i < plan_.parts.size(); ++i) {
      viewpoint(i, box);
    }
    drawing_.clip(std::nullopt);
    drawing_.box("frame", box, std::nullopt, Pen{paintOf(page_color::kSoft), 1});
    legend(box.right + kPageMargin, box.top);
    scaleBar(box.left, box.bottom + 20);
    figure.drawing = std::move(drawing_);
    return figure;
  }

 private:
  glm::dvec2 frame() const { return glm::dvec2(plan_.upper - plan_.lower); }
  PlotPoint pointOf(const glm::vec2& p) const {
    const glm::dvec2 at = glm::dvec2(p - plan_.lower) * scale_;
    return {kPageMargin + at.x, top_ + at.y};
  }
  std::vector<PlotPoint> pointsOf(const std::vector<glm::vec2>& points) const {
    std::vector<PlotPoint> drawn;
    for (const glm::vec2& point : points) {
      drawn.push_back(pointOf(point));
    }
    return drawn;
  }
  static TextLook look(double size, const Paint& paint = kPlanInk) {
    TextLook look;
    look.size = size;
    look.paint = paint;
    return look;
  }

  void ground(const PlotBox& box) {
    Pixels pixels{plan_.ground.width(), plan_.ground.height(), {}};
    for (int y = 0; y < pixels.height; ++y) {
      for (int x = 0; x < pixels.width; ++x) {
        uint32_t packed = 0;
        for (int k = 0; k < 3; ++k) {
          packed =
              packed << 8 | static_cast<uint32_t>(255 - kGroundShare * (255 - static_cast<int>(plan_.ground(x, y)[k])));
        }
        pixels.values.push_back(packed);
      }
    }
    if (!plan_.ground.empty()) {
      drawing_.image("ground", box, std::move(pixels));
    }
  }

  void section() {
    PathShape lines;
    for (const SectionLine& line : plan_.section) {
      lines.lines.push_back({pointOf(line[0]), pointOf(line[1])});
    }
    lines.pen = planPen(kPlanInk, 1.2);
    drawing_.path("section", std::move(lines));
  }

  void outlines(size_t part) {
    for (const std::vector<glm::vec2>& outline : plan_.parts[part].outlines) {
      drawing_.path(
          "frustum",
          {{pointsOf(outline)}, true, partPaint(part).faded(0.13), planPen(partPaint(part).faded(0.75), 1.4)});
    }
  }

  void rays() {
    for (const CameraPlan::Ray& ray : plan_.rays) {
      for (const CameraPlan::Ray::Piece& piece : ray.pieces) {
        drawing_.polyline("ray", pointsOf(piece.points),
                          planPen(partPaint(static_cast<size_t>(piece.part)).faded(0.9), 0.9));
      }
      if (ray.meetsSurface && !ray.pieces.empty()) {
        drawing_.marker("hit",
                        {pointOf(ray.pieces.back().points.back()), Marker::kCircle, 2.2, kPlanInk, std::nullopt});
      }
    }
  }

  /// A disc in the colour of the part, where it lies within the frame.
  void viewpoint(size_t part, const PlotBox& box) {
    const PlotPoint at = pointOf(plan_.parts[part].viewpoint);
    if (box.contains({at.x, at.y, at.x, at.y})) {
      drawing_.marker("viewpoint", {at, Marker::kCircle, part == 0 ? 8.0 : 6.0, partPaint(part), Pen{kPlanWhite, 1.5}});
    }
  }

  void legend(double x, double y) {
    const size_t shown = std::min(plan_.parts.size(), static_cast<size_t>(options_.maxLegendLines));
    for (size_t i = 0; i < shown; ++i) {
      const double line = y + static_cast<double>(i) * kLegendLine;
      drawing_.box("legend", {x, line, x + 14, line + 14}, partPaint(i));
      drawing_.text("legend", {x + 22, line + 12},
                    shortened(cleanText(plan_.parts[i].name), Face::kSans, kLegendText, kLegendWidth - 30),
                    look(kLegendText));
    }
    if (shown < plan_.parts.size()) {
      drawing_.text("legend", {x, y + static_cast<double>(shown) * kLegendLine + 12},
                    fmt::format("and {} more", plan_.parts.size() - shown),
                    look(kLegendText, paintOf(page_color::kSoft)));
    }
  }

  /// As long as 1, 2 or 5 times a power of ten, about a fifth of the plan.
  void scaleBar(double x, double y) {
    const double wanted = frame().x / 5;
    const double power = std::pow(10.0, std::floor(std::log10(wanted)));
    const double length = wanted >= 5 * power ? 5 * power : wanted >= 2 * power ? 2 * power : power;
    drawing_.line("scale", {x, y}, {x + length * scale_, y}, planPen(kPlanInk, 2));
    drawing_.text("scale", {x + length * scale_ + 8, y + 5}, fmt::format("{:g}", length), look(kLegendText));
  }

  const CameraPlan& plan_;
  const ImageOptions& options_;
  double scale_;  ///< points a unit of the world
  double top_;    ///< of the plan
  glm::dvec2 size_;
  Drawing drawing_;
};

}  // namespace

Figure planFigure(const CameraPlan& plan, const ImageOptions& options) {
  return PlanDrawing(plan, options).figure();
}

void writePlan(const std::filesystem::path& path, const CameraPlan& plan, const ImageOptions& options) {
  requireFigureFile(path);
  writeFigure(path, planFigure(plan, options));
}

}  // namespace ocelli
