#include "analysis/plot/group_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/plot/chart_text.h"
#include "analysis/plot/swarm.h"

namespace ocelli {
namespace {

constexpr double kSeriesHeight = 15;  // of a series in a row, points
constexpr double kGroupShare = 0.84;  // of a condition's width, for its series
constexpr double kDefaultHeight = 170;

bool hasValues(const GroupValues& values, AxisScale scale) {
  return isDrawable(values.summary.value, scale) ||
         std::any_of(values.raw.begin(), values.raw.end(), [&](double value) { return isDrawable(value, scale); });
}

/// Of a group. All together are not to make a file of many megabytes.
size_t maxPoints(const GroupPlot& plot) {
  constexpr size_t kMaxOfAll = 8000;
  const size_t groups = std::max<size_t>(plot.series.size() * plot.conditions.size(), 1);
  return std::clamp<size_t>(kMaxOfAll / groups, 100, kMaxPoints);
}

/// The ends of intervals that lie near the values. Those of two or three subjects may go from 1e-30 to 1e30 on a
/// logarithmic axis, where no value could be told from the next: they are drawn to the ends of the axis.
std::vector<double> nearEnds(const GroupPlot& plot, const std::vector<double>& values) {
  constexpr double kFarthestFactor = 1000;
  const AxisRange near = AxisRange::of(values, plot.scale);
  std::vector<double> ends;
  for (const GroupSeries& series : plot.series) {
    for (const GroupValues& group : series.groups) {
      for (const double end : {group.summary.lower, group.summary.upper}) {
        ends.push_back(plot.scale == AxisScale::kLog
                           ? std::clamp(end, near.low / kFarthestFactor, near.high * kFarthestFactor)
                           : end);
      }
    }
  }
  return ends;
}

AxisRange rangeOf(const GroupPlot& plot) {
  std::vector<double> values;
  for (const GroupSeries& series : plot.series) {
    for (const GroupValues& group : series.groups) {
      values.insert(values.end(), group.raw.begin(), group.raw.end());
      values.push_back(group.summary.value);
    }
  }
  const std::vector<double> ends = nearEnds(plot, values);
  values.insert(values.end(), ends.begin(), ends.end());
  if (plot.reference) {
    values.push_back(*plot.reference);
  }
  AxisRange range = AxisRange::of(values, plot.scale);
  if (plot.percent) {
    range = {};
    range.percent = true;
    for (const double value : values) {
      range = std::isfinite(value) ? range.with(value) : range;
    }
  } else if (plot.fromZero && plot.scale == AxisScale::kLinear) {
    range = range.with(0);
  }
  return range;
}

class Painter {
 public:
  Painter(Drawing& drawing, const GroupPlot& plot, const Panel& panel)
      : drawing_(drawing), plot_(plot), panel_(panel), step_(stepOf(plot, panel)) {}

  void paint() {
    if (plot_.rows) {
      separators();
    }
    if (plot_.reference) {
      reference();
    }
    if (plot_.linked) {
      links();
    }
    for (size_t s = 0; s < plot_.series.size(); ++s) {
      for (size_t c = 0; c < plot_.series[s].groups.size() && c < plot_.conditions.size(); ++c) {
        points(s, c);
      }
    }
    for (size_t s = 0; s < plot_.series.size(); ++s) {
      if (plot_.connected) {
        connection(s);
      }
      for (size_t c = 0; c < plot_.series[s].groups.size() && c < plot_.conditions.size(); ++c) {
        summary(s, c);
      }
    }
  }

 private:
  static double stepOf(const GroupPlot& plot, const Panel& panel) {
    const double share = kGroupShare / static_cast<double>(plot.series.size());
    // Lines from condition to condition want their series side by side, not across the whole width.
    return panel.categoryWidth() * (plot.connected ? std::min(share, plot.linked ? 0.12 : 0.24) : share);
  }

  SeriesStyle styleOf(size_t series, size_t condition) const {
    return seriesStyle(plot_.styleByCondition ? condition : series);
  }

