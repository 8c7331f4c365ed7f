#include "oc_core/frustum_editor/editor_drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "oc_core/base/utf8.h"
#include "oc_core/drawing/series_style.h"
#include "oc_core/multiperspective/plan_ground.h"

namespace ocelli {
namespace {

constexpr double kGroundPaleness = 0.6;  // share of white in the ground, so that lines stand out
constexpr double kTextSize = 11;
constexpr double kHandleRadius = 4;
constexpr double kTextLine = 15;
constexpr double kFarPixels = 1e5;  // beyond the pane: what reaches farther is cut there

constexpr Paint kEditorInk = paintOf(page_color::kText);
constexpr Paint kEditorWhite{1, 1, 1};
constexpr Paint kOverlapRed = paintOf(0xd00000);

/// The root has the first colour of figures, the others take turns.
Paint frustumPaint(size_t index) {
  return seriesStyle(index == 0 ? 0 : 1 + (index - 1) % 6).paint;
}

TextLook editorText(const Paint& paint) {
  TextLook look;
  look.size = kTextSize;
  look.paint = paint;
  return look;
}

class PlanPainter {
 public:
  PlanPainter(const FrustumEditor& editor, const PlanWindow& window, const PlanBackdrop* backdrop)
      : editor_(editor), camera_(editor.drawn()), window_(window), backdrop_(backdrop) {}

  Drawing make() {
    const PlotBox pane{0, 0, static_cast<double>(window_.size.x), static_cast<double>(window_.size.y)};
    drawing_.clip(pane);
    if (backdrop_ != nullptr) {
      ground();
      section();
    }
    for (size_t i = 0; i < camera_.frusta.size(); ++i) {
      outlines(i);
    }
    for (const DrawnOverlap& overlap : camera_.overlaps) {
      showOverlap(overlap);
    }
    for (size_t i = 0; i < camera_.frusta.size(); ++i) {
      planes(i);
    }
    handles();
    for (const DrawnOverlap& overlap : camera_.overlaps) {
      showWitness(overlap);
    }
    stroke();
    selectedNumbers();
    scaleBar();
    drawing_.clip(std::nullopt);
    return std::move(drawing_);
  }

 private:
  PlotPoint at(const glm::dvec2& paper) const {
    const glm::dvec2 pixel = glm::clamp(window_.pixelFromPaper(paper), glm::dvec2(-kFarPixels), glm::dvec2(kFarPixels));
    return {pixel.x, pixel.y};
  }
  PlotPoint at(const glm::dvec3& point) const { return at(paperFromWorld(window_.side, point)); }
  bool isSelected(const DrawnFrustum& frustum) const { return frustum.name == editor_.selectedFrustum(); }

  void ground() {
    Pixels pixels{backdrop_->ground.width(), backdrop_->ground.height(), {}};
    for (int y = 0; y < pixels.height; ++y) {
      for (int x = 0; x < pixels.width; ++x) {
        const Rgb8 color = backdrop_->ground(x, y);
        pixels.values.push_back(static_cast<uint32_t>(color[0]) << 16 | static_cast<uint32_t>(color[1]) << 8 |
                                static_cast<uint32_t>(color[2]));
      }
    }
    const PlotPoint lower = at(glm::dvec2(backdrop_->lower));
    const PlotPoint upper = at(glm::dvec2(backdrop_->upper));
    if (!backdrop_->ground.empty()) {
      drawing_.image("ground", {lower.x, lower.y, upper.x, upper.y}, std::move(pixels));
    }
  }

  void section() {
    PathShape lines;
    for (const SectionLine& line : backdrop_->section) {
      lines.lines.push_back({at(glm::dvec2(line[0])), at(glm::dvec2(line[1]))});
    }
    lines.pen = Pen{kEditorInk.faded(0.7), 0.8, {}, true};
    drawing_.path("section", std::move(lines));
  }

  void fill(const char* part, const DrawnVolume& volume, const Paint& paint, double opacity, double penWidth) {
    std::vector<PlotPoint> points;
    for (const glm::dvec2& corner : outlineOf(volume, window_.side)) {
      points.push_back(at(corner));
    }
    if (!points.empty()) {
      drawing_.path(part, {{points}, true, paint.faded(opacity), Pen{paint.faded(0.8), penWidth, {}, true}});
    }
  }

