#include "oc_core/worlds/maze_file.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <optional>
#include <vector>

#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/worlds/landmark_solids.h"
#include "oc_core/worlds/maze_validate.h"

namespace ocelli {
namespace {

Maze mazeOf(const MazeDrawing& drawing, const std::string& where) {
  if (drawing.gaps.size() > 1) {
    throw InputError(fmt::format("the maze has two entrances, at the cells {} and {}", nameOf(drawing.gaps[0].cell),
                                 nameOf(drawing.gaps[1].cell)),
                     where, "leave one gap in the outer wall");
  }
  Maze maze(drawing.plan);
  if (!drawing.gaps.empty()) {
    maze.entrance = drawing.gaps.front();
  }
  return maze;
}

Maze readPlan(JsonFields& fields, const std::string& where) {
  const nlohmann::json& value = fields.value("plan");
  if (!value.is_array()) {
    fields.fail("plan", "must be an array of texts, the lines of the drawing");
  }
  if (const auto fault = lineCountFault(value.size())) {
    fields.fail("plan", *fault);
  }
  std::vector<std::string> lines;
  for (const nlohmann::json& line : value) {
    if (!line.is_string()) {
      break;
    }
    lines.push_back(line.get<std::string>());
  }
  if (const auto fault = lineLengthFault(lines)) {
    fields.fail("plan", *fault);
  }
  if (lines.size() < value.size()) {
    fields.fail("plan", fmt::format("must be an array of texts, but line {} is not a text", lines.size() + 1));
  }
  return mazeOf(readDrawing(lines, where), where);
}

template <class Choice, size_t kCount>
Choice readChoice(JsonFields& fields, const std::string& name, const std::array<Choice, kCount>& choices,
                  std::optional<Choice> otherwise = std::nullopt) {
  if (otherwise && !fields.has(name)) {
    return *otherwise;
  }
  const std::string given = fields.text(name);
  std::string allowed;
  for (const Choice choice : choices) {
    if (given == nameOf(choice)) {
      return choice;
    }
    allowed += (allowed.empty() ? "" : ", ") + std::string(nameOf(choice));
  }
  fields.fail(name, "must be one of " + allowed);
}

Landmark readLandmark(const nlohmann::json& value, const std::string& where) {
  JsonFields fields(value, where);
  Landmark landmark;
  landmark.cell.row = fields.integer("row", 0, kMaxMazeSide - 1);
  landmark.cell.column = fields.integer("column", 0, kMaxMazeSide - 1);
  landmark.shape = readChoice(fields, "shape", kLandmarkShapes);
  landmark.color = readChoice<LandmarkColor>(fields, "color", kLandmarkColors, Landmark().color);
  landmark.east = static_cast<float>(fields.number("east", -0.5, 0.5, 0));
  landmark.south = static_cast<float>(fields.number("south", -0.5, 0.5, 0));
  fields.rejectUnknown();
  return landmark;
}

std::vector<Landmark> readLandmarks(JsonFields& fields, const std::string& where) {
  std::vector<Landmark> landmarks;
  if (!fields.has("landmarks")) {
    return landmarks;
  }
  const nlohmann::json& list = fields.value("landmarks");
  constexpr size_t kMax = static_cast<size_t>(kMaxMazeSide) * kMaxMazeSide;
  if (!list.is_array() || list.size() > kMax) {
    fields.fail("landmarks", fmt::format("must be an array of at most {} landmarks", kMax));
  }
  for (const nlohmann::json& value : list) {
    landmarks.push_back(readLandmark(value, fmt::format("{}, landmark {}", where, landmarks.size() + 1)));
  }
  return landmarks;
}

/// The shortest decimal number that gives the float again.
double shortest(float value) {
  const std::string text = fmt::format("{}", value);
  double decimal = 0;
  std::from_chars(text.data(), text.data() + text.size(), decimal);
  return decimal;
}

}  // namespace

Maze readMaze(JsonFields& fields) {
  const std::string& where = fields.where();
  Maze maze = readPlan(fields, where);
  maze.cellSize = static_cast<float>(fields.number("cell_size", 0.1, 100, maze.cellSize));
  maze.wallHeight = static_cast<float>(fields.number("wall_height", 0.1, 100, maze.wallHeight));
  maze.wallThickness = static_cast<float>(fields.number("wall_thickness", 0.01, 50, maze.wallThickness));
  maze.landmarks = readLandmarks(fields, where);
  fields.rejectUnknown();
  validate(maze, where);
  return maze;
}

Maze mazeFromJsonText(const std::string& text, const std::string& where) {
  return readAs("oc_core/worlds/maze.schema.json", [&] {
    const nlohmann::json json = parseJson(text, where);
    JsonFields fields(json, where);
    return readMaze(fields);
  });
}

Maze readMaze(const std::filesystem::path& path) {
  return mazeFromJsonText(readFile(path, kMaxTextBytes), path.string());
}

std::string jsonText(const Maze& maze) {
  MazeDrawing drawing{maze};
  if (maze.entrance) {
    drawing.gaps.push_back(*maze.entrance);
  }
  nlohmann::ordered_json json;
  json["plan"] = linesOf(drawing);
  json["cell_size"] = shortest(maze.cellSize);
  json["wall_height"] = shortest(maze.wallHeight);
  json["wall_thickness"] = shortest(maze.wallThickness);
  json["landmarks"] = nlohmann::ordered_json::array();
  for (const Landmark& landmark : maze.landmarks) {
    json["landmarks"].push_back({{"row", landmark.cell.row},
                                 {"column", landmark.cell.column},
                                 {"shape", nameOf(landmark.shape)},
                                 {"color", nameOf(landmark.color)},
                                 {"east", shortest(landmark.east)},
                                 {"south", shortest(landmark.south)}});
  }
  return textOfJson(json, 2) + "\n";
}

}  // namespace ocelli
