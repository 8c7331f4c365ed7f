// What the tasks read alike from the fields of a block. All of these throw InputError naming the field.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "study/task/task.h"

namespace ocelli {

class JsonFields;

/// The maze that the field "maze" names. Throws as well where the body of the controls does not fit into it.
const Maze& readMazeOf(JsonFields& fields, const TaskSetting& setting);
/// The fields "row" and "column": a cell of the maze.
MazeCell readCell(JsonFields& fields, const Maze& maze);
/// The field "heading": north, east, south or west.
Direction readHeading(JsonFields& fields);
double radiansOf(Direction heading);
/// The field "start": a cell and a heading; those of the entrance where it is missing.
WalkerPose readStart(JsonFields& fields, const Maze& maze);
/// The field "object": its shape, and its colour.
struct ObjectLook {
  LandmarkShape shape = LandmarkShape::kSphere;
  LandmarkColor color = LandmarkColor::kOrange;
};
ObjectLook readObjectLook(JsonFields& fields, bool withColor);
/// Metres a second of the field "moving"; nothing where it is missing: objects that stand.
std::optional<double> readMoving(JsonFields& fields);
/// Calls `read` for each case of the field, of which there is one at least, and with its label, which is unique.
void readCases(JsonFields& fields, const std::string& caseField,
               const std::function<void(JsonFields& fields, const std::string& label)>& read);
/// "(row 2, column 5)" without brackets: "row 2, column 5".
std::string placeName(const MazeCell& cell);
int64_t ticksOf(double seconds);

}  // namespace ocelli