  void outlines(size_t index) {
    const DrawnFrustum& frustum = camera_.frusta[index];
    for (const DrawnVolume& volume : frustum.volumes) {
      fill("frustum", volume, frustumPaint(index), isSelected(frustum) ? 0.28 : 0.13, isSelected(frustum) ? 2 : 1);
    }
  }

  void showOverlap(const DrawnOverlap& overlap) {
    for (const DrawnVolume& volume : overlap.volumes) {
      fill("overlap", volume, kOverlapRed, 0.45, 1.5);
    }
  }

  void showWitness(const DrawnOverlap& overlap) {
    const PlotPoint point = at(overlap.point);
    drawing_.marker("witness", {point, Marker::kCross, 6, std::nullopt, Pen{kOverlapRed, 2.5}});
    label("witness", {point.x + 9, point.y - 6}, overlap.first + " and " + overlap.second, kOverlapRed);
  }

  void planeLine(const char* part, const DrawnPlane& plane, const Paint& paint, bool selected, const Dash& dash) {
    if (const std::optional<std::array<glm::dvec3, 2>> ends = endsOf(plane, window_.side)) {
      drawing_.line(part, at((*ends)[0]), at((*ends)[1]), {paint, selected ? 3.5 : 2.2, dash, true});
    }
  }

  void planes(size_t index) {
    const DrawnFrustum& frustum = camera_.frusta[index];
    const Paint paint = frustumPaint(index);
    if (frustum.turn.empty() && frustum.operation != "root") {
      planeLine("plane", frustum.begins, paint, isSelected(frustum), {});
    }
    for (size_t i = 0; i < frustum.turn.size(); ++i) {
      planeLine("plane", frustum.turn[i], paint, isSelected(frustum), i == 1 ? Dash{} : Dash{5, 3});
    }
    for (const DrawnPlane& limit : frustum.limits) {
      planeLine("limit", limit, paint, isSelected(frustum), {2, 4});
    }
    // Where its rays come from, before they begin.
    if (frustum.operation != "root") {
      if (const std::optional<std::array<glm::dvec3, 2>> ends = endsOf(frustum.begins, window_.side)) {
        for (const glm::dvec3& end : *ends) {
          drawing_.line("ray", at(frustum.viewpoint), at(end),
                        {paint.faded(isSelected(frustum) ? 0.9 : 0.3), 0.8, {3, 3}});
        }
      }
    }
    const glm::dvec3 middle = frustum.operation == "root" ? glm::dvec3(camera_.view.eye) : frustum.begins.middle;
    const PlotPoint name = at(middle);
    label("name", {name.x + 7, name.y - 7}, frustum.name, paint);
  }

  void label(const char* part, const PlotPoint& start, const std::string& text, const Paint& paint) {
    const std::string shown = shortened(cleanText(text), Face::kSans, kTextSize, 180);
    const double width = textWidth(shown, Face::kSans, kTextSize);
    drawing_.box(part, {start.x - 2, start.y - kTextSize, start.x + width + 2, start.y + 3}, kEditorWhite.faded(0.75));
    drawing_.text(part, start, shown, editorText(paint));
  }

  void handles() {
    const std::optional<FrustumHandle> selected = editor_.selectedHandle(window_.side);
    for (const FrustumHandle& handle : handlesOf(camera_, window_.side)) {
      size_t index = 0;
      while (camera_.frusta[index].name != handle.frustum) {
        ++index;
      }
      const bool isIt = selected && handle.isSame(*selected);
      const bool isNear = handle.frustum == editor_.selectedFrustum();
      const Paint paint = frustumPaint(index);
      drawing_.marker(isIt ? "selected handle" : "handle",
                      {at(handle.at), handle.kind->marker, isIt ? kHandleRadius * 1.8 : kHandleRadius,
                       isIt     ? kEditorInk
                       : isNear ? paint
                                : kEditorWhite,
                       Pen{isIt ? kEditorWhite : paint, 1.5}});
    }
  }

