#include "study/tasks/estimated_object.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "oc_core/base/check.h"
#include "oc_core/base/conventions.h"
#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/render/identity_image.h"
#include "oc_core/worlds/maze_file.h"
#include "oc_core/worlds/maze_validate.h"
#include "study/task/task_fields.h"
#include "study/task/trial_image.h"
#include "study/trial/estimated_value.h"

namespace ocelli {
namespace {

/// Each object must show with so many pixels.
constexpr size_t kMinEstimatedPixels = 40;
/// Nearer there is no direction, and no distance that one could tell, metres.
constexpr double kMinEstimatedMeters = 0.5;

Maze withObject(Maze maze, const Landmark& object) {
  maze.landmarks = {object};
  return maze;
}

std::vector<EstimatedCase> readEstimatedCases(JsonFields& fields, const std::string& caseField, const Maze& maze) {
  const ObjectLook look = readObjectLook(fields, true);
  std::vector<EstimatedCase> cases;
  readCases(fields, caseField, [&](JsonFields& each, const std::string& label) {
    EstimatedCase of{label, {readCell(each, maze), look.shape, look.color, 0, 0}};
    of.object.east = static_cast<float>(each.number("east", -0.5, 0.5, 0));
    of.object.south = static_cast<float>(each.number("south", -0.5, 0.5, 0));
    validate(withObject(maze, of.object), each.where());
    cases.push_back(of);
  });
  return cases;
}

}  // namespace

EstimatedObjects::EstimatedObjects(JsonFields& fields, const std::string& caseField, const TaskSetting& setting)
    : maze_(readMazeOf(fields, setting)),
      controls_(setting.controls),
      conditions_(setting.conditions.names),
      start_(readStart(fields, maze_)),
      cases_(readEstimatedCases(fields, caseField, maze_)),
      camera_(maze_, setting.controls, readEyeCameraOptions(fields), setting.conditions),
      scene_(withObject(maze_, cases_.front().object)) {
  for (int i = 0; i < caseCount(); ++i) {
    if (metersTo(i) < kMinEstimatedMeters) {
      throw InputError(fmt::format("the object is {:.2f} m from where one stands", metersTo(i)),
                       fmt::format("{}, case \"{}\"", fields.where(), caseOf(i).label),
                       fmt::format("put it {:g} m away or farther, or change \"start\"", kMinEstimatedMeters));
    }
  }
}

const EstimatedCase& EstimatedObjects::caseOf(int index) const {
  OC_CHECK(index >= 0 && index < caseCount(), "a trial is of a case of its block");
  return cases_[static_cast<size_t>(index)];
}

glm::dvec2 EstimatedObjects::placeOf(int index) const {
  const Landmark& object = caseOf(index).object;
  const glm::vec3 place = maze_.centerOf(object.cell) + maze_.cellSize * glm::vec3(object.east, 0, object.south);
  return {static_cast<double>(place.x), static_cast<double>(place.z)};
}

double EstimatedObjects::metersTo(int index) const {
  return glm::distance(placeOf(index), {start_.x, start_.z});
}

double EstimatedObjects::degreesTo(int index) const {
  const glm::dvec2 way = placeOf(index) - glm::dvec2(start_.x, start_.z);
  return withinTurn(degreesFromRadians(std::atan2(way.x, -way.y) - start_.headingRadians));
}

TrialLayout EstimatedObjects::layoutOf(int index, TrialView view, const PixelRect& place) const {
  TrialLayout layout;
  layout.scene = &scene_;
  const glm::dvec2 by = placeOf(index) - placeOf(0);
  layout.objectOffsets.emplace_back(by.x, 0, by.y);
  layout.views = camera_.views(start_, view, place);
  return layout;
}

void EstimatedObjects::checkShown(const TrialScreen& screen, const PixelRect& place, const std::string& where) const {
  for (int i = 0; i < caseCount(); ++i) {
    const std::string of = fmt::format("{}, case \"{}\"", where, caseOf(i).label);
    for (const TrialView view : conditions_.all()) {
      const TrialLayout layout = layoutOf(i, view, place);
      size_t pixels = 0;
      bool isCut = false;
      for (const TrialLayout::View& each : layout.views) {
        for (const ObjectSighting& seen : sightings(objectsIn(layout, each))) {
          pixels = std::max(pixels, seen.pixels);
          isCut = isCut || (layout.views.size() == 1 && seen.atBorder);
        }
      }
      if (pixels < kMinEstimatedPixels) {
        throw InputError(fmt::format("the view {} shows {} pixels of the object on a screen of {} x {}",
                                     conditions_.nameOf(view), pixels, screen.width, screen.height),
                         of, "move it to where all views show it, or change \"start\", \"portals\" or the maze");
      }
      if (isCut) {
        throw InputError(
            fmt::format("the border of the image of the view {} cuts off the object", conditions_.nameOf(view)), of,
            "move it farther away, or to the middle");
      }
    }
  }
}

InstructionExample estimateExample(TrialView view, const glm::ivec2& size) {
  Maze maze = mazeFromJsonText(R"({"plan": [
    "+-+-+-+-+-+",
    "|   |   | |",
    "+ +-+ +-+ +",
    "|         |",
    "+ + +-+ +-+",
    "| |   |   |",
    "+ +-+-+-+-+"]})",
                               "an example");
  maze.landmarks = {{{1, 3}, LandmarkShape::kSphere, LandmarkColor::kOrange, 0, 0.2f}};
  const glm::vec3 start = maze.centerOf({1, 0});
  const WalkerPose pose{static_cast<double>(start.x), static_cast<double>(start.z), radiansOf(Direction::kEast)};
  InstructionExample example{std::make_shared<StudyScene>(maze), {}};
  example.layout.scene = example.scene.get();
  example.layout.views = EyeCamera(maze, {}, {}).views(pose, view, wholeImage(size));
  return example;
}

}  // namespace ocelli