  /// The middle of a series in a condition, along the axis of conditions.
  double middleOf(size_t series, size_t condition) const {
    const double category = static_cast<double>(condition);
    const double middle = plot_.rows ? panel_.y(category) : panel_.x(category);
    return middle + step_ * (static_cast<double>(series) - (static_cast<double>(plot_.series.size()) - 1) / 2);
  }
  double valueAt(double value) const { return plot_.rows ? panel_.x(value) : panel_.y(value); }
  PlotPoint place(double along, double value) const {
    return plot_.rows ? PlotPoint{valueAt(value), along} : PlotPoint{along, valueAt(value)};
  }
  bool isSummary(const GroupValues& values) const { return isDrawable(values.summary.value, plot_.scale); }

  void separators() {
    for (size_t c = 1; c < plot_.conditions.size(); ++c) {
      const double y = panel_.y(static_cast<double>(c) - 0.5);
      drawing_.line("separator", {panel_.area().left, y}, {panel_.area().right, y}, {kGridPaint, kThinLine});
    }
  }

  void reference() {
    const PlotBox& area = panel_.area();
    const Pen pen{kReferencePaint, kLine, {3, 2}};
    const double at = valueAt(*plot_.reference);
    if (plot_.rows) {
      drawing_.line("reference", {at, area.top}, {at, area.bottom}, pen);
      drawing_.text("reference name", {at, area.top - 1}, plot_.referenceName,
                    {.paint = kSoftTextPaint, .across = Across::kMiddle, .down = Down::kBottom});
    } else {
      drawing_.line("reference", {area.left, at}, {area.right, at}, pen);
      drawing_.text("reference name", {area.right, at - 1}, plot_.referenceName,
                    {.paint = kSoftTextPaint, .across = Across::kRight, .down = Down::kBottom});
    }
  }

  void links() {
    for (size_t s = 0; s < plot_.series.size(); ++s) {
      const std::vector<GroupValues>& groups = plot_.series[s].groups;
      const size_t subjects = groups.empty() ? 0 : groups.front().raw.size();
      const Pen pen{seriesStyle(s).paint.faded(0.6 * pointOpacity(subjects)), kThinLine};
      for (size_t subject = 0; subject < subjects; ++subject) {
        for (size_t c = 1; c < groups.size() && c < plot_.conditions.size(); ++c) {
          if (subject < groups[c - 1].raw.size() && subject < groups[c].raw.size() &&
              isDrawable(groups[c - 1].raw[subject], plot_.scale) && isDrawable(groups[c].raw[subject], plot_.scale)) {
            drawing_.line("link", place(middleOf(s, c - 1), groups[c - 1].raw[subject]),
                          place(middleOf(s, c), groups[c].raw[subject]), pen);
          }
        }
      }
    }
  }

  void points(size_t series, size_t condition) {
    const std::vector<double>& raw = plot_.series[series].groups[condition].raw;
    std::vector<double> places;
    std::vector<double> values;
    for (const size_t i : drawnPoints(raw, maxPoints(plot_))) {
      if (isDrawable(raw[i], plot_.scale)) {
        values.push_back(raw[i]);
        places.push_back(valueAt(raw[i]));
      }
    }
    const std::vector<double> offsets =
        plot_.linked ? std::vector<double>(places.size(), 0) : swarmOffsets(places, 2.1 * kPointRadius, 0.46 * step_);
    const SeriesStyle style = styleOf(series, condition);
    // The lines tell the story; their ends need not be large.
    const double radius = plot_.linked ? 0.7 * kPointRadius : kPointRadius;
    for (size_t i = 0; i < values.size(); ++i) {
      drawing_.marker("point", {place(middleOf(series, condition) + offsets[i], values[i]), style.marker, radius,
                                style.paint.faded(pointOpacity(values.size())), std::nullopt});
    }
  }

  void connection(size_t series) {
    std::vector<PlotPoint> line;
    const std::vector<GroupValues>& groups = plot_.series[series].groups;
    for (size_t c = 0; c < groups.size() && c < plot_.conditions.size(); ++c) {
      if (isSummary(groups[c])) {
        line.push_back(place(middleOf(series, c), groups[c].summary.value));
      }
    }
    if (line.size() > 1) {
      drawing_.polyline("connection", line, {seriesStyle(series).paint, kThickLine, seriesStyle(series).dash});
    }
  }

