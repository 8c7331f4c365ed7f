// Walks for tests: where someone stands and looks, frame after frame.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <vector>

#include "oc_core/base/conventions.h"
#include "oc_core/base/random.h"
#include "oc_core/camera/view.h"
#include "oc_core/scene/maze.h"

namespace ocelli::test {

inline constexpr float kEyeHeight = 1.5f;  ///< metres above the floor

inline View viewAt(const glm::vec3& eye, const glm::vec2& heading) {
  View view;
  view.eye = eye;
  view.target = eye + glm::vec3(heading.x, 0, heading.y);
  view.fovVerticalDegrees = 60;
  view.zFar = 200;
  return view;
}

/// A person on a polyline in the plan, (x, z): goes on by `stepMetres` a frame, looks at what comes a metre ahead, and
/// turns by at most `stepDegrees` a frame, standing while what is ahead is more than 30 degrees aside.
inline std::vector<View> walkAlong(const std::vector<glm::vec2>& line, float floor, float stepMetres,
                                   float stepDegrees) {
  std::vector<float> lengths{0};
  for (size_t i = 1; i < line.size(); ++i) {
    lengths.push_back(lengths.back() + glm::distance(line[i - 1], line[i]));
  }
  const auto at = [&](float length) {
    size_t i = 1;
    while (i + 1 < line.size() && lengths[i] < length) {
      ++i;
    }
    const float share = (length - lengths[i - 1]) / (lengths[i] - lengths[i - 1]);
    return line[i - 1] + (line[i] - line[i - 1]) * std::clamp(share, 0.0f, 1.0f);
  };
  std::vector<View> views;
  glm::vec2 heading = glm::normalize(line[1] - line[0]);
  for (float length = 0; length < lengths.back() - 1;) {
    const glm::vec2 place = at(length);
    const glm::vec2 ahead = at(length + 1) - place;
    const float aside = std::atan2(heading.x * ahead.y - heading.y * ahead.x, glm::dot(heading, ahead));
    const float most = static_cast<float>(radiansFromDegrees(stepDegrees));
    const float turn = std::clamp(aside, -most, most);
    heading = glm::normalize(glm::vec2(heading.x * std::cos(turn) - heading.y * std::sin(turn),
                                       heading.x * std::sin(turn) + heading.y * std::cos(turn)));
    length += std::abs(aside) > static_cast<float>(kPi) / 6 ? 0 : stepMetres;
    const glm::vec2 stand = at(length);
    views.push_back(viewAt({stand.x, floor + kEyeHeight, stand.y}, heading));
  }
  return views;
}

/// Through so many cells of a maze, turning back at dead ends alone, somewhat beside the middle of the corridors.
inline std::vector<glm::vec2> randomLine(const Maze& maze, size_t cells, Random& random) {
  MazeCell cell{static_cast<int>(random.below(static_cast<size_t>(maze.rows()))),
                static_cast<int>(random.below(static_cast<size_t>(maze.columns())))};
  std::vector<glm::vec2> line;
  std::optional<Direction> heading;
  for (size_t i = 0; i < cells; ++i) {
    const glm::vec3 center = maze.centerOf(cell);
    const float aside = 0.12f * maze.cellSize;
    const float x = random.inRange(-aside, aside);
    line.emplace_back(center.x + x, center.z + random.inRange(-aside, aside));
    std::vector<Direction> ways = maze.passages(cell);
    if (heading && ways.size() > 1) {
      std::erase(ways, opposite(*heading));
    }
    heading = ways[random.below(ways.size())];
    cell = cell.neighbor(*heading);
  }
  return line;
}

}  // namespace ocelli::test
