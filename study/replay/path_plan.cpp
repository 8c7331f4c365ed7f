#include "study/replay/path_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "oc_core/base/error.h"
#include "oc_core/drawing/color_scale.h"
#include "oc_core/multiperspective/figure_file.h"
#include "study/replay/landmark_paint.h"

namespace ocelli {
namespace {

constexpr double kMargin = 28;
constexpr double kTitleHeight = 62;
constexpr double kPlanPoints = 900;  // longer side
constexpr double kLegendWidth = 290;
constexpr double kText = 15;
constexpr double kArrowEvery = 2.5;  // metres
constexpr double kLabelEvery = 5;    // seconds
constexpr double kLabelApart = 26;   // points
constexpr double kMinStep = 0.004;   // metres: less is standing still

constexpr Paint kInk = paintOf(page_color::kText);
constexpr Paint kPaper{1, 1, 1};
constexpr Paint kClick{0.75, 0.05, 0.05};

/// From dark to light; the lightest end of the scale would be lost on white.
Paint timePaint(double share) {
  return scaleColor(1 - 0.7 * share);
}

glm::dvec2 placeOf(const WalkerPose& pose) {
  return {pose.x, pose.z};
}

Pen roundPen(const Paint& paint, double width) {
  return {paint, width, {}, true};
}

class PathPlanDrawing {
 public:
  explicit PathPlanDrawing(const PathPlan& plan)
      : plan_(plan), maze_(*plan.maze), scale_(kPlanPoints / std::max(meters().x, meters().y)) {}

  Figure figure() {
    Figure figure;
    figure.title = plan_.title;
    figure.description = plan_.subtitle;
    figure.width = meters().x * scale_ + 3 * kMargin + kLegendWidth;
    figure.height = std::max(meters().y * scale_, 420.0) + 2 * kMargin + kTitleHeight + 30;
    text("title", kMargin, kMargin + 16, 20, plan_.title);
    text("title", kMargin, kMargin + 40, kText, plan_.subtitle);
    walls();
    for (const PathPlan::Object& object : plan_.objects) {
      objectPath(object);
    }
    path();
    for (const PathPlan::Object& object : plan_.objects) {
      objectMark(object);
    }
    for (const PathPlan::Click& click : plan_.clicks) {
      clickMark(on(click.place), click.ended);
    }
    if (!plan_.path.empty()) {
      startMark(on(placeOf(plan_.path.front().pose)));
    }
    legend(kMargin + maze_.columns() * cell() + kMargin, kMargin + kTitleHeight + 10);
    scaleBar(kMargin, kMargin + kTitleHeight + maze_.rows() * cell() + 30);
    figure.drawing = std::move(drawing_);
    return figure;
  }

 private:
  glm::dvec2 meters() const { return glm::dvec2(maze_.columns(), maze_.rows()) * static_cast<double>(maze_.cellSize); }
  double cell() const { return static_cast<double>(maze_.cellSize) * scale_; }
  PlotPoint on(const glm::dvec2& place) const {
    const glm::dvec2 origin(static_cast<double>(maze_.origin.x), static_cast<double>(maze_.origin.z));
    const glm::dvec2 at = glm::dvec2(kMargin, kMargin + kTitleHeight) + (place - origin) * scale_;
    return {at.x, at.y};
  }
  void text(const char* part, double x, double y, double size, const std::string& what) {
    TextLook look;
    look.size = size;
    drawing_.text(part, {x, y}, what, look);
  }
  void disc(const char* part, PlotPoint at, double radius, std::optional<Paint> fill, const Pen& pen) {
    drawing_.marker(part, {at, Marker::kCircle, radius, fill, pen});
  }

  void walls() {
    PathShape walls;
    const auto wall = [&](int x0, int y0, int x1, int y1) {
      const double top = kMargin + kTitleHeight;
      walls.lines.push_back({{kMargin + x0 * cell(), top + y0 * cell()}, {kMargin + x1 * cell(), top + y1 * cell()}});
    };
    for (int row = 0; row < maze_.rows(); ++row) {
      for (int column = 0; column < maze_.columns(); ++column) {
        const MazeCell at{row, column};
        if (!maze_.isOpen(at, Direction::kEast)) {
          wall(column + 1, row, column + 1, row + 1);
        }
        if (!maze_.isOpen(at, Direction::kSouth)) {
          wall(column, row + 1, column + 1, row + 1);
        }
      }
    }
    wall(0, 0, maze_.columns(), 0);
    wall(0, 0, 0, maze_.rows());
    walls.pen = roundPen({0.72, 0.72, 0.72}, std::max(2.0, static_cast<double>(maze_.wallThickness) * scale_));
    drawing_.path("wall", std::move(walls));
  }

  double lastSecond() const { return plan_.path.empty() ? 1 : std::max(plan_.path.back().seconds, 1e-3); }

