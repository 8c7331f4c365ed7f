#include "study/task/pinhole_matrix.h"

#include <fmt/format.h>

#include <cmath>

#include "oc_core/base/conventions.h"
#include "oc_core/base/json_fields.h"
#include "study/task/task_fields.h"
#include "study/task/task_layout.h"

namespace ocelli {
namespace {

constexpr double kGap = 0.01;  // between views, of the height of all

glm::vec3 eyeOf(const MatrixView& view, const Maze& maze) {
  return maze.centerOf(view.cell) +
         glm::vec3(glm::dvec3(view.east, 0, view.south) * static_cast<double>(maze.cellSize)) +
         glm::vec3(0, static_cast<float>(view.heightMeters), 0);
}

/// Its name, or degrees.
double readHeadingDegrees(JsonFields& fields) {
  return fields.has("heading") && fields.value("heading").is_number()
             ? fields.number("heading", -360, 360)
             : degreesFromRadians(radiansOf(readHeading(fields)));
}

MatrixView readView(JsonFields& fields, const Maze& maze) {
  MatrixView view;
  view.cell = readCell(fields, maze);
  view.east = fields.number("east", -0.5, 0.5, view.east);
  view.south = fields.number("south", -0.5, 0.5, view.south);
  view.heightMeters = fields.number("height_meters", 0.01, 1000, view.heightMeters);
  view.headingDegrees = readHeadingDegrees(fields);
  view.pitchDegrees = fields.number("pitch_degrees", -89, 89, view.pitchDegrees);
  view.fovHorizontalDegrees = fields.number("fov_horizontal_degrees", 10, 150, view.fovHorizontalDegrees);
  fields.rejectUnknown();
  const glm::vec3 eye = eyeOf(view, maze);
  if (eye.y <= maze.origin.y + maze.wallHeight && maze.isInWall(eye)) {
    fields.fail("east", "puts the eye into a wall: move it, or raise \"height_meters\"");
  }
  return view;
}

}  // namespace

PinholeMatrix readPinholeMatrix(JsonFields& fields, const Maze& maze) {
  PinholeMatrix matrix;
  matrix.rows = fields.integer("rows", 1, 10);
  matrix.columns = fields.integer("columns", 1, 10);
  fields.forEach(
      "views", 1, static_cast<size_t>(matrix.rows * matrix.columns),
      [&](JsonFields& each) { matrix.views.push_back(readView(each, maze)); },
      "views, as many as there are rows and columns");
  fields.rejectUnknown();
  return matrix;
}

std::vector<Vantage::Pane> panesOf(const PinholeMatrix& matrix, const Maze& maze, const PixelRect& area) {
  const std::vector<PixelRect> places = gridOf(area, matrix.rows, matrix.columns, kGap);
  std::vector<Vantage::Pane> panes;
  for (size_t i = 0; i < matrix.views.size(); ++i) {
    const MatrixView& of = matrix.views[i];
    const glm::ivec2 size = sizeOf(places[i]);
    const double heading = radiansFromDegrees(of.headingDegrees);
    const double pitch = radiansFromDegrees(of.pitchDegrees);
    View view;
    view.eye = eyeOf(of, maze);
    view.target = view.eye + glm::vec3(glm::dvec3(std::cos(pitch) * std::sin(heading), std::sin(pitch),
                                                  -std::cos(pitch) * std::cos(heading)));
    const double tangent = std::tan(radiansFromDegrees(of.fovHorizontalDegrees) / 2);
    view.fovVerticalDegrees = degreesFromRadians(2 * std::atan(tangent * size.y / size.x));
    view.zNear = 0.02f * maze.cellSize;
    view.zFar = maze.cellSize * static_cast<float>(4 * (maze.rows() + maze.columns()));
    panes.push_back({places[i], PinholeCamera(view, size.x, size.y)});
  }
  return panes;
}

}  // namespace ocelli
