#include "study/screen/instruction_images.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "oc_core/constructor/comprehensive_constructor.h"
#include "oc_core/constructor/portal_constructor.h"
#include "oc_core/gl/gl_api.h"
#include "oc_core/scene/maze_file.h"
#include "study/screen/screen_target.h"
#include "study/screen/study_pieces.h"
#include "study/screen/trial_overlay.h"
#include "study/task/trial_image.h"

namespace ocelli {
namespace {

constexpr double kEyeHeightMeters = 1.2;
constexpr double kFovHorizontalDegrees = 60;

/// A corridor from the south to a crossing, with one object around the corner.
Maze mazeToSearch() {
  Maze maze = mazeFromJsonText(R"({"plan": [
    "+-+-+-+-+-+",
    "|   | |   |",
    "+ +-+ +-+ +",
    "|         |",
    "+ +-+ +-+ +",
    "| | | | | |",
    "+ + + + + +",
    "|   | |   |",
    "+-+-+ +-+-+"]})",
                               "an example");
  maze.landmarks = {{{1, 1}, LandmarkShape::kSphere, LandmarkColor::kOrange, 0.15f, -0.1f}};
  return maze;
}

/// A crossing, and two corridors that turn back at each of its sides. One enters from the south.
Maze mazeToCount() {
  Maze maze = mazeFromJsonText(R"({"plan": [
    "+-+-+-+-+-+",
    "|   | |   |",
    "+ +-+ +-+ +",
    "|         |",
    "+ +-+ +-+ +",
    "|   | |   |",
    "+-+-+ +-+-+"]})",
                               "an example");
  maze.landmarks = {{{0, 1}, LandmarkShape::kCone, LandmarkColor::kYellow},
                    {{2, 1}, LandmarkShape::kCube, LandmarkColor::kSkyBlue},
                    {{1, 3}, LandmarkShape::kSphere, LandmarkColor::kVermilion, 0.1f, 0.1f},
                    {{0, 3}, LandmarkShape::kColumn, LandmarkColor::kPurple},
                    {{2, 3}, LandmarkShape::kPyramid, LandmarkColor::kOrange}};
  return maze;
}

/// From the middle of a cell, or as far behind it as walls allow.
PinholeCamera eyeIn(const Maze& maze, const MazeCell& cell, Direction heading, double backMeters, int width,
                    int height) {
  View view;
  view.eye =
      maze.centerOf(cell) + glm::vec3(0, kEyeHeightMeters, 0) - static_cast<float>(backMeters) * vectorOf(heading);
  view.target = view.eye + vectorOf(heading);
  view.fovVerticalDegrees =
      degreesFromRadians(2 * std::atan(std::tan(radiansFromDegrees(kFovHorizontalDegrees / 2)) * height / width));
  view.zNear = 0.05f;
  view.zFar = 200;
  return {view, width, height};
}

TrialLayout imageToSearch(const StudyScene& scene, bool graph, int width, int height) {
  TrialLayout layout;
  layout.scene = &scene;
  const PinholeCamera eye = eyeIn(scene.maze(), {3, 2}, Direction::kNorth, 0, width, height);
  SceneGuides guides;
  guides.maze = scene.maze();
  const PixelRect place{0, 0, static_cast<double>(width), static_cast<double>(height)};
  if (graph) {
    PortalOptions options;
    options.bentBeyond = 1;
    layout.views.push_back({place, buildPortalCamera(options, guides, eye)});
  } else {
    layout.views.push_back({place, eye});
  }
  return layout;
}

TrialLayout imageToCount(const StudyScene& scene, bool graph, int width, int height) {
  TrialLayout layout;
  layout.scene = &scene;
  if (graph) {
    ComprehensiveOptions options;
    options.nearness = 0.8;
    layout.views.push_back({{0, 0, static_cast<double>(width), static_cast<double>(height)},
                            makeComprehensiveCamera(scene.maze(), options, width, height)});
    return layout;
  }
  constexpr int kColumns = 3;
  constexpr int kGap = 6;
  const int across = (width - (kColumns - 1) * kGap) / kColumns;
  const int down = (height - kGap) / 2;
  const std::array<std::pair<MazeCell, Direction>, 6> eyes{{{{0, 0}, Direction::kEast},
                                                            {{2, 2}, Direction::kNorth},
                                                            {{0, 4}, Direction::kWest},
                                                            {{2, 0}, Direction::kEast},
                                                            {{1, 0}, Direction::kEast},
                                                            {{2, 4}, Direction::kWest}}};
  for (int i = 0; i < static_cast<int>(eyes.size()); ++i) {
    const auto& [cell, heading] = eyes[static_cast<size_t>(i)];
    const PixelRect place{static_cast<double>(i % kColumns * (across + kGap)),
                          static_cast<double>(i / kColumns * (down + kGap)), static_cast<double>(across),
                          static_cast<double>(down)};
    layout.views.push_back({place, eyeIn(scene.maze(), cell, heading, 1, across, down)});
  }
  return layout;
}

/// Where the view shows each object: the middle of its pixels.
std::vector<glm::dvec2> marksOf(const StudyScene& scene, const TrialLayout& layout) {
  const FragmentImage seen = rasterizeStudy(layout.views.front().camera, scene.mesh());
  std::vector<glm::dvec3> sums(scene.objectCount() + 1, glm::dvec3(0));
  for (int y = 0; y < seen.height(); ++y) {
    for (int x = 0; x < seen.width(); ++x) {
      if (seen(x, y).covered()) {
        sums[scene.objectOfTriangle()[seen(x, y).triangle]] += glm::dvec3(x + 0.5, y + 0.5, 1);
      }
    }
  }
  std::vector<glm::dvec2> marks;
  for (size_t i = 1; i < sums.size(); ++i) {
    if (sums[i].z > 0) {
      marks.emplace_back(glm::dvec2(sums[i]) / sums[i].z);
    }
  }
  return marks;
}