  void path() {
    double since = kArrowEvery / 2;
    double nextLabel = kLabelEvery;
    std::vector<PlotPoint> labels;
    for (size_t i = 1; i < plan_.path.size(); ++i) {
      const PathPlan::Point& point = plan_.path[i];
      const glm::dvec2 from = placeOf(plan_.path[i - 1].pose);
      const glm::dvec2 to = placeOf(point.pose);
      const double step = glm::distance(from, to);
      const Paint paint = timePaint(point.seconds / lastSecond());
      if (step > 0) {
        drawing_.line("walk", on(from), on(to), roundPen(paint, 2.6));
        since += step;
      }
      if (since >= kArrowEvery && step > kMinStep) {
        since = 0;
        arrow(on(to), (to - from) / step, paint);
      }
      if (point.seconds >= nextLabel) {
        nextLabel += kLabelEvery;
        timeLabel(on(to), point.seconds, labels);
      }
    }
  }
  void arrow(PlotPoint at, const glm::dvec2& along, const Paint& paint) {
    const auto corner = [&](double ahead, double aside) {
      return PlotPoint{at.x + ahead * along.x - aside * along.y, at.y + ahead * along.y + aside * along.x};
    };
    drawing_.path("arrow", {{{corner(7, 0), corner(-4, 5), corner(-4, -5)}}, true, paint, std::nullopt});
  }
  /// Not where another one stands.
  void timeLabel(PlotPoint at, double seconds, std::vector<PlotPoint>& labels) {
    if (std::any_of(labels.begin(), labels.end(),
                    [&](const PlotPoint& other) { return std::hypot(other.x - at.x, other.y - at.y) < kLabelApart; })) {
      return;
    }
    labels.push_back(at);
    const std::string label = fmt::format("{:.0f}", seconds);
    const double x = at.x + 9;
    const double y = at.y - 9;
    drawing_.box("time", {x - 2, y - 12, x + 2 + textWidth(label, Face::kSans, 13), y + 3}, kPaper.faded(0.85));
    text("time", x, y, 13, label);
  }

  void objectPath(const PathPlan::Object& object) {
    if (object.places.size() < 2) {
      return;
    }
    std::vector<PlotPoint> points;
    for (const glm::dvec2& place : object.places) {
      points.push_back(on(place));
    }
    drawing_.polyline("object's way", std::move(points), {paintOf(object.color).faded(0.9), 3, {5, 6}, true});
  }
  void objectMark(const PathPlan::Object& object) {
    if (object.places.empty()) {
      return;
    }
    const double radius = std::max(7.0, 0.8 * static_cast<double>(kLandmarkRadius) * cell());
    const Paint paint = paintOf(object.color);
    if (object.places.size() > 1) {
      // Where it set out, hollow.
      disc("object's start", on(object.places.front()), radius, std::nullopt, {paint, 3});
    }
    disc("object", on(object.places.back()), radius, paint, {kInk, 1.6});
  }
  void startMark(PlotPoint at) {
    drawing_.box("start", {at.x - 9, at.y - 9, at.x + 9, at.y + 9}, kPaper, roundPen(kInk, 2));
    text("start", at.x - 5, at.y + 5.5, 15, "S");
  }
  /// A cross; in a ring for the click that ended the trial.
  void clickMark(PlotPoint at, bool ended) {
    const Pen pen = roundPen(kClick, 2.4);
    drawing_.path("click",
                  {{{{at.x - 6, at.y + 6}, {at.x + 6, at.y - 6}}, {{at.x - 6, at.y - 6}, {at.x + 6, at.y + 6}}},
                   false,
                   std::nullopt,
                   pen});
    if (ended) {
      disc("click", at, 11, std::nullopt, pen);
    }
  }

  void legend(double x, double y) {
    const auto line = [&](const std::string& what) {
      text("legend", x + 34, y + 5, kText, what);
      y += 32;
    };
    if (!plan_.path.empty()) {
      startMark({x + 11, y});
      line("where the subject starts");
    }
    for (const PathPlan::Object& object : plan_.objects) {
      disc("legend", {x + 11, y}, 9, paintOf(object.color), {kInk, 1.6});
      line(fmt::format("{} {}{}", nameOf(object.color), nameOf(object.shape),
                       object.places.size() > 1 ? ", at the end" : ""));
    }
    if (std::any_of(plan_.objects.begin(), plan_.objects.end(),
                    [](const PathPlan::Object& object) { return object.places.size() > 1; })) {
      disc("legend", {x + 11, y}, 8, std::nullopt, {paintOf(page_color::kSoft), 3});
      line("where it set out, and its way");
    }
    if (!plan_.clicks.empty()) {
      clickMark({x + 11, y}, false);
      line("a click, where the subject stood");
      clickMark({x + 11, y}, true);
      line("the click that ended the trial");
    }
    if (plan_.path.size() > 1) {
      timeBar(x, y + 10);
      y += 86;
    }
    if (!plan_.simulated.empty()) {
      text("legend", x, y + 10, kText, plan_.simulated);
    }
  }
  void timeBar(double x, double y) {
    constexpr int kSteps = 100;
    constexpr double kWidth = 240;
    text("legend", x, y + 2, kText, "time, seconds");
    for (int i = 0; i < kSteps; ++i) {
      const double left = x + kWidth * i / kSteps;
      drawing_.box("time scale", {left, y + 12, left + kWidth / kSteps + 0.5, y + 26}, timePaint((i + 0.5) / kSteps));
    }
    for (const double share : {0.0, 0.5, 1.0}) {
      text("legend", x + (kWidth - 22) * share, y + 44, 14, fmt::format("{:.1f}", share * lastSecond()));
    }
  }
  void scaleBar(double x, double y) {
    const double length = std::max(1.0, std::round(static_cast<double>(maze_.cellSize)));
    drawing_.line("scale", {x, y}, {x + length * scale_, y}, roundPen(kInk, 2.5));
    text("scale", x + length * scale_ + 10, y + 5, kText, fmt::format("{:g} m, north is up", length));
  }

