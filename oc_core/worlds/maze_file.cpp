#include "oc_core/worlds/maze_file.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>

#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/worlds/landmark_solids.h"
#include "oc_core/worlds/maze_validate.h"

namespace ocelli {
namespace {

constexpr char kPost = '+';
constexpr char kEastWestWall = '-';
constexpr char kNorthSouthWall = '|';
constexpr char kFree = ' ';

/// Line 0 of the plan is the northern wall, and character 0 of each line the western one.
using Plan = std::vector<std::string>;

Plan readPlan(JsonFields& fields, const std::string& where) {
  constexpr size_t kMaxLines = 2 * kMaxMazeSide + 1;
  const nlohmann::json& value = fields.value("plan");
  if (!value.is_array()) {
    fields.fail("plan", "must be an array of texts, the lines of the drawing");
  }
  if (value.size() < 3 || value.size() % 2 == 0 || value.size() > kMaxLines) {
    fields.fail("plan", fmt::format("has {} lines; it must have two for each row of cells and one more, {} at most",
                                    value.size(), kMaxLines));
  }
  Plan plan;
  for (const nlohmann::json& line : value) {
    if (!line.is_string()) {
      fields.fail("plan", fmt::format("must be an array of texts, but line {} is not a text", plan.size() + 1));
    }
    plan.push_back(line.get<std::string>());
    const size_t width = plan.back().size();
    if (width < 3 || width % 2 == 0 || width > kMaxLines) {
      fields.fail("plan", fmt::format("has {} characters in line {}; they must be two for each column of cells and one "
                                      "more, {} at most",
                                      width, plan.size(), kMaxLines));
    }
    if (width != plan.front().size()) {
      fields.fail("plan", fmt::format("has {} characters in line {}, but {} in line 1", width, plan.size(),
                                      plan.front().size()));
    }
  }
  const auto expect = [&](size_t line, size_t i, const std::string& allowed, const std::string& what) {
    if (allowed.find(plan[line][i]) == std::string::npos) {
      throw InputError(fmt::format("character {} of line {} of the plan must be {}", i + 1, line + 1, what), where,
                       "draw posts as +, walls as - and |, passages and cells as spaces");
    }
  };
  for (size_t line = 0; line < plan.size(); ++line) {
    for (size_t i = 0; i < plan[line].size(); ++i) {
      if (line % 2 == 0 && i % 2 == 0) {
        expect(line, i, {kPost}, "a post '+'");
      } else if (line % 2 == 1 && i % 2 == 1) {
        expect(line, i, {kFree}, "a cell ' '");
      } else if (line % 2 == 0) {
        expect(line, i, {kEastWestWall, kFree}, "a wall '-' or a passage ' '");
      } else {
        expect(line, i, {kNorthSouthWall, kFree}, "a wall '|' or a passage ' '");
      }
    }
  }
  return plan;
}

/// Where the wall on that side of the cell is drawn.
std::array<size_t, 2> placeOf(const MazeCell& cell, Direction side) {
  const glm::vec3 step = vectorOf(side);
  return {static_cast<size_t>(2 * cell.row + 1 + static_cast<int>(step.z)),
          static_cast<size_t>(2 * cell.column + 1 + static_cast<int>(step.x))};
}

template <class Visit>
void forEachSide(const Maze& maze, const Visit& visit) {
  for (int row = 0; row < maze.rows(); ++row) {
    for (int column = 0; column < maze.columns(); ++column) {
      for (const Direction side : kDirections) {
        visit(MazeCell{row, column}, side);
      }
    }
  }
}

Maze mazeOfPlan(const Plan& plan, const std::string& where) {
  Maze maze(static_cast<int>(plan.size() / 2), static_cast<int>(plan.front().size() / 2));
  forEachSide(maze, [&](const MazeCell& cell, Direction side) {
    const auto [line, i] = placeOf(cell, side);
    const bool open = plan[line][i] == kFree;
    if (maze.contains(cell.neighbor(side))) {
      maze.setOpen(cell, side, open);
    } else if (open && maze.entrance) {
      throw InputError(
          fmt::format("the maze has two entrances, at the cells {} and {}", nameOf(maze.entrance->cell), nameOf(cell)),
          where, "leave one gap in the outer wall");
    } else if (open) {
      maze.entrance = {cell, opposite(side)};
    }
  });
  return maze;
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
  Maze maze = mazeOfPlan(readPlan(fields, where), where);
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
  Plan plan(static_cast<size_t>(2 * maze.rows() + 1), std::string(static_cast<size_t>(2 * maze.columns() + 1), kFree));
  for (size_t line = 0; line < plan.size(); line += 2) {
    for (size_t i = 0; i < plan[line].size(); i += 2) {
      plan[line][i] = kPost;
    }
  }
  forEachSide(maze, [&](const MazeCell& cell, Direction side) {
    const bool isGap = maze.entrance && maze.entrance->cell == cell && maze.entrance->heading == opposite(side);
    if (!maze.isOpen(cell, side) && !isGap) {
      const auto [line, i] = placeOf(cell, side);
      plan[line][i] = isEastWest(side) ? kNorthSouthWall : kEastWestWall;
    }
  });
  nlohmann::ordered_json json;
  json["plan"] = plan;
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
