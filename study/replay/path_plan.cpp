#include "study/replay/path_plan.h"

#include <cairo-svg.h>
#include <cairo.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <memory>

#include "oc_core/base/color.h"
#include "oc_core/base/error.h"
#include "oc_core/base/output_file.h"
#include "oc_core/worlds/landmark_solids.h"

namespace ocelli {
namespace {

constexpr double kMargin = 28;
constexpr double kTitleHeight = 62;
constexpr double kPlanPixels = 900;  // longer side
constexpr double kLegendWidth = 290;
constexpr double kText = 15;
constexpr double kArrowEvery = 2.5;  // metres
constexpr double kLabelEvery = 5;    // seconds
constexpr double kLabelApart = 26;   // pixels
constexpr double kMinStep = 0.004;   // metres: less is standing still

using Color = std::array<double, 3>;

/// From dark to light, by brightness too, so that it can be read without colour: after "viridis", without its lightest
/// end, which is lost on white.
constexpr std::array<Color, 6> kTimeColors{{{0.27, 0.00, 0.33},
                                            {0.25, 0.27, 0.53},
                                            {0.16, 0.47, 0.56},
                                            {0.13, 0.64, 0.53},
                                            {0.37, 0.77, 0.38},
                                            {0.66, 0.82, 0.20}}};

Color timeColor(double share) {
  const double at = std::clamp(share, 0.0, 1.0) * (kTimeColors.size() - 1);
  const auto i = std::min(static_cast<size_t>(at), kTimeColors.size() - 2);
  Color mixed;
  for (size_t k = 0; k < 3; ++k) {
    mixed[k] = std::lerp(kTimeColors[i][k], kTimeColors[i + 1][k], at - static_cast<double>(i));
  }
  return mixed;
}

Color bytesOf(LandmarkColor color) {
  const glm::vec3 linear = colorOf(color);
  return {static_cast<double>(srgbFromLinear(linear.x)), static_cast<double>(srgbFromLinear(linear.y)),
          static_cast<double>(srgbFromLinear(linear.z))};
}

struct DestroyPlanSurface {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};
struct DestroyPlanContext {
  void operator()(cairo_t* context) const { cairo_destroy(context); }
};
using Surface = std::unique_ptr<cairo_surface_t, DestroyPlanSurface>;
using Context = std::unique_ptr<cairo_t, DestroyPlanContext>;

glm::dvec2 placeOf(const WalkerPose& pose) {
  return {pose.x, pose.z};
}

class Painter {
 public:
  Painter(cairo_t* cairo, const PathPlan& plan, double scale)
      : cairo_(cairo), plan_(plan), maze_(*plan.maze), scale_(scale) {
    cairo_select_font_face(cairo_, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_line_cap(cairo_, CAIRO_LINE_CAP_ROUND);
    cairo_set_line_join(cairo_, CAIRO_LINE_JOIN_ROUND);
  }

  void paint() {
    color({1, 1, 1});
    cairo_paint(cairo_);
    color({0.1, 0.1, 0.1});
    text(kMargin, kMargin + 16, 20, plan_.title);
    text(kMargin, kMargin + 40, kText, plan_.subtitle);
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
  }

 private:
  double cell() const { return static_cast<double>(maze_.cellSize) * scale_; }
  glm::dvec2 on(const glm::dvec2& place) const {
    const glm::dvec2 origin(static_cast<double>(maze_.origin.x), static_cast<double>(maze_.origin.z));
    return glm::dvec2(kMargin, kMargin + kTitleHeight) + (place - origin) * scale_;
  }
  void color(const Color& c, double alpha = 1) { cairo_set_source_rgba(cairo_, c[0], c[1], c[2], alpha); }
  void text(double x, double y, double size, const std::string& what) {
    cairo_set_font_size(cairo_, size);
    cairo_move_to(cairo_, x, y);
    cairo_show_text(cairo_, what.c_str());
  }
  void disc(const glm::dvec2& at, double radius) {
    cairo_new_sub_path(cairo_);
    cairo_arc(cairo_, at.x, at.y, radius, 0, 6.2832);
  }

  void wall(double x0, double y0, double x1, double y1) {
    const glm::dvec2 corner(kMargin, kMargin + kTitleHeight);
    cairo_move_to(cairo_, corner.x + x0 * cell(), corner.y + y0 * cell());
    cairo_line_to(cairo_, corner.x + x1 * cell(), corner.y + y1 * cell());
  }
  void walls() {
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
    color({0.72, 0.72, 0.72});
    cairo_set_line_width(cairo_, std::max(2.0, static_cast<double>(maze_.wallThickness) * scale_));
    cairo_stroke(cairo_);
  }

  double lastSecond() const { return plan_.path.empty() ? 1 : std::max(plan_.path.back().seconds, 1e-3); }

  void path() {
    double since = kArrowEvery / 2;
    double nextLabel = kLabelEvery;
    std::vector<glm::dvec2> labels;
    cairo_set_line_width(cairo_, 2.6);
    for (size_t i = 1; i < plan_.path.size(); ++i) {
      const PathPlan::Point& point = plan_.path[i];
      const glm::dvec2 from = placeOf(plan_.path[i - 1].pose);
      const glm::dvec2 to = placeOf(point.pose);
      const double step = glm::distance(from, to);
      const Color c = timeColor(point.seconds / lastSecond());
      if (step > 0) {
        cairo_move_to(cairo_, on(from).x, on(from).y);
        cairo_line_to(cairo_, on(to).x, on(to).y);
        color(c);
        cairo_stroke(cairo_);
        since += step;
      }
      if (since >= kArrowEvery && step > kMinStep) {
        since = 0;
        arrow(on(to), (to - from) / step, c);
      }
      if (point.seconds >= nextLabel) {
        nextLabel += kLabelEvery;
        timeLabel(on(to), point.seconds, labels);
      }
    }
  }
  void arrow(const glm::dvec2& at, const glm::dvec2& along, const Color& c) {
    const glm::dvec2 aside(-along.y, along.x);
    const glm::dvec2 tip = at + along * 7.0;
    const glm::dvec2 left = at - along * 4.0 + aside * 5.0;
    const glm::dvec2 right = at - along * 4.0 - aside * 5.0;
    cairo_move_to(cairo_, tip.x, tip.y);
    cairo_line_to(cairo_, left.x, left.y);
    cairo_line_to(cairo_, right.x, right.y);
    cairo_close_path(cairo_);
    color(c);
    cairo_fill(cairo_);
  }
  /// Not where another one stands.
  void timeLabel(const glm::dvec2& at, double seconds, std::vector<glm::dvec2>& labels) {
    if (std::any_of(labels.begin(), labels.end(),
                    [&](const glm::dvec2& other) { return glm::distance(other, at) < kLabelApart; })) {
      return;
    }
    labels.push_back(at);
    const std::string label = fmt::format("{:.0f}", seconds);
    cairo_set_font_size(cairo_, 13);
    cairo_text_extents_t extents;
    cairo_text_extents(cairo_, label.c_str(), &extents);
    const glm::dvec2 corner = at + glm::dvec2(9, -9);
    color({1, 1, 1}, 0.85);
    cairo_rectangle(cairo_, corner.x - 2, corner.y - 12, extents.x_advance + 4, 15);
    cairo_fill(cairo_);
    color({0.1, 0.1, 0.1});
    text(corner.x, corner.y, 13, label);
  }

  void objectPath(const PathPlan::Object& object) {
    if (object.places.size() < 2) {
      return;
    }
    for (const glm::dvec2& place : object.places) {
      cairo_line_to(cairo_, on(place).x, on(place).y);
    }
    const std::array<double, 2> dashes{5, 6};
    cairo_set_dash(cairo_, dashes.data(), 2, 0);
    cairo_set_line_width(cairo_, 3);
    color(bytesOf(object.color), 0.9);
    cairo_stroke(cairo_);
    cairo_set_dash(cairo_, nullptr, 0, 0);
  }
  void objectMark(const PathPlan::Object& object) {
    if (object.places.empty()) {
      return;
    }
    const double radius = std::max(7.0, 0.8 * static_cast<double>(kLandmarkRadius) * cell());
    if (object.places.size() > 1) {
      // Where it set out, hollow.
      disc(on(object.places.front()), radius);
      color(bytesOf(object.color));
      cairo_set_line_width(cairo_, 3);
      cairo_stroke(cairo_);
    }
    disc(on(object.places.back()), radius);
    color(bytesOf(object.color));
    cairo_fill_preserve(cairo_);
    color({0.1, 0.1, 0.1});
    cairo_set_line_width(cairo_, 1.6);
    cairo_stroke(cairo_);
  }
  void startMark(const glm::dvec2& at) {
    cairo_rectangle(cairo_, at.x - 9, at.y - 9, 18, 18);
    color({1, 1, 1});
    cairo_fill_preserve(cairo_);
    color({0.1, 0.1, 0.1});
    cairo_set_line_width(cairo_, 2);
    cairo_stroke(cairo_);
    text(at.x - 5, at.y + 5.5, 15, "S");
  }
  /// A cross; in a ring for the click that ended the trial.
  void clickMark(const glm::dvec2& at, bool ended) {
    color({0.75, 0.05, 0.05});
    cairo_set_line_width(cairo_, 2.4);
    for (const double side : {-1.0, 1.0}) {
      cairo_move_to(cairo_, at.x - 6, at.y - 6 * side);
      cairo_line_to(cairo_, at.x + 6, at.y + 6 * side);
    }
    cairo_stroke(cairo_);
    if (ended) {
      disc(at, 11);
      cairo_stroke(cairo_);
    }
  }

  void legend(double x, double y) {
    const auto line = [&](const std::string& what) {
      color({0.1, 0.1, 0.1});
      text(x + 34, y + 5, kText, what);
      y += 32;
    };
    if (!plan_.path.empty()) {
      startMark({x + 11, y});
      line("where the subject starts");
    }
    for (const PathPlan::Object& object : plan_.objects) {
      disc({x + 11, y}, 9);
      color(bytesOf(object.color));
      cairo_fill_preserve(cairo_);
      color({0.1, 0.1, 0.1});
      cairo_set_line_width(cairo_, 1.6);
      cairo_stroke(cairo_);
      line(fmt::format("{} {}{}", nameOf(object.color), nameOf(object.shape),
                       object.places.size() > 1 ? ", at the end" : ""));
    }
    if (std::any_of(plan_.objects.begin(), plan_.objects.end(),
                    [](const PathPlan::Object& object) { return object.places.size() > 1; })) {
      disc({x + 11, y}, 8);
      color({0.4, 0.4, 0.4});
      cairo_set_line_width(cairo_, 3);
      cairo_stroke(cairo_);
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
      color({0.1, 0.1, 0.1});
      text(x, y + 10, kText, plan_.simulated);
    }
  }
  void timeBar(double x, double y) {
    constexpr int kSteps = 100;
    constexpr double kWidth = 240;
    color({0.1, 0.1, 0.1});
    text(x, y + 2, kText, "time, seconds");
    for (int i = 0; i < kSteps; ++i) {
      cairo_rectangle(cairo_, x + kWidth * i / kSteps, y + 12, kWidth / kSteps + 0.5, 14);
      color(timeColor((i + 0.5) / kSteps));
      cairo_fill(cairo_);
    }
    color({0.1, 0.1, 0.1});
    for (const double share : {0.0, 0.5, 1.0}) {
      text(x + (kWidth - 22) * share, y + 44, 14, fmt::format("{:.1f}", share * lastSecond()));
    }
  }
  void scaleBar(double x, double y) {
    const double meters = std::max(1.0, std::round(static_cast<double>(maze_.cellSize)));
    color({0.1, 0.1, 0.1});
    cairo_set_line_width(cairo_, 2.5);
    cairo_move_to(cairo_, x, y);
    cairo_line_to(cairo_, x + meters * scale_, y);
    cairo_stroke(cairo_);
    text(x + meters * scale_ + 10, y + 5, kText, fmt::format("{:g} m, north is up", meters));
  }

  cairo_t* cairo_;
  const PathPlan& plan_;
  const Maze& maze_;
  double scale_;
};

cairo_status_t append(void* text, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

void requireDrawn(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS) {
    throw WorkError(fmt::format("the plan cannot be drawn: {}", cairo_status_to_string(status)), "plan",
                    "is there enough memory?");
  }
}

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

void writePathPlan(const std::filesystem::path& path, const PathPlan& plan) {
  if (!plan.maze) {
    throw InputError("the trial shows no maze", plan.title, "choose another trial for a plan");
  }
  const bool isSvg = path.extension() == ".svg" || (path.extension() != ".png" && isStream(path));
  if (!isSvg && path.extension() != ".png") {
    throw InputError("a plan is an SVG or a PNG", path.string(), "end its name in .svg or .png");
  }
  const glm::dvec2 meters =
      glm::dvec2(plan.maze->columns(), plan.maze->rows()) * static_cast<double>(plan.maze->cellSize);
  const double scale = kPlanPixels / std::max(meters.x, meters.y);
  const double width = meters.x * scale + 3 * kMargin + kLegendWidth;
  const double height = std::max(meters.y * scale, 420.0) + 2 * kMargin + kTitleHeight + 30;
  std::string bytes;
  {
    const Surface surface(isSvg ? cairo_svg_surface_create_for_stream(append, &bytes, width, height)
                                : cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(std::ceil(width)),
                                                             static_cast<int>(std::ceil(height))));
    const Context context(cairo_create(surface.get()));
    Painter(context.get(), plan, scale).paint();
    requireDrawn(cairo_status(context.get()));
    if (!isSvg) {
      requireDrawn(cairo_surface_write_to_png_stream(surface.get(), append, &bytes));
    }
    cairo_surface_finish(surface.get());
  }
  OutputFile file(path);
  file.write(bytes);
  file.commit();
}

}  // namespace ocelli
