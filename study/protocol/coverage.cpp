#include "study/protocol/coverage.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "oc_core/base/conventions.h"
#include "oc_core/render/identity_image.h"
#include "study/task/trial_image.h"

namespace ocelli {
namespace {

constexpr uint32_t kObject = 1;  // of a scene with a single one

/// The largest sighting of the object in an image, and the camera of that image.
struct Largest {
  const StudyCamera* camera = nullptr;
  ObjectSighting sighting{};
};

/// How steeply the ray in the middle of the sighting runs down, where it is nearest to the object.
double degreesDown(const Largest& largest, const glm::vec3& object) {
  return std::visit(
      [&](const auto& camera) {
        const RayPath path = camera.rayPath(glm::vec2(largest.sighting.centroid));
        double nearest = std::numeric_limits<double>::infinity();
        double degrees = 0;
        for (size_t i = 0; i + 1 < path.size(); ++i) {
          const glm::dvec3 from(path[i]);
          const glm::dvec3 way = glm::dvec3(path[i + 1]) - from;
          const double length = glm::length(way);
          const double along = length > 0 ? glm::dot(glm::dvec3(object) - from, way) / length : 0;
          const double far = glm::distance(from + way * (std::clamp(along, 0.0, length) / std::max(length, 1e-12)),
                                           glm::dvec3(object));
          if (far < nearest && length > 0) {
            nearest = far;
            degrees = degreesFromRadians(std::asin(std::clamp(-way.y / length, -1.0, 1.0)));
          }
        }
        return degrees;
      },
      *largest.camera);
}

/// Draws the views of one layout again and again, with its one object in other places: what else there is is drawn
/// once.
class PlaceViews {
 public:
  /// The scene of the layout has a single object. It must outlive this.
  explicit PlaceViews(TrialLayout layout) : layout_(std::move(layout)) {
    const StudyScene& scene = *layout_.scene;
    structure_ = scene.mesh();
    object_.positions = scene.mesh().positions;
    std::vector<glm::uvec3> triangles;
    for (size_t i = 0; i < structure_.triangles.size(); ++i) {
      (scene.objectOfTriangle()[i] == kObject ? object_.triangles : triangles).push_back(structure_.triangles[i]);
    }
    structure_.triangles = std::move(triangles);
    for (const TrialLayout::View& view : layout_.views) {
      structures_.push_back(view.show ? FragmentImage() : rasterizeStudy(view.camera, structure_));
    }
  }

  const std::vector<TrialLayout::View>& views() const { return layout_.views; }

  /// What view `i` shows of the object, moved by `offset`.
  std::optional<ObjectSighting> sighting(size_t i, const glm::vec3& offset) {
    layout_.objectOffsets = {offset};
    const TrialLayout::View& view = layout_.views[i];
    std::vector<ObjectSighting> seen;
    if (view.show) {
      seen = sightings(objectsIn(layout_, view));
    } else {
      Mesh moved = object_;
      const VertexRange range = layout_.scene->verticesOf(0);
      for (size_t v = range.first; v < range.first + range.count; ++v) {
        moved.positions[v] += offset;
      }
      seen = visibleIn(rasterizeStudy(view.camera, moved), structures_[i]);
    }
    const auto found =
        std::find_if(seen.begin(), seen.end(), [](const ObjectSighting& each) { return each.object == kObject; });
    return found != seen.end() ? std::optional(*found) : std::nullopt;
  }

 private:
  /// Where nothing else is nearer.
  static std::vector<ObjectSighting> visibleIn(const FragmentImage& object, const FragmentImage& structure) {
    Image<uint32_t> identities(object.width(), object.height(), kNothing);
    bool any = false;
    for (size_t i = 0; i < object.size(); ++i) {
      if (object[i].covered() && (!structure[i].covered() || object[i].t < structure[i].t)) {
        identities[i] = kObject;
        any = true;
      }
    }
    return any ? sightings(identities) : std::vector<ObjectSighting>{};
  }

