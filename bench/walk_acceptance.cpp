#include "bench/walk_acceptance.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "bench/timing.h"
#include "oc_core/constructor/walk_sight.h"
#include "oc_core/render/raycast.h"
#include "oc_core/walkable/walkable.h"
#include "oc_core/worlds/city_plan.h"
#include "oc_core/worlds/house_plan.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli::bench {
namespace {

constexpr float kOnFloor = 0.3f;  // metres: what is as near to a cell's floor is its floor; kerbs and rugs are

/// Of each cell the pixels that show its middle.
std::vector<size_t> pixelsOfMiddles(const WalkMap& map, const GraphCamera& camera, const Mesh& mesh) {
  const FragmentImage image = raycast(camera, mesh, RayScene(mesh));
  std::vector<size_t> pixels(map.cells.size());
  for (size_t i = 0; i < image.size(); ++i) {
    if (!image[i].covered()) {
      continue;
    }
    const glm::vec3 point = positionOf(image[i], mesh);
    for (size_t cell = 0; cell < map.cells.size(); ++cell) {
      pixels[cell] += isOverMiddle(map.cells[cell], point, kOnFloor) ? 1 : 0;
    }
  }
  return pixels;
}

WalkScene walkSceneOf(std::string source, WalkMap known) {
  Mesh mesh = loadScene(source, {.fit = false});
  return {std::move(source), std::move(mesh), std::move(known)};
}

}  // namespace

WalkScene cityToWalk(uint64_t seed, float size) {
  return walkSceneOf("builtin:city,seed=" + std::to_string(seed) + ",size=" + std::to_string(std::lround(size)),
                     cityWalkMap(planCity({seed, size})));
}

WalkScene houseToWalk(uint64_t seed) {
  return walkSceneOf("builtin:house,seed=" + std::to_string(seed), houseWalkMap(planHouse({seed})));
}

size_t WalkAcceptance::seenCells() const {
  return static_cast<size_t>(
      std::count_if(cells.begin(), cells.end(), [](const SeenCell& cell) { return cell.why.empty(); }));
}

size_t WalkAcceptance::seenRooms() const {
  std::map<uint32_t, const SeenCell*> largest;  // by room
  const auto areaOf = [&](const SeenCell& seen) {
    return found.cells[seen.cell].halfLength * found.cells[seen.cell].halfWidth;
  };
  for (const SeenCell& cell : cells) {
    const SeenCell*& most = largest[found.roomOfCell[cell.cell]];
    most = most == nullptr || areaOf(cell) > areaOf(*most) ? &cell : most;
  }
  return static_cast<size_t>(
      std::count_if(largest.begin(), largest.end(), [](const auto& each) { return each.second->why.empty(); }));
}

WalkAcceptance acceptWalks(const WalkScene& scene, int width, int height, const WalkComprehensiveOptions& options) {
  WalkAcceptance result;
  result.findMilliseconds = milliseconds([&] { result.found = findWalkMap(scene.mesh, WalkOptions{}); });
  result.agreement = compareWalkMaps(scene.known, result.found);
  if (result.agreement.reached.empty() || width == 0) {
    return result;
  }
  // The camera shows what can be reached from its start; it starts in the part that counts.
  const WalkMap& map = result.found;
  WalkMap reached;
  std::vector<uint32_t> numberOf(map.cells.size(), WalkAgreement::kNone);
  for (const uint32_t cell : result.agreement.reached) {
    numberOf[cell] = static_cast<uint32_t>(reached.cells.size());
    reached.cells.push_back(map.cells[cell]);
  }
  for (const uint32_t portal : result.agreement.reachedPortals) {
    WalkPortal opening = map.portals[portal];
    opening.from = numberOf[opening.from];
    opening.to = numberOf[opening.to];
    reached.portals.push_back(opening);
  }
  numberCells(reached);
  std::optional<ComprehensiveWalk> made;
  result.cameraMilliseconds = milliseconds([&] {
    const RayScene rays(scene.mesh);
    made.emplace(makeComprehensiveWalk(reached, options, width, height, &rays));
  });
  const ComprehensiveWalk& walk = *made;
  result.frusta = walk.camera.frusta().size();
  const std::vector<size_t> pixels = pixelsOfMiddles(reached, walk.camera, scene.mesh);
  for (size_t i = 0; i < reached.cells.size(); ++i) {
    SeenCell seen;
    seen.cell = result.agreement.reached[i];
    seen.pixels = pixels[i];
    seen.expected = walk.cells[i].pixels;
    if (static_cast<double>(seen.pixels) < options.minPixels) {
      seen.why =
          walk.cells[i].unseen != WalkUnseen::kNothing ? textOf(walk.cells[i].unseen) : "something stands before it";
    }
    result.cells.push_back(seen);
  }
  return result;
}

}  // namespace ocelli::bench
