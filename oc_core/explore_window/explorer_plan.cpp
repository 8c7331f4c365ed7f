#include "oc_core/explore_window/explorer_plan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include "oc_core/base/conventions.h"
#include "oc_core/explore/explore_picking.h"
#include "oc_core/image/color.h"
#include "oc_core/multiperspective/plan_side.h"
#include "oc_core/render/rasterize.h"

namespace ocelli {
namespace {

constexpr int kGroundPixels = 1024;     // of its longer side
constexpr float kGroundDistance = 300;  // sizes of the scene, from which it is seen
constexpr float kGroundBorder = 0.02f;  // of its size, around it
const Rgb8 kNoGround(20, 21, 23);       // kGuiBackground
constexpr float kGroundLight = 0.4f;    // of its colours

glm::vec2 planPointOf(const glm::vec3& point) {
  return onPaper(PlanSide::kTop, point);
}

/// Along the right wall of a tunnel from its beginning to its end, and back along the left one.
std::vector<glm::vec2> tunnelOutline(const WalkCell& cell) {
  const glm::vec3 start = cell.center - cell.axis * cell.halfLength;
  std::vector<glm::vec2> outline;
  for (const WalkRing& ring : cell.rings) {
    outline.push_back(planPointOf(start + cell.axis * ring.along + cell.right() * ring.right));
  }
  for (auto ring = cell.rings.rbegin(); ring != cell.rings.rend(); ++ring) {
    outline.push_back(planPointOf(start + cell.axis * ring->along - cell.right() * ring->left));
  }
  return outline;
}

std::vector<glm::vec2> boxOutline(const WalkCell& cell) {
  const glm::vec3 along = cell.axis * cell.halfLength;
  const glm::vec3 across = cell.right() * cell.halfWidth;
  return {planPointOf(cell.center - along - across), planPointOf(cell.center + along - across),
          planPointOf(cell.center + along + across), planPointOf(cell.center - along + across)};
}

}  // namespace

WindowGround groundBelow(const ExploreScene& scene, float cut) {
  const Box& bounds = scene.bounds();
  const glm::vec3 extent = bounds.upper - bounds.lower;
  const glm::vec2 border(kGroundBorder * std::max(extent.x, extent.z));
  WindowGround ground{{}, planPointOf(bounds.lower) - border, planPointOf(bounds.upper) + border};
  const glm::vec2 size = ground.upper - ground.lower;
  const float scale = static_cast<float>(kGroundPixels) / std::max(size.x, size.y);
  const int width = std::max(1, static_cast<int>(size.x * scale));
  const int height = std::max(1, static_cast<int>(size.y * scale));
  const float distance = kGroundDistance * std::max(glm::length(extent), std::max(size.x, size.y));
  const glm::vec2 middle = (ground.lower + ground.upper) * 0.5f;
  View view;
  view.target = {middle.x, cut, middle.y};
  view.eye = view.target + glm::vec3(0, distance, 0);
  view.up = {0, 0, -1};
  view.fovVerticalDegrees = 2 * degreesFromRadians(std::atan(static_cast<double>(size.y) / 2 / distance));
  view.zNear = distance;
  view.zFar = distance + 2 * glm::length(extent);
  const PinholeCamera camera(view, width, height);
  const FragmentImage fragments = rasterize(camera, scene.mesh());
  Image<glm::vec3> light = colorImage(fragments, scene.mesh(), glm::vec3(0));
  for (glm::vec3& pixel : light) {
    // Paler as well as darker: colours belong to frusta.
    const float grey = glm::dot(pixel, glm::vec3(0.2126f, 0.7152f, 0.0722f));
    pixel = glm::mix(glm::vec3(grey), pixel, 0.5f) * kGroundLight;
  }
  ground.image = srgbFromLinear(light);
  for (size_t i = 0; i < fragments.size(); ++i) {
    if (!fragments[i].covered()) {
      ground.image[i] = kNoGround;
    }
  }
  return ground;
}

std::vector<WindowPlan::Cell> planCells(const WalkMap& map) {
  std::vector<WindowPlan::Cell> cells;
  for (const WalkCell& cell : map.cells) {
    const bool isTunnel = cell.kind == WalkCellKind::kTunnel;
    cells.push_back({isTunnel && cell.rings.size() >= 2 ? tunnelOutline(cell) : boxOutline(cell), isTunnel});
  }
  return cells;
}

std::vector<WindowPlan::Opening> planOpenings(const ExploreScene& scene) {
  // Both sides of an opening are one line.
  const auto isBefore = [](const glm::vec2& a, const glm::vec2& b) {
    return std::pair(a.x, a.y) < std::pair(b.x, b.y);
  };
  const auto orderOf = [](const WindowPlan::Opening& opening) {
    return std::array{opening[0].x, opening[0].y, opening[1].x, opening[1].y};
  };
  std::vector<WindowPlan::Opening> openings;
  for (const Portal& portal : knownPortals(scene)) {
    WindowPlan::Opening opening{planPointOf(portal.center - portal.halfRight),
                                planPointOf(portal.center + portal.halfRight)};
    if (isBefore(opening[1], opening[0])) {
      std::swap(opening[0], opening[1]);
    }
    openings.push_back(opening);
  }
  std::ranges::sort(openings, {}, orderOf);
  const auto again = std::ranges::unique(openings);
  openings.erase(again.begin(), again.end());
  return openings;
}

std::vector<glm::vec2> planPath(const ExploreScene& scene) {
  std::vector<glm::vec2> path;
  std::ranges::transform(scene.guides().path, std::back_inserter(path), planPointOf);
  return path;
}

WindowPlan planOfExplorer(const Explorer& explorer) {
  const ExploreFrame& frame = explorer.frame();
  WindowPlan plan;
  plan.walker = planPointOf(glm::vec3(frame.walker.eye));
  plan.heading = planPointOf(glm::vec3(headingOf(frame.walker)));
  for (const ExploreFootprint& footprint : frame.footprints) {
    plan.frusta.push_back({footprint.corners, footprint.viewpoint, footprint.bends ? footprint.part : 0});
  }
  if (const std::optional<Box> box = explorer.picked(); box && !box->empty()) {
    plan.picked = {planPointOf(box->lower), planPointOf({box->upper.x, 0, box->lower.z}), planPointOf(box->upper),
                   planPointOf({box->lower.x, 0, box->upper.z})};
  }
  return plan;
}

}  // namespace ocelli
