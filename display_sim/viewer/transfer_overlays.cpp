#include "display_sim/viewer/transfer_overlays.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "display_sim/viewer/gui_pieces.h"
#include "display_sim/viewer/viewer_colors.h"

namespace ocelli {
namespace {

constexpr GuiColor kBarColor{74, 78, 86};
constexpr GuiColor kCurveColor{255, 255, 255};
constexpr GuiColor kCurveCasing{0, 0, 0};
constexpr float kColumnWidth = 2;
constexpr float kStripHeight = 10;
constexpr float kPointRadius = 5.5f;

ImVec2 vec(const glm::dvec2& at) {
  return {static_cast<float>(at.x), static_cast<float>(at.y)};
}

uint32_t packedColor(const glm::dvec3& linear, uint8_t alpha = 255) {
  const glm::vec3 encoded = encodedColor(linear) * 255.0f + 0.5f;
  return GuiColor{static_cast<uint8_t>(encoded.x), static_cast<uint8_t>(encoded.y), static_cast<uint8_t>(encoded.z)}
      .packed(alpha);
}

/// What everything of the plot is drawn with.
struct TransferPlot {
  ImDrawList& list;
  const TransferEditor& editor;
  TransferFrame frame;
  float scale;

  ImVec2 corner() const { return vec(frame.corner); }
  ImVec2 end() const { return vec(frame.corner + frame.size); }
  size_t columns() const { return std::max<size_t>(static_cast<size_t>(frame.size.x / (kColumnWidth * scale)), 1); }
  double columnAt(size_t column) const {
    return frame.corner.x + frame.size.x * static_cast<double>(column) / static_cast<double>(columns());
  }
};

void drawBars(const TransferPlot& plot, const VolumeHistogram& histogram) {
  const std::vector<float> bars = histogramBars(histogram, plot.frame.axis, plot.columns());
  for (size_t i = 0; i < bars.size(); ++i) {
    const auto left = static_cast<float>(plot.columnAt(i));
    const auto right = static_cast<float>(plot.columnAt(i + 1));
    const float top = plot.end().y - bars[i] * static_cast<float>(plot.frame.size.y);
    plot.list.AddRectFilled({left, top}, {right, plot.end().y}, kBarColor.packed());
  }
}

void drawColors(const TransferPlot& plot) {
  const float top = plot.end().y + 3 * plot.scale;
  const float bottom = top + kStripHeight * plot.scale;
  for (size_t i = 0; i < plot.columns(); ++i) {
    const double from = plot.columnAt(i);
    const double to = plot.columnAt(i + 1);
    const double value = plot.frame.valueAt({(from + to) / 2, 0});
    const uint32_t color = packedColor(plot.editor.appearance()->transfer.at(value).color);
    plot.list.AddRectFilled({static_cast<float>(from), top}, {static_cast<float>(to), bottom}, color);
  }
}

void drawValues(const TransferPlot& plot) {
  const float top = plot.end().y + (kStripHeight + 6) * plot.scale;
  const auto room = static_cast<int>(plot.frame.size.x / (90 * static_cast<double>(plot.scale)));
  const double step = tickStep(plot.frame.axis, std::max(room, 1));
  for (double at = std::ceil(plot.frame.axis.least / step) * step; at <= plot.frame.axis.greatest; at += step) {
    const std::string text = fmt::format("{:.6g}", std::abs(at) < step / 2 ? 0.0 : at);
    const float x = vec(plot.frame.placeOf(at, 0)).x;
    const float width = ImGui::CalcTextSize(text.c_str()).x;
    plot.list.AddLine({x, plot.corner().y}, {x, plot.end().y}, kGuiBorder.packed(110));
    plot.list.AddText({x - width / 2, top}, kGuiTextDim.packed(), text.c_str());
  }
}

void drawOpacities(const TransferPlot& plot) {
  const float line = ImGui::GetTextLineHeight();
  for (const double opacity : {0.0, 0.5, 1.0}) {
    const float y = vec(plot.frame.placeOf(plot.frame.axis.least, opacity)).y;
    plot.list.AddLine({plot.corner().x, y}, {plot.end().x, y}, kGuiBorder.packed());
    const std::string text = fmt::format("{:.0f} %", 100 * opacity);
    const float width = ImGui::CalcTextSize(text.c_str()).x;
    plot.list.AddText({plot.corner().x - width - 5 * plot.scale, y - line / 2}, kGuiTextDim.packed(), text.c_str());
  }
}

/// Corners of the opacity, from beyond the left end to beyond the right one.
std::vector<ImVec2> curveOf(const TransferPlot& plot) {
  const std::vector<TransferPoint>& points = plot.editor.points();
  const double margin = plot.frame.axis.width();
  std::vector<ImVec2> curve{
      vec(plot.frame.placeOf(std::min(points.front().value, plot.frame.axis.least) - margin, points.front().opacity))};
  for (const TransferPoint& point : points) {
    curve.push_back(vec(plot.frame.placeOf(point.value, point.opacity)));
  }
  curve.push_back(
      vec(plot.frame.placeOf(std::max(points.back().value, plot.frame.axis.greatest) + margin, points.back().opacity)));
  return curve;
}

void drawCurve(const TransferPlot& plot) {
  const std::vector<ImVec2> curve = curveOf(plot);
  plot.list.PushClipRect({plot.corner().x, plot.corner().y - 2 * plot.scale},
                         {plot.end().x, plot.end().y + 2 * plot.scale}, true);
  const auto count = static_cast<int>(curve.size());
  plot.list.AddPolyline(curve.data(), count, kCurveCasing.packed(), 0, 4 * plot.scale);
  plot.list.AddPolyline(curve.data(), count, kCurveColor.packed(), 0, 1.6f * plot.scale);
  plot.list.PopClipRect();
}

void drawPoints(const TransferPlot& plot) {
  for (size_t i = 0; i < plot.editor.points().size(); ++i) {
    const TransferPoint& point = plot.editor.points()[i];
    const double share = plot.frame.axis.shareOf(point.value);
    if (share < 0 || share > 1) {
      continue;
    }
    const ImVec2 at = vec(plot.frame.placeOf(point.value, point.opacity));
    const bool isChosen = plot.editor.chosen() == i;
    const float radius = (isChosen ? 1.35f : 1.0f) * kPointRadius * plot.scale;
    const float ring = (isChosen ? 3.0f : 1.8f) * plot.scale;
    plot.list.AddCircleFilled(at, radius + ring + 1.2f * plot.scale, kCurveCasing.packed());
    plot.list.AddCircleFilled(at, radius + ring, (isChosen ? kOkabeItoYellow : kCurveColor).packed());
    plot.list.AddCircleFilled(at, radius, packedColor(point.color));
  }
}

}  // namespace

std::vector<float> histogramBars(const VolumeHistogram& histogram, const ValueAxis& axis, size_t columns) {
  std::vector<float> bars(columns);
  const size_t bins = histogram.counts.size();
  const uint64_t greatest = bins > 0 ? *std::ranges::max_element(histogram.counts) : 0;
  if (greatest == 0) {
    return bars;
  }
  const double width = histogram.binWidth();
  const auto binAt = [&](double value) { return (value - histogram.bounds.least) / width; };
  for (size_t i = 0; i < columns; ++i) {
    const double from = binAt(axis.valueAt(static_cast<double>(i) / static_cast<double>(columns)));
    const double to = binAt(axis.valueAt(static_cast<double>(i + 1) / static_cast<double>(columns)));
    const auto first = static_cast<size_t>(std::clamp(std::floor(from), 0.0, static_cast<double>(bins)));
    const auto last = static_cast<size_t>(std::clamp(std::ceil(to), 0.0, static_cast<double>(bins)));
    uint64_t most = 0;
    for (size_t bin = first; bin < last; ++bin) {
      most = std::max(most, histogram.counts[bin]);
    }
    bars[i] = static_cast<float>(std::log1p(static_cast<double>(most)) / std::log1p(static_cast<double>(greatest)));
  }
  return bars;
}

void drawTransferPlot(const PanelDrawing& drawing, const WindowRect& image) {
  const ViewerState& state = drawing.state;
  const auto& scene = drawing.facts.data->scene;
  if (!state.volume.transfer || !scene || !scene->volume) {
    return;
  }
  const TransferPlot plot{*ImGui::GetBackgroundDrawList(), *state.volume.transfer,
                          transferFrame(state, image, drawing.scale), drawing.scale};
  plot.list.PushClipRect({image.x, image.y}, {image.right(), image.bottom()});
  drawBars(plot, scene->volume->histogram);
  drawOpacities(plot);
  drawValues(plot);
  drawColors(plot);
  drawCurve(plot);
  drawPoints(plot);
  plot.list.PopClipRect();
}

std::string transferDetail(const ViewerState& state) {
  if (!state.volume.transfer) {
    return {};
  }
  const TransferEditor& editor = *state.volume.transfer;
  const size_t count = editor.points().size();
  std::string text = fmt::format("{} {}", count, count == 1 ? "point" : "points");
  if (editor.chosen()) {
    const TransferPoint& point = editor.points()[*editor.chosen()];
    text = fmt::format("point {} of {}: value {:.6g}, opacity {:.4g} %", *editor.chosen() + 1, count, point.value,
                       100 * point.opacity);
  }
  return editor.isSaved() ? text : "not saved, " + text;
}

}  // namespace ocelli