  void stroke() {
    const std::optional<PlanStroke> stroke = editor_.stroke();
    if (stroke && stroke->side == window_.side) {
      drawing_.line("stroke", at(stroke->from), at(stroke->to), {kEditorInk, 2, {6, 3}, true});
    }
    if (editor_.snap() && editor_.isDragging()) {
      const PlotPoint point = at(editor_.snap()->at);
      drawing_.marker("snap", {point, Marker::kSquare, 6, std::nullopt, Pen{kEditorInk, 1.5}});
      label("snap", {point.x + 10, point.y + 14}, editor_.snap()->what, kEditorInk);
    }
  }

  void selectedNumbers() {
    const std::optional<FrustumHandle> handle = editor_.selectedHandle(window_.side);
    if (!handle) {
      return;
    }
    const PlotPoint start = at(handle->at);
    double down = start.y + 18;
    label("number", {start.x + 12, down}, handle->frustum + ": " + handle->kind->name, kEditorInk);
    for (const HandleNumber& number : editor_.numbers(window_.side)) {
      down += kTextLine;
      label("number", {start.x + 12, down}, numberText(number), kEditorInk);
    }
  }

  void scaleBar() {
    const double length = gridStep(window_.unitsPerPixel * 8);
    const double right = window_.size.x - 60.0;
    const double down = window_.size.y - 14.0;
    drawing_.line("scale", {right - length / window_.unitsPerPixel, down}, {right, down}, {kEditorInk, 2});
    label("scale", {right + 6, down + 4}, fmt::format("{:g}", length), kEditorInk);
  }

  const FrustumEditor& editor_;
  const DrawnCamera& camera_;
  const PlanWindow& window_;
  const PlanBackdrop* backdrop_;
  Drawing drawing_;
};

}  // namespace

std::string numberText(const HandleNumber& number) {
  const std::string unit = number.unit == "degrees" ? "°" : number.unit == "%" ? " %" : "";
  return fmt::format("{} {:.2f}{}", number.name, number.value, unit);
}

PlanBackdrop planBackdrop(const Mesh& mesh, PlanSide side, const glm::dvec3& eye, int groundPixels) {
  PlanBackdrop backdrop;
  backdrop.side = side;
  const Box box = boundsOf(mesh);
  const glm::vec2 a(paperFromWorld(side, glm::dvec3(box.lower)));
  const glm::vec2 b(paperFromWorld(side, glm::dvec3(box.upper)));
  const glm::vec2 margin(0.02f * std::max(1e-6f, glm::length(b - a)));
  backdrop.lower = glm::min(a, b) - margin;
  backdrop.upper = glm::max(a, b) + margin;
  const float cut = static_cast<float>(planCut(mesh, side, eye));
  backdrop.section = sectionOf(mesh, side, cut);
  backdrop.ground = planGround(mesh, side, backdrop.lower, backdrop.upper, cut, groundPixels);
  for (int y = 0; y < backdrop.ground.height(); ++y) {
    for (int x = 0; x < backdrop.ground.width(); ++x) {
      for (int k = 0; k < 3; ++k) {
        uint8_t& value = backdrop.ground(x, y)[k];
        value = static_cast<uint8_t>(std::lround(255 - (1 - kGroundPaleness) * (255 - value)));
      }
    }
  }
  return backdrop;
}

Drawing planDrawing(const FrustumEditor& editor, const PlanWindow& window, const PlanBackdrop* backdrop) {
  return PlanPainter(editor, window, backdrop).make();
}

Figure editorFigure(const FrustumEditor& editor, const PlanWindow& window, const PlanBackdrop* backdrop) {
  Figure figure;
  figure.title = "A camera that is being drawn";
  figure.description = fmt::format("A plan from the {}: {} frusta, {} overlaps. {}", nameOf(window.side),
                                   editor.drawn().frusta.size(), editor.drawn().overlaps.size(), editor.message());
  const std::vector<std::string> message =
      brokenLines(cleanText(editor.message()), Face::kSans, kTextSize, window.size.x - 16.0);
  figure.width = window.size.x;
  figure.height =
      window.size.y + (editor.message().empty() ? 0 : (static_cast<double>(message.size()) + 1) * kTextLine);
  figure.drawing = planDrawing(editor, window, backdrop);
  double down = window.size.y + 1.2 * kTextLine;
  for (const std::string& line : message) {
    figure.drawing.text("message", {8, down}, line,
                        editorText(editor.drawn().overlaps.empty() ? kEditorInk : kOverlapRed));
    down += kTextLine;
  }
  return figure;
}

}  // namespace ocelli