  TrialLayout layout_;
  Mesh structure_;
  Mesh object_;
  std::vector<FragmentImage> structures_;
};

/// The object is moved by `offset`; `middle` is then its middle.
void addSightings(const std::string& place, PlaceViews& from, const glm::vec3& offset, const glm::vec3& middle,
                  size_t minPixels, ViewCoverage& coverage) {
  int sightingsHere = 0;
  Largest largest;
  for (size_t i = 0; i < from.views().size(); ++i) {
    const std::optional<ObjectSighting> each = from.sighting(i, offset);
    if (each && each->pixels >= minPixels) {
      ++sightingsHere;
      if (each->pixels > largest.sighting.pixels) {
        largest = {&from.views()[i].camera, *each};
      }
    }
  }
  coverage.images = static_cast<int>(from.views().size());
  ++coverage.places;
  coverage.sightings += sightingsHere;
  if (sightingsHere == 0) {
    coverage.unseen.push_back(place);
    return;
  }
  coverage.pixels.push_back(largest.sighting.pixels);
  coverage.degreesDown.push_back(degreesDown(largest, middle));
  const glm::dvec2 size(largest.sighting.upper - largest.sighting.lower + 1);
  coverage.stretches.push_back(std::max(size.x, size.y) / std::min(size.x, size.y));
  ++coverage.seen;
  coverage.twice += sightingsHere > 1 ? 1 : 0;
}

void sort(ViewCoverage& coverage) {
  std::sort(coverage.pixels.begin(), coverage.pixels.end());
  std::sort(coverage.degreesDown.begin(), coverage.degreesDown.end());
  std::sort(coverage.stretches.begin(), coverage.stretches.end());
}

glm::vec3 middleOf(const StudyScene& scene, const glm::vec3& offset) {
  return (scene.boxOf(0).lower + scene.boxOf(0).upper) / 2.0f + offset;
}

struct Place {
  std::string name;
  glm::vec3 point{0};
};

/// The middle of every cell but the entrance, and of every passage between cells.
std::vector<Place> placesOf(const Maze& maze) {
  std::vector<Place> places;
  for (int row = 0; row < maze.rows(); ++row) {
    for (int column = 0; column < maze.columns(); ++column) {
      const MazeCell cell{row, column};
      if (cell != maze.entrance->cell) {
        places.push_back({nameOf(cell), maze.centerOf(cell)});
      }
      for (const Direction way : {Direction::kEast, Direction::kSouth}) {
        if (maze.isOpen(cell, way)) {
          const MazeCell next = cell.neighbor(way);
          places.push_back({std::string("between ").append(nameOf(cell)).append(" and ").append(nameOf(next)),
                            (maze.centerOf(cell) + maze.centerOf(next)) / 2.0f});
        }
      }
    }
  }
  return places;
}

/// Puts one object, of the shape that the layout's scene has, in each place.
ViewCoverage coverageOfMaze(TrialLayout layout, TrialView view, size_t minPixels) {
  Maze maze = layout.scene->maze();
  const MazeCell first = maze.landmarks.empty() ? maze.entrance->cell : maze.landmarks.front().cell;
  Landmark object;
  object.cell = first;
  object.shape = maze.landmarks.empty() ? LandmarkShape::kSphere : maze.landmarks.front().shape;
  maze.landmarks = {object};
  const StudyScene scene(maze, false);  // as trials that show a whole maze have it
  layout.scene = &scene.bare();
  PlaceViews views(layout);
  ViewCoverage coverage;
  coverage.view = view;
  for (const Place& place : placesOf(maze)) {
    const glm::vec3 offset = place.point - maze.centerOf(first);
    addSightings(place.name, views, offset, middleOf(*layout.scene, offset), minPixels, coverage);
  }
  sort(coverage);
  return coverage;
}

TrialPlan planOf(const ProtocolBlock& block, int caseIndex, TrialView view) {
  TrialPlan plan;
  plan.task = block.taskName;
  plan.caseIndex = caseIndex;
  plan.view = view;
  return plan;
}

}  // namespace

size_t minSeenPixels(const TrialScreen& screen) {
  constexpr TrialScreen kFull;
  const double share =
      static_cast<double>(screen.width) * screen.height / (static_cast<double>(kFull.width) * kFull.height);
  return std::max<size_t>(1, static_cast<size_t>(std::lround(static_cast<double>(kMinSeenPixels) * share)));
}

std::vector<BlockCoverage> coverageOf(const Protocol& protocol, const TrialScreen& screen, const Progress& progress) {
  std::vector<BlockCoverage> blocks;
  for (size_t i = 0; i < protocol.blocks.size(); ++i) {
    const ProtocolBlock& block = protocol.blocks[i];
    BlockCoverage coverage;
    coverage.block = block.name;
    coverage.ofCases = !block.task->caseInfo(0).exposureSeconds.has_value();
    for (const TrialView view : protocol.conditions.names.all()) {
      const std::unique_ptr<TrialRun> run = block.task->start(planOf(block, 0, view), screen);
      const TrialLayout first = run->layout();
      if (first.scene == nullptr || first.views.empty() || (coverage.ofCases && !first.targetObject)) {
        continue;
      }
      if (!coverage.ofCases) {
        coverage.views.push_back(coverageOfMaze(first, view, minSeenPixels(screen)));
        continue;
      }
      ViewCoverage cases;
      cases.view = view;
      for (int k = 0; k < block.task->caseCount(); ++k) {
        const std::unique_ptr<TrialRun> each = block.task->start(planOf(block, k, view), screen);
        TrialLayout layout = each->layout();
        layout.scene = &layout.scene->bare();
        PlaceViews views(layout);
        const glm::vec3 offset = layout.objectOffsets.empty() ? glm::vec3(0) : layout.objectOffsets.front();
        addSightings(block.task->caseInfo(k).label, views, offset, middleOf(*layout.scene, offset),
                     minSeenPixels(screen), cases);
      }
      sort(cases);
      coverage.views.push_back(cases);
    }
    if (!coverage.views.empty()) {
      blocks.push_back(coverage);
    }
    report(progress, "coverage", static_cast<double>(i + 1) / static_cast<double>(protocol.blocks.size()));
  }
  return blocks;
}

}  // namespace ocelli
