#include "analysis/plot/panel.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ocelli {
namespace {

constexpr double kTickLength = 3;
constexpr double kLabelGap = 3;
constexpr double kTitleGap = 5;
constexpr double kMaxLabelShare = 0.42;  // of the width, for the names of categories at the left
constexpr size_t kMaxNameLines = 3;

double labelWidth(const std::string& label) {
  return textWidth(label, Face::kSans, kTextSize);
}

/// Names in lines of at most that width.
std::vector<std::vector<std::string>> namesIn(const std::vector<std::string>& categories, double width) {
  std::vector<std::vector<std::string>> names;
  for (const std::string& category : categories) {
    std::vector<std::string> lines = brokenLines(category, Face::kSans, kTextSize, width);
    if (lines.size() > kMaxNameLines) {
      lines.resize(kMaxNameLines);
      lines.back() = shortened(lines.back() + " \u2026", Face::kSans, kTextSize, width);
    }
    names.push_back(std::move(lines));
  }
  return names;
}

size_t maxLines(const std::vector<std::vector<std::string>>& names) {
  size_t most = 1;
  for (const std::vector<std::string>& name : names) {
    most = std::max(most, name.size());
  }
  return most;
}

/// 0 to n - 1, with half a category around.
AxisRange categoryRange(size_t count) {
  AxisRange range;
  range.low = -0.5;
  range.high = static_cast<double>(count) - 0.5;
  range.roundLow = false;
  range.roundHigh = false;
  range.whole = true;
  return range;
}

}  // namespace

AxisSpec AxisSpec::ofValues(std::string title, const AxisRange& range, bool grid) {
  return {std::move(title), range, {}, grid};
}

AxisSpec AxisSpec::ofCategories(std::string title, std::vector<std::string> categories) {
  return {std::move(title), {}, std::move(categories), false};
}

Panel::Panel(Drawing& drawing, const PlotBox& outer, const AxisSpec& x, const AxisSpec& y) : drawing_(drawing) {
  const bool xNames = !x.categories.empty();
  const bool yNames = !y.categories.empty();
  const double yTitleWidth = y.title.empty() ? 0 : kLineHeight + kTitleGap;
  const double xTitleHeight = x.title.empty() ? 0 : kLineHeight + kTitleGap - 2;

  // The height of the area depends on how x's names break, these on the width, this on y's labels: y's labels, from
  // the height without x's names, are as wide as they will be.
  double labels = 0;
  std::vector<std::vector<std::string>> yLines;
  area_ = {outer.left, outer.top, outer.right, outer.bottom - kTickLength - kLabelGap - kLineHeight - xTitleHeight};
  if (yNames) {
    yLines = namesIn(y.categories, kMaxLabelShare * outer.width() - yTitleWidth);
    for (const std::vector<std::string>& lines : yLines) {
      for (const std::string& line : lines) {
        labels = std::max(labels, labelWidth(line));
      }
    }
  } else {
    const Axis trial(y.range, area_.bottom, area_.top, [](const std::string&) { return kLineHeight; });
    for (const AxisTick& tick : trial.ticks()) {
      labels = std::max(labels, labelWidth(tick.label));
    }
  }
  area_.left = outer.left + yTitleWidth + labels + kLabelGap + kTickLength;
  std::vector<std::vector<std::string>> xLines;
  if (xNames) {
    categoryWidth_ = area_.width() / static_cast<double>(x.categories.size());
    xLines = namesIn(x.categories, categoryWidth_ - 4);
    area_.bottom -= (static_cast<double>(maxLines(xLines)) - 1) * kLineHeight;
    x_.emplace(categoryRange(x.categories.size()), area_.left, area_.right, [](const std::string&) { return 0.0; });
  } else {
    // The last label stands half beyond the area.
    const Axis trial(x.range, area_.left, area_.right, labelWidth);
    if (!trial.ticks().empty()) {
      const AxisTick& last = trial.ticks().back();
      area_.right -= std::max(0.0, trial.at(last.value) + labelWidth(last.label) / 2 - outer.right);
    }
    x_.emplace(x.range, area_.left, area_.right, labelWidth);
  }
  if (yNames) {
    categoryWidth_ = area_.height() / static_cast<double>(y.categories.size());
    y_.emplace(categoryRange(y.categories.size()), area_.top, area_.bottom, [](const std::string&) { return 0.0; });
  } else {
    area_.top += kTextSize / 2;  // the topmost label stands half above
    y_.emplace(y.range, area_.bottom, area_.top, [](const std::string&) { return kLineHeight; });
  }
  drawY(y, yLines, outer.left);
  drawX(x, xLines);
  if (!x.title.empty()) {
    drawing_.text("axis title", {area_.middleX(), outer.bottom - 1},
                  shortened(x.title, Face::kSans, kTextSize, outer.width()),
                  {.paint = kTextPaint, .across = Across::kMiddle, .down = Down::kBottom});
  }
}