  const PathPlan& plan_;
  const Maze& maze_;
  double scale_;  ///< points a metre
  Drawing drawing_;
};

bool isClick(const InputEvent& event) {
  const auto* button = std::get_if<PointerButtonEvent>(&event);
  return button != nullptr && button->pressed && button->button == PointerButton::kLeft;
}

std::string subtitleOf(const TrialRecord& record) {
  const TrialOutcome& outcome = record.outcome;
  if (record.ending != TrialEnding::kCompleted) {
    return fmt::format("{} before its end", nameOf(record.ending));
  }
  const double seconds = static_cast<double>(outcome.responseTicks) / static_cast<double>(kTicksPerSecond);
  return fmt::format("{} after {:.1f} s; right: {}",
                     outcome.censored ? "time was over" : fmt::format("answer \"{}\"", outcome.answer), seconds,
                     outcome.expected);
}

}  // namespace

PathPlan pathPlanOf(const TaskBlock& block, const TrialLog& log, const std::string& title) {
  PathPlan plan;
  plan.title = title;
  plan.subtitle = subtitleOf(log.record);
  bool moves = false;
  ReplayOptions options;
  options.onFrame = [&](const FrameRecord& frame, const TrialRun& run) {
    const double seconds = static_cast<double>(frame.tick) / static_cast<double>(kTicksPerSecond);
    plan.path.push_back({seconds, run.pose()});
    const TrialLayout layout = run.layout();
    if (layout.scene == nullptr) {
      return;
    }
    if (!plan.maze) {
      plan.maze = layout.scene->maze();
      for (const Landmark& landmark : plan.maze->landmarks) {
        plan.objects.push_back({landmark.shape, landmark.color, {}});
      }
    }
    for (size_t i = 0; i < std::min(plan.objects.size(), layout.scene->objectCount()); ++i) {
      const glm::vec3 offset = i < layout.objectOffsets.size() ? layout.objectOffsets[i] : glm::vec3(0);
      const glm::vec3 place = layout.scene->boxOf(i).center() + offset;
      const glm::dvec2 at(static_cast<double>(place.x), static_cast<double>(place.z));
      moves = moves || (!plan.objects[i].places.empty() && plan.objects[i].places.front() != at);
      plan.objects[i].places.push_back(at);
    }
  };
  replayTrial(block, log, options);
  for (PathPlan::Object& object : plan.objects) {
    object.places.resize(moves ? object.places.size() : std::min<size_t>(object.places.size(), 1));
  }
  for (const InputRecord& input : log.inputs) {
    if (isClick(input.event) && !plan.path.empty()) {
      const double seconds = static_cast<double>(input.tick) / static_cast<double>(kTicksPerSecond);
      const auto then = std::lower_bound(plan.path.begin(), plan.path.end() - 1, seconds,
                                         [](const PathPlan::Point& point, double at) { return point.seconds < at; });
      plan.clicks.push_back({seconds, placeOf(then->pose), false});
    }
  }
  if (!plan.clicks.empty() && log.record.outcome.correct) {
    plan.clicks.back().ended = true;
  }
  // One who stood still all the time did not walk: what is shown is a scene.
  if (std::all_of(
          plan.path.begin(), plan.path.end(),
          [&](const PathPlan::Point& point) { return placeOf(point.pose) == placeOf(plan.path.front().pose); }) &&
      plan.clicks.empty()) {
    plan.path.clear();
  }
  return plan;
}

Figure pathPlanFigure(const PathPlan& plan) {
  if (!plan.maze) {
    throw InputError("the trial shows no maze", plan.title, "choose another trial for a plan");
  }
  return PathPlanDrawing(plan).figure();
}

void writePathPlan(const std::filesystem::path& path, const PathPlan& plan) {
  requireFigureFile(path);
  writeFigure(path, pathPlanFigure(plan));
}

}  // namespace ocelli