  void summary(size_t series, size_t condition) {
    const GroupValues& values = plot_.series[series].groups[condition];
    if (!isSummary(values)) {
      return;
    }
    const auto draw = plot_.rows ? drawLevelInterval : drawUprightInterval;
    draw(drawing_, panel_, middleOf(series, condition), values.summary, styleOf(series, condition));
  }

  Drawing& drawing_;
  const GroupPlot& plot_;
  const Panel& panel_;
  double step_;
};

std::string descriptionOf(const GroupPlot& plot) {
  std::string text =
      fmt::format("{}, by {}: {}; small marks: {}.", plot.valueLabel,
                  plot.conditionLabel.empty() ? "condition" : plot.conditionLabel, plot.summaryName, plot.pointName);
  for (const GroupSeries& series : plot.series) {
    for (size_t c = 0; c < series.groups.size() && c < plot.conditions.size(); ++c) {
      const GroupValues& group = series.groups[c];
      const auto count = std::count_if(group.raw.begin(), group.raw.end(),
                                       [&](double value) { return isDrawable(value, plot.scale); });
      text += fmt::format(" {}{}{}: {}, {} values", plot.conditions[c], series.name.empty() ? "" : ", ", series.name,
                          intervalText(group.summary, plot.percent), count);
      text +=
          static_cast<size_t>(count) > maxPoints(plot) ? fmt::format(" of which {} are drawn.", maxPoints(plot)) : ".";
    }
  }
  return text;
}

}  // namespace

std::vector<LegendEntry> groupLegend(const GroupPlot& plot) {
  std::vector<LegendEntry> entries;
  if (!plot.styleByCondition) {
    for (size_t s = 0; s < plot.series.size(); ++s) {
      entries.push_back({plot.series[s].name, seriesStyle(s), true, plot.connected});
    }
  }
  const SeriesStyle neutral{kSoftTextPaint, Marker::kCircle, {}};
  entries.push_back({plot.summaryName, neutral, true, true});
  entries.push_back(
      {plot.pointName, {kSoftTextPaint.faded(0.5), Marker::kCircle, {}}, true, false, true, kPointRadius});
  return entries;
}

Figure groupFigure(const GroupPlot& plot) {
  const bool any = !plot.conditions.empty() && std::any_of(plot.series.begin(), plot.series.end(), [&](const auto& s) {
    return std::any_of(s.groups.begin(), s.groups.end(),
                       [&](const GroupValues& values) { return hasValues(values, plot.scale); });
  });
  if (!any) {
    return emptyFigure(plot.title, plot.widthMillimetres, "no trial has a value to show");
  }
  Figure figure{plot.title, descriptionOf(plot), plot.widthMillimetres * kPointsPerMillimetre, 0, {}};
  const double legend = plot.legend ? drawLegend(figure.drawing, {0, 0, figure.width, 0}, groupLegend(plot)) : 0;
  // The name of a reference stands above rows, beside no point.
  const double top = legend + (plot.rows && plot.reference && !plot.referenceName.empty() ? kLineHeight : 0);
  const double rows = static_cast<double>(plot.conditions.size() * std::max<size_t>(plot.series.size(), 1));
  figure.height = plot.heightMillimetres > 0 ? plot.heightMillimetres * kPointsPerMillimetre
                  : plot.rows                ? top + rows * kSeriesHeight + 36
                                             : legend + kDefaultHeight;
  const AxisSpec values = AxisSpec::ofValues(plot.valueLabel, rangeOf(plot));
  const AxisSpec conditions = AxisSpec::ofCategories(plot.conditionLabel, plot.conditions);
  const Panel panel(figure.drawing, {0, top, figure.width - 2, figure.height}, plot.rows ? values : conditions,
                    plot.rows ? conditions : values);
  Painter(figure.drawing, plot, panel).paint();
  return figure;
}

}  // namespace ocelli