void Panel::drawX(const AxisSpec& spec, const std::vector<std::vector<std::string>>& names) {
  const Pen axisPen{kAxisPaint, kThinLine};
  drawing_.line("axis", {area_.left, area_.bottom}, {area_.right, area_.bottom}, axisPen);
  const double labelY = area_.bottom + kTickLength + kLabelGap;
  for (size_t i = 0; i < names.size(); ++i) {
    for (size_t line = 0; line < names[i].size(); ++line) {
      drawing_.text("category", {x(static_cast<double>(i)), labelY + static_cast<double>(line) * kLineHeight},
                    shortened(names[i][line], Face::kSans, kTextSize, std::max(categoryWidth_ - 3, 10.0)),
                    {.paint = kTextPaint, .across = Across::kMiddle, .down = Down::kTop});
    }
  }
  if (!names.empty()) {
    return;
  }
  for (const AxisTick& tick : x_->ticks()) {
    const double at = x(tick.value);
    const bool labelled = !tick.label.empty();
    if (labelled && spec.grid) {
      drawing_.line("grid", {at, area_.top}, {at, area_.bottom}, {kGridPaint, kThinLine});
    }
    drawing_.line("tick", {at, area_.bottom}, {at, area_.bottom + (labelled ? kTickLength : kTickLength / 2)}, axisPen);
    if (labelled) {
      drawing_.text("tick label", {at, labelY}, tick.label,
                    {.paint = kSoftTextPaint, .across = Across::kMiddle, .down = Down::kTop});
    }
  }
}

void Panel::drawY(const AxisSpec& spec, const std::vector<std::vector<std::string>>& names, double titleX) {
  const Pen axisPen{kAxisPaint, kThinLine};
  const double labelX = area_.left - kTickLength - kLabelGap;
  if (!spec.title.empty()) {
    drawing_.text("axis title", {titleX, area_.middleY()},
                  shortened(spec.title, Face::kSans, kTextSize, area_.height() + 24),
                  {.paint = kTextPaint, .across = Across::kMiddle, .down = Down::kTop, .upward = true});
  }
  for (size_t i = 0; i < names.size(); ++i) {
    const double first = y(static_cast<double>(i)) - (static_cast<double>(names[i].size()) - 1) * kLineHeight / 2;
    for (size_t line = 0; line < names[i].size(); ++line) {
      drawing_.text("category", {labelX, first + static_cast<double>(line) * kLineHeight}, names[i][line],
                    {.paint = kTextPaint, .across = Across::kRight, .down = Down::kMiddle});
    }
  }
  if (!names.empty()) {
    return;
  }
  for (const AxisTick& tick : y_->ticks()) {
    const double at = y(tick.value);
    const bool labelled = !tick.label.empty();
    if (labelled && spec.grid) {
      drawing_.line("grid", {area_.left, at}, {area_.right, at}, {kGridPaint, kThinLine});
    }
    drawing_.line("tick", {area_.left - (labelled ? kTickLength : kTickLength / 2), at}, {area_.left, at}, axisPen);
    if (labelled) {
      drawing_.text("tick label", {labelX, at}, tick.label,
                    {.paint = kSoftTextPaint, .across = Across::kRight, .down = Down::kMiddle});
    }
  }
  drawing_.line("axis", {area_.left, area_.top}, {area_.left, area_.bottom}, axisPen);
}