void drawPathMaps(StudyCanvas& canvas, const PixelRect& place) {
  static const std::array<std::vector<glm::dvec2>, 3> kPaths{{
      {{0, 3}, {0, 1}, {2, 1}, {2, 0}, {3, 0}, {3, 2}},
      {{0, 3}, {0, 1}, {2, 1}, {2, 2}, {3, 2}, {3, 0}},
      {{3, 3}, {3, 1}, {1, 1}, {1, 0}, {0, 0}, {0, 2}},
  }};
  const double gap = canvas.length(14);
  const double side = std::floor((place.width - 2 * gap) / 3);
  const double height = std::min(place.height, 1.2 * side);
  for (size_t i = 0; i < kPaths.size(); ++i) {
    const PixelRect card{place.left + static_cast<double>(i) * (side + gap), place.center().y - height / 2, side,
                         height};
    canvas.fill(card, kStudyCard, canvas.length(10));
    canvas.outline(card, kStudyLine, canvas.length(1.5), canvas.length(10));
    const double pad = canvas.length(10);
    const double line = canvas.look().textPixels(StudyText::kSmall) + 2 * pad;
    drawKeyCap(canvas, card.left + pad, card.top + pad + line / 2 - pad / 2, std::to_string(i + 1), kStudyCard);
    drawPathMap(canvas, {card.left, card.top + line, card.width, card.height - line}, kPaths[i], kStudyCard);
  }
}

struct KeyRow {
  std::vector<std::string> keys;
  std::string meaning;
};

std::vector<KeyRow> rowsOf(const Controls& controls) {
  const auto name = [](Key key) { return std::string(nameOf(key)); };
  return {{{name(controls.forward), "Up"}, "walk forward"},
          {{name(controls.backward), "Down"}, "walk backward"},
          {{name(controls.left), name(controls.right)}, "step to the side"},
          {{name(controls.turnLeft), name(controls.turnRight), "Left", "Right"}, "turn"},
          {{"right mouse button"}, "hold, move: turn"},
          {{"Shift", "arrows"}, "move the pointer"},
          {{name(controls.select), "left click"}, "choose"}};
}

void drawControls(StudyCanvas& canvas, const PixelRect& place, const Controls& controls) {
  const std::vector<KeyRow> rows = rowsOf(controls);
  const double gap = canvas.length(8);
  double column = 0;
  for (const KeyRow& row : rows) {
    double width = 0;
    for (const std::string& key : row.keys) {
      width += keyCapWidth(canvas, key) + gap;
    }
    column = std::max(column, width);
  }
  const double pad = canvas.length(26);
  const double rowHeight = std::min((place.height - 2 * pad) / static_cast<double>(rows.size()), canvas.length(58));
  const double height = rowHeight * static_cast<double>(rows.size()) + 2 * pad;
  const PixelRect card{place.left, place.center().y - height / 2, place.width, height};
  canvas.fill(card, kStudyCard, canvas.length(12));
  double y = card.top + pad + rowHeight / 2;
  for (const KeyRow& row : rows) {
    double x = card.left + pad;
    for (const std::string& key : row.keys) {
      x = drawKeyCap(canvas, x, y, key, kStudyField) + gap;
    }
    canvas.writeLine({StudyText::kBody, kStudyText, kStudyCard},
                     {card.left + pad + column + canvas.length(10), y - canvas.look().textPixels(StudyText::kBody) / 2},
                     row.meaning);
    y += rowHeight;
  }
}

}  // namespace

const InstructionImages::View& InstructionImages::viewOf(const std::string& name, int width, int height) {
  const std::string key = fmt::format("{} {}x{}", name, width, height);
  if (const auto found = views_.find(key); found != views_.end()) {
    return found->second;
  }
  const bool search = name.starts_with("find");
  const bool graph = name.ends_with("gc");
  const StudyScene scene(search ? mazeToSearch() : mazeToCount(), search);
  const TrialLayout layout =
      search ? imageToSearch(scene, graph, width, height) : imageToCount(scene, graph, width, height);
  View view;
  ScreenTarget target(*context_, width, height);
  target.clear(kStudyBackground);
  SceneViews(*context_).draw(layout, target.color());
  view.texture = makeTexture(*context_, GL_RGBA8, width, height);
  context_->gl().CopyImageSubData(target.color().id(), GL_TEXTURE_2D, 0, 0, 0, 0, view.texture.id(), GL_TEXTURE_2D, 0,
                                  0, 0, 0, width, height, 1);
  if (graph) {
    view.marks = marksOf(scene, layout);
  }
  return views_.emplace(key, std::move(view)).first->second;
}

void InstructionImages::draw(StudyCanvas& canvas, const std::string& name, const PixelRect& place) {
  if (name == "controls") {
    drawControls(canvas, place, controls_);
    return;
  }
  if (name == "path_maps") {
    drawPathMaps(canvas, place);
    return;
  }
  if (std::ranges::find(kInstructionImages, name) == kInstructionImages.end()) {
    return;
  }
  const View& view = viewOf(name, static_cast<int>(place.width), static_cast<int>(place.height));
  canvas.image(view.texture, place);
  canvas.outline(place, kStudyLine, canvas.length(1.5));
  for (size_t i = 0; i < view.marks.size(); ++i) {
    const glm::dvec2 center = glm::dvec2(place.left, place.top) + view.marks[i];
    const double radius = canvas.length(view.marks.size() == 1 ? 44 : 30);
    canvas.ring(center, radius, kStudyInk, canvas.length(7));
    canvas.ring(center, radius, {255, 255, 255}, canvas.length(3));
  }
}

}  // namespace ocelli
