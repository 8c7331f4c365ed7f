#include "oc_core/walkable/walkable.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "oc_core/base/conventions.h"
#include "oc_core/base/error.h"
#include "oc_core/walkable/walk_cells.h"
#include "oc_core/walkable/walk_columns.h"
#include "oc_core/walkable/walk_direction.h"
#include "oc_core/walkable/walk_furniture.h"
#include "oc_core/walkable/walk_links.h"
#include "oc_core/walkable/walk_obstacles.h"
#include "oc_core/walkable/walk_portals.h"
#include "oc_core/walkable/walk_reach.h"
#include "oc_core/walkable/walk_rectangles.h"
#include "oc_core/walkable/walk_rooms.h"
#include "oc_core/walkable/walk_width.h"

namespace ocelli {
namespace {

constexpr const char* kWalkable = "walkable floor";
constexpr uint16_t kWidestPlace = 1024;  // steps to the border: places wider than 2,047 squares are as wide as that
constexpr double kMaxRadius = 30000;     // squares: fields have kMaxWalkColumns, so floor as wide as that never is
constexpr double kMaxHeights = 8000;     // Recast's height fields have 8,191

void requireRange(const WalkOptions& options, double unitsOfScene) {
  for (const WalkOption& option : walkOptionTable()) {
    const double value = options.*option.value;
    const bool isPositive = option.isLength ? value > 0 || option.min == 0 : value >= option.min;
    if (!std::isfinite(value) || !isPositive || value < 0 || (!option.isLength && value > option.max)) {
      throw InputError(fmt::format("{} is {:.6g}", option.name, value), kWalkable,
                       fmt::format("give {}: {:.6g} to {:.6g}{}", option.meaning, option.min, option.max,
                                   option.isLength ? " metres" : ""));
    }
  }
  if (options.agentHeight < 1.5 * options.cellSize) {
    throw InputError(fmt::format("the agent is {:.6g} high, and squares of the height field are {:.6g}",
                                 options.agentHeight, options.cellSize),
                     kWalkable, "give smaller squares: two thirds of the agent's height at most");
  }
  if (options.agentHeight > 1e3 * unitsOfScene) {
    throw InputError(
        fmt::format("the agent is {:.6g} high, and the scene is {:.6g} large", options.agentHeight, unitsOfScene),
        kWalkable, "say how long a metre is in the scene (--metre)");
  }
}

/// The size of squares that the height field can have.
float possibleCellSize(const Box& box, double wanted) {
  const glm::dvec3 size(box.size());
  double cell = std::max(wanted, 2 * size.y / kMaxHeights);
  while ((size.x / cell + 4) * (size.z / cell + 4) > kMaxWalkColumns) {
    cell *= 1.02;
  }
  return static_cast<float>(cell);
}

void turn(WalkMap& map, double angle) {
  const auto c = static_cast<float>(std::cos(angle));
  const auto s = static_cast<float>(std::sin(angle));
  const auto turned = [&](const glm::vec3& p) { return glm::vec3(c * p.x + s * p.z, p.y, -s * p.x + c * p.z); };
  for (WalkCell& cell : map.cells) {
    cell.center = turned(cell.center);
    cell.axis = turned(cell.axis);
  }
  for (WalkPortal& portal : map.portals) {
    portal.opening.center = turned(portal.opening.center);
    portal.opening.normal = turned(portal.opening.normal);
    portal.opening.halfRight = turned(portal.opening.halfRight);
  }
}

WalkField standingField(const Mesh& mesh, WalkRaster raster, WalkSurvey& survey, WalkColumns& columns,
                        const Progress& progress) {
  for (const bool bothSides : {false, true}) {
    raster.bothSides = bothSides;
    columns = rasterizedColumns(mesh, raster, progress);
    report(progress, "find floors", 0);
    WalkField field = fieldOf(columns, raster.agentHeight, raster.stepHeight);
    if (!field.squares.empty()) {
      if (bothSides) {
        survey.notes.emplace_back("all floors of the scene face downwards: both of their sides were taken as floors");
      }
      return field;
    }
  }
  throw InputError(fmt::format("the scene has no floor: no triangle that is flatter than {:.3g} degrees has {:.4g} of "
                               "free height over it",
                               raster.slopeDegrees, raster.agentHeight),
                   kWalkable, "look at the units and at which way is up (y), or give a lower agent");
}

}  // namespace

WalkSurvey surveyWalkable(const Mesh& mesh, const WalkOptions& options, const Progress& progress) {
  const Box bounds = boundsOf(mesh);
  const glm::vec3 size = bounds.size();
  requireRange(options, std::max({size.x, size.y, size.z}));
  WalkSurvey survey;
  // Often, as whoever waits for it may have gone meanwhile: then this throws.
  const auto finds = [&](double fraction) { report(progress, "find ways", fraction); };
  report(progress, "find walls", 0);
  const double angle = wallDirection(mesh);
  report(progress, "find walls", 0.5);
  survey.directionDegrees = degreesFromRadians(angle);
  const Mesh aligned = turnedAboutVertical(mesh, -angle);
  WalkRaster raster;
  raster.cellSize = possibleCellSize(boundsOf(aligned), options.cellSize);
  raster.slopeDegrees = static_cast<float>(options.slopeDegrees);
  raster.stepHeight = static_cast<float>(options.stepHeight);
  raster.agentHeight = static_cast<float>(options.agentHeight);
  survey.cellSize = raster.cellSize;
  if (raster.cellSize > options.cellSize * 1.001) {
    survey.notes.push_back(fmt::format(
        "the scene is large: its height field has squares of {:.3g} instead of {:.3g}, so narrow doors may be missing",
        raster.cellSize, options.cellSize));
  }
  report(progress, "find walls", 1);
  WalkColumns columns;
  const WalkField standing = standingField(aligned, raster, survey, columns, progress);
  finds(0);
  const double squares = std::floor(options.agentRadius / raster.cellSize - 0.5 + 1e-6);
  const int radius = static_cast<int>(std::clamp(squares, 1.0, kMaxRadius));
  WalkReach reach = reachOf(standing, radius, options.partShare);
  if (reach.field.squares.empty()) {
    throw InputError(fmt::format("no floor of the scene is wide enough for the agent: {:.4g} of floor are narrower "
                                 "than {:.4g}",
                                 reach.tooNarrowArea, static_cast<float>(2 * radius + 1) * raster.cellSize),
                     kWalkable, "give a smaller agent or smaller squares, or look at the units of the scene");
  }
  survey.floorArea = reach.field.area();
  survey.tooNarrowArea = reach.tooNarrowArea;
  survey.smallPartsArea = reach.smallPartsArea;
  survey.smallParts = reach.smallParts;
  finds(0.3);
  reach.field = seenOverFurniture(reach.field, columns, raster.agentHeight, raster.stepHeight);
  columns = {};
  finds(0.4);
  const WalkField field = overlookObstacles(reach.field, raster.agentHeight, kWidestPlace);
  reach.field = {};
  finds(0.5);
  std::vector<uint16_t> steps = stepsToBorder(field);
  finds(0.55);
  const std::vector<uint16_t> half = halfWidths(field, std::move(steps), kWidestPlace);
  finds(0.6);
  const auto smallest =
      static_cast<size_t>(std::min(std::pow(options.agentHeight / raster.cellSize / 2, 2), kMaxWalkColumns));
  const WalkAreas areas = areasOf(field, half, radius, smallest);
  finds(0.65);
  const WalkLayout strips = layoutOf(field, areas, radius);
  finds(0.7);
  const WalkLayout rectangles = rectangularLayout(field, strips, radius);
  finds(0.8);
  const JointSearch joints{field, half, raster.agentHeight};
  const WalkLayout layout = mergedLayout(joints, rectangles);
  finds(0.9);
  survey.map.cells = cellsOf(field, layout, raster.agentHeight);
  finds(0.95);
  survey.map.portals = portalsOf(field, layout, roomsOf(joints, layout), survey.map.cells, radius);
  dissolveShortTunnels(survey.map, raster.agentHeight / 2);
  numberCells(survey.map);
  // Cells end where an agent would touch a wall or what stands along it: beds, sofas, hedges.
  survey.map.toWalls = static_cast<float>(2 * options.agentHeight);
  turn(survey.map, angle);
  finds(1);
  return survey;
}

WalkMap findWalkMap(const Mesh& mesh, const WalkOptions& options, const Progress& progress) {
  return surveyWalkable(mesh, options, progress).map;
}

std::vector<std::string> findWays(const std::string& source, GuidedScene& scene, const Progress& progress) {
  if (scene.guides.walk) {
    return {};
  }
  const SceneMetre metre = metreOf(source, scene);
  WalkSurvey survey = surveyWalkable(scene.mesh, inUnits({}, metre.units), progress);
  if (!metre.isKnown) {
    survey.notes.push_back(fmt::format("a metre was taken to be {:.4g} units of {}", metre.units, source));
  }
  scene.guides.walk = std::move(survey.map);
  return survey.notes;
}

}  // namespace ocelli
