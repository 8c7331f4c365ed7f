#include "study/task/task_fields.h"

#include <fmt/format.h>

#include <cmath>
#include <set>

#include "oc_core/base/conventions.h"
#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/constructor/maze_options.h"
#include "oc_core/worlds/landmark_solids.h"

namespace ocelli {
namespace {

constexpr size_t kMaxCases = 1000;

}  // namespace

const Maze& readMazeOf(JsonFields& fields, const TaskSetting& setting) {
  const std::string name = fields.text("maze");
  const auto found = setting.mazes.find(name);
  if (found == setting.mazes.end()) {
    std::string names;
    for (const auto& [each, maze] : setting.mazes) {
      names += fmt::format("{}{}", names.empty() ? "" : ", ", each);
    }
    fields.fail("maze", fmt::format("is \"{}\", but the mazes of this protocol are: {}", name, names));
  }
  const Maze& maze = found->second;
  const double clear = static_cast<double>(maze.cellSize) - static_cast<double>(maze.wallThickness);
  const Controls& controls = setting.controls;
  if (2 * controls.bodyRadiusMeters > 0.95 * clear) {
    fields.fail("maze", fmt::format("has passages {:g} m wide, too narrow for a body of {:g} m on either side: change "
                                    "\"body_radius_meters\" of the controls, or the maze",
                                    clear, controls.bodyRadiusMeters));
  }
  if (controls.eyeHeightMeters >= static_cast<double>(maze.wallHeight)) {
    fields.fail("maze",
                fmt::format("has walls of {:g} m, lower than the eye at {:g} m: change \"eye_height_meters\" of "
                            "the controls, or the maze",
                            maze.wallHeight, controls.eyeHeightMeters));
  }
  return maze;
}

MazeCell readCell(JsonFields& fields, const Maze& maze) {
  return {fields.integer("row", 0, maze.rows() - 1), fields.integer("column", 0, maze.columns() - 1)};
}

Direction readHeading(JsonFields& fields) {
  const std::optional<Direction> heading = readDirection(fields, "heading");
  return heading ? *heading : (fields.fail("heading", "is missing"), Direction::kNorth);
}

double radiansOf(Direction heading) {
  const glm::vec3 way = vectorOf(heading);
  return std::atan2(static_cast<double>(way.x), static_cast<double>(-way.z));
}

WalkerPose readStart(JsonFields& fields, const Maze& maze) {
  MazeCell cell = maze.entrance->cell;
  Direction heading = maze.entrance->heading;
  if (fields.has("start")) {
    JsonFields start = fields.inner("start");
    cell = readCell(start, maze);
    heading = readHeading(start);
    start.rejectUnknown();
  }
  const glm::vec3 place = maze.centerOf(cell);
  return {static_cast<double>(place.x), static_cast<double>(place.z), radiansOf(heading)};
}

ObjectLook readObjectLook(JsonFields& fields, bool withColor) {
  ObjectLook look;
  if (!fields.has("object")) {
    return look;
  }
  JsonFields object = fields.inner("object");
  look.shape = object.choiceOf("shape", kLandmarkShapes, look.shape);
  if (look.shape == LandmarkShape::kArch) {
    object.fail("shape", "is \"arch\", which spans a passage; the others stand on the floor");
  }
  if (withColor) {
    look.color = object.choiceOf("color", kLandmarkColors, look.color);
  }
  object.rejectUnknown();
  return look;
}

std::optional<double> readMoving(JsonFields& fields) {
  if (!fields.has("moving")) {
    return std::nullopt;
  }
  JsonFields moving = fields.inner("moving");
  const double speed = moving.number("meters_per_second", 0.01, 20);
  moving.rejectUnknown();
  return speed;
}

void readCases(JsonFields& fields, const std::string& caseField,
               const std::function<void(JsonFields& fields, const std::string& label)>& read) {
  std::set<std::string> labels;
  fields.forEach(
      caseField, 1, kMaxCases,
      [&](JsonFields& each) {
        const std::string label = each.text("label", fmt::format("case {}", labels.size() + 1));
        if (label.empty() || !labels.insert(label).second) {
          each.fail("label", fmt::format("is \"{}\", but must be a text that no other case of the block has", label));
        }
        // The protocol reads these: tasks know nothing of factors and staircases.
        each.has("factors");
        each.has("level");
        read(each, label);
      },
      "cases");
}

std::string placeName(const MazeCell& cell) {
  return fmt::format("row {}, column {}", cell.row, cell.column);
}

int64_t ticksOf(double seconds) {
  return std::llround(seconds * static_cast<double>(kTicksPerSecond));
}

}  // namespace ocelli
