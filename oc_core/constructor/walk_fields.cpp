#include "oc_core/constructor/walk_fields.h"

#include <fmt/format.h>

#include <cmath>

#include "oc_core/base/conventions.h"
#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/constructor/camera_fields.h"
#include "oc_core/constructor/walk_from_maze.h"
#include "oc_core/constructor/walk_start.h"
#include "oc_core/walkable/walk_map_file.h"
#include "oc_core/walkable/walkable.h"

namespace ocelli {
namespace {

constexpr int kMaxCells = 1000000;

}  // namespace

std::optional<WalkMap> readWays(JsonFields& fields, const GuidedScene& scene) {
  if (!fields.has("ways")) {
    return std::nullopt;
  }
  return moved(readWalkMap(fields.text("ways")), scene.worldFromScene);
}

WalkMap walkMapFor(const GuidedScene& scene, std::optional<WalkMap> given) {
  if (given) {
    return *std::move(given);
  }
  if (scene.guides.maze) {
    return walkMapOf(*scene.guides.maze);
  }
  return scene.guides.walk ? *scene.guides.walk : findWalkMap(scene.mesh, inUnits({}, metreOf("", scene).units));
}

std::optional<glm::dvec3> readHeadingDegrees(JsonFields& fields) {
  if (!fields.has("heading_degrees")) {
    return std::nullopt;
  }
  const double angle = radiansFromDegrees(fields.number("heading_degrees", -360, 360));
  return glm::dvec3(std::sin(angle), 0, -std::cos(angle));
}

WalkStartFields readWalkStart(JsonFields& fields) {
  WalkStartFields start;
  if (fields.has("start_cell")) {
    start.cell = static_cast<uint32_t>(fields.integer("start_cell", 0, kMaxCells));
  }
  if (fields.has("start_point")) {
    start.point = readVector(fields, "start_point");
  }
  start.heading = readHeadingDegrees(fields);
  return start;
}

std::optional<WalkStart> walkStartOf(const WalkMap& map, const WalkStartFields& fields) {
  constexpr const char* kWhere = "comprehensive camera";
  std::optional<uint32_t> cell = fields.cell;
  if (fields.point) {
    // A point on the floor may lie a little below it.
    const WalkSpace space(map);
    const std::optional<uint32_t> region = space.regionAt(*fields.point + glm::dvec3(0, 0.05 * space.size(), 0));
    if (!region) {
      throw InputError(
          fmt::format("no cell lies at the start ({}, {}, {})", fields.point->x, fields.point->y, fields.point->z),
          kWhere, "give a point on walkable floor, in the units of the scene as it is drawn");
    }
    cell = space.regions()[*region].cell;
  }
  if (!cell) {
    if (fields.heading) {
      throw InputError("the heading is given without a start", kWhere, "give a \"start_cell\" or a \"start_point\"");
    }
    return std::nullopt;
  }
  if (*cell >= map.cells.size()) {
    throw InputError("there is no " + nameOfCell(*cell), kWhere,
                     fmt::format("cells are 0 to {}", map.cells.size() - 1));
  }
  return fields.heading ? WalkStart{*cell, *fields.heading} : chooseWalkSide(map, walkBoxesOf(map), *cell);
}

}  // namespace ocelli
