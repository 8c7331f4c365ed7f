#include "analysis/plot/flow_diagram.h"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/plot/axis.h"
#include "analysis/plot/chart_text.h"

namespace ocelli {
namespace {

constexpr double kPadding = 6;
constexpr double kStep = 22;  // between boxes
constexpr double kFlowArrow = 4;
constexpr double kMaxMainWidth = 210;

struct Line {
  std::string text;
  Face face = Face::kSans;
};

double heightOf(const std::vector<Line>& lines) {
  return 2 * kPadding + kLineHeight * static_cast<double>(lines.size());
}

std::string numberOf(size_t count) {
  return numberText(static_cast<double>(count), 0);
}

std::vector<Line> linesOf(const FlowDiagram::Stage& stage, double width) {
  std::vector<Line> lines;
  for (const std::string& line : brokenLines(stage.label, Face::kSansBold, kTextSize, width - 2 * kPadding)) {
    lines.push_back({line, Face::kSansBold});
  }
  lines.push_back({fmt::format("{} {}", numberOf(stage.count), stage.unit)});
  return lines;
}

std::vector<Line> linesOf(const std::vector<FlowDiagram::Loss>& lost, double width) {
  size_t all = 0;
  for (const FlowDiagram::Loss& loss : lost) {
    all += loss.count;
  }
  std::vector<Line> lines{{fmt::format("Not continued: {}", numberOf(all)), Face::kSansBold}};
  for (const FlowDiagram::Loss& loss : lost) {
    const std::string text = fmt::format("{}  {}", numberOf(loss.count), loss.reason);
    for (const std::string& line : brokenLines(text, Face::kSans, kTextSize, width - 2 * kPadding)) {
      lines.push_back({line});
    }
  }
  return lines;
}

void drawBox(Drawing& drawing, const std::string& part, const PlotBox& box, const std::vector<Line>& lines,
             bool centred) {
  drawing.box(part, box, part == "stage" ? paintOf(page_color::kTint) : kWhite, Pen{kAxisPaint, kThinLine});
  double y = box.top + kPadding + kLineHeight / 2;
  for (const Line& line : lines) {
    drawing.text(fmt::format("{} text", part), {centred ? box.middleX() : box.left + kPadding, y}, line.text,
                 {.face = line.face,
                  .paint = kTextPaint,
                  .across = centred ? Across::kMiddle : Across::kLeft,
                  .down = Down::kMiddle});
    y += kLineHeight;
  }
}

void drawArrow(Drawing& drawing, PlotPoint from, PlotPoint to) {
  drawing.line("arrow", from, to, {kAxisPaint, kLine});
  const bool down = to.y > from.y;
  const PlotPoint one = down ? PlotPoint{to.x - 0.7 * kFlowArrow, to.y - kFlowArrow}
                             : PlotPoint{to.x - kFlowArrow, to.y - 0.7 * kFlowArrow};
  const PlotPoint other = down ? PlotPoint{to.x + 0.7 * kFlowArrow, to.y - kFlowArrow}
                               : PlotPoint{to.x - kFlowArrow, to.y + 0.7 * kFlowArrow};
  drawing.path("arrow head", {{{to, one, other}}, true, kAxisPaint, std::nullopt});
}

}  // namespace

Figure flowFigure(const FlowDiagram& diagram) {
  if (diagram.stages.empty()) {
    return emptyFigure(diagram.title, diagram.widthMillimetres, "no subject is in the study");
  }
  Figure figure{diagram.title,
                "The way of the subjects through the study.",
                diagram.widthMillimetres * kPointsPerMillimetre,
                0,
                {}};
  Drawing& drawing = figure.drawing;
  const double mainWidth = std::min(kMaxMainWidth, 0.44 * figure.width);
  const double sideLeft = mainWidth + 28;
  const double sideWidth = figure.width - sideLeft - 1;
  const double middle = 1 + mainWidth / 2;
  double top = 1;
  for (size_t i = 0; i < diagram.stages.size(); ++i) {
    const FlowDiagram::Stage& stage = diagram.stages[i];
    const std::vector<Line> lines = linesOf(stage, mainWidth);
    const PlotBox box{1, top, 1 + mainWidth, top + heightOf(lines)};
    drawBox(drawing, "stage", box, lines, true);
    figure.description += fmt::format(" {}: {} {}.", stage.label, stage.count, stage.unit);
    top = box.bottom;
    if (!stage.lost.empty()) {
      const std::vector<Line> lost = linesOf(stage.lost, sideWidth);
      const PlotBox side{sideLeft, top + kStep / 2, sideLeft + sideWidth, top + kStep / 2 + heightOf(lost)};
      drawBox(drawing, "loss", side, lost, false);
      drawArrow(drawing, {middle, side.middleY()}, {side.left, side.middleY()});
      for (const FlowDiagram::Loss& loss : stage.lost) {
        figure.description += fmt::format(" Not continued: {}, {}.", loss.count, loss.reason);
      }
      top = side.bottom - kStep / 2;
    }
    if (i + 1 < diagram.stages.size()) {
      drawArrow(drawing, {middle, box.bottom}, {middle, top + kStep});
      top += kStep;
    } else if (!stage.lost.empty()) {
      drawing.line("arrow", {middle, box.bottom}, {middle, box.bottom + kStep / 2 + (top - box.bottom) / 2},
                   {kAxisPaint, kLine});
      top += kStep / 2;
    }
  }
  figure.height = top + 1;
  return figure;
}

}  // namespace ocelli