double drawLegend(Drawing& drawing, const PlotBox& row, const std::vector<LegendEntry>& entries) {
  constexpr double kKeyWidth = 20;
  constexpr double kKeyGap = 4;
  constexpr double kBetween = 14;
  constexpr double kRow = 12;
  double left = row.left;
  double middle = row.top + kRow / 2;
  for (const LegendEntry& entry : entries) {
    const double keyWidth = entry.line ? kKeyWidth : 8;
    const std::string name = shortened(entry.name, Face::kSans, kTextSize, row.width() - keyWidth - kKeyGap);
    const double width = keyWidth + kKeyGap + labelWidth(name);
    if (left > row.left && left + width > row.right) {
      left = row.left;
      middle += kRow;
    }
    if (entry.line) {
      drawing.line("legend key", {left, middle}, {left + keyWidth, middle},
                   {entry.style.paint, kThickLine, entry.style.dash});
    }
    if (entry.marker) {
      const Paint fill = entry.filled ? entry.style.paint : kWhite;
      drawing.marker(
          "legend key",
          {{left + keyWidth / 2, middle}, entry.style.marker, entry.radius, fill, Pen{entry.style.paint, kLine}});
    }
    drawing.text("legend", {left + keyWidth + kKeyGap, middle}, name, {.paint = kTextPaint, .down = Down::kMiddle});
    left += width + kBetween;
  }
  return entries.empty() ? 0 : middle + kRow / 2 + 4 - row.top;
}

void drawUprightInterval(Drawing& drawing, const Panel& panel, double x, const Interval& interval,
                         const SeriesStyle& style) {
  if (std::isfinite(interval.lower) && std::isfinite(interval.upper)) {
    for (const auto& [paint, width] : {std::pair{kWhite, kThickLine + 1.4}, std::pair{style.paint, kThickLine}}) {
      drawing.line(width > kThickLine ? "halo" : "interval", {x, panel.y(interval.lower)}, {x, panel.y(interval.upper)},
                   {paint, width});
    }
  }
  if (std::isfinite(interval.value)) {
    drawing.marker("summary",
                   {{x, panel.y(interval.value)}, style.marker, kSummaryRadius, style.paint, Pen{kWhite, kLine}});
  }
}

void drawLevelInterval(Drawing& drawing, const Panel& panel, double y, const Interval& interval,
                       const SeriesStyle& style) {
  if (std::isfinite(interval.lower) && std::isfinite(interval.upper)) {
    for (const auto& [paint, width] : {std::pair{kWhite, kThickLine + 1.4}, std::pair{style.paint, kThickLine}}) {
      drawing.line(width > kThickLine ? "halo" : "interval", {panel.x(interval.lower), y}, {panel.x(interval.upper), y},
                   {paint, width});
    }
  }
  if (std::isfinite(interval.value)) {
    drawing.marker("summary",
                   {{panel.x(interval.value), y}, style.marker, kSummaryRadius, style.paint, Pen{kWhite, kLine}});
  }
}

void drawNote(Drawing& drawing, const PlotBox& box, const std::string& note) {
  const std::vector<std::string> lines = brokenLines(note, Face::kSans, kTextSize, std::max(box.width() - 8, 40.0));
  double y = box.middleY() - (static_cast<double>(lines.size()) - 1) * kLineHeight / 2;
  for (const std::string& line : lines) {
    drawing.text("note", {box.middleX(), y}, line,
                 {.paint = kSoftTextPaint, .across = Across::kMiddle, .down = Down::kMiddle});
    y += kLineHeight;
  }
}

}  // namespace ocelli
