#include "study/agent/visibility_sensor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <utility>

#include "oc_core/base/check.h"

namespace ocelli {
namespace {

/// Gaps between pixels of an object that people look over: what stands behind a post is one thing. Share of the width
/// of the screen.
constexpr double kGapShare = 0.01;
/// How a picture shows the floor around an object is taken from what shows so far around it (share of the width of the
/// screen), at every n-th pixel so that so many are across.
constexpr double kAroundShare = 0.03;
constexpr int kAroundPixels = 24;
/// The floor is looked at along the rays of so many pixels of the width of the screen.
constexpr int kFloorRays = 120;
/// Lower than that above the floor, in cell sizes, a ray would have met whatever stands there.
constexpr float kLowShare = 0.25f;
/// A ray is followed in such steps, in cell sizes.
constexpr float kFollowShare = 0.1f;
/// So near to the face of a wall, in halves of its thickness, a point is neither within nor beside it.
constexpr float kFaceShare = 0.1f;
/// Edges of the cubes that spots of surfaces lie in, in cell sizes.
constexpr float kCubeShare = 0.25f;
/// Rays that do not bend bring a point there; single precision moves it by far less.
constexpr double kSamePixel = 0.5;
/// Of a cell: its ninths, and the ways to the east and south.
constexpr int kPatches = 11;
constexpr int kEastWay = 9;
constexpr int kSouthWay = 10;

/// Pixels of one object that touch.
struct Blob {
  size_t pixels = 0;
  glm::dvec2 sum{0};
  glm::dvec2 lower{1e9};
  glm::dvec2 upper{-1e9};
  glm::dvec2 placeSum{0};
  std::vector<glm::ivec2> points{};
  uint32_t object = 0;

  void add(const glm::ivec2& pixel, const glm::vec3& position) {
    ++pixels;
    sum += glm::dvec2(pixel) + 0.5;
    lower = glm::min(lower, glm::dvec2(pixel));
    upper = glm::max(upper, glm::dvec2(pixel) + 1.0);
    placeSum += glm::dvec2(position.x, position.z);
    points.push_back(pixel);
  }
  void add(const Blob& other) {
    pixels += other.pixels;
    sum += other.sum;
    lower = glm::min(lower, other.lower);
    upper = glm::max(upper, other.upper);
    placeSum += other.placeSum;
    points.insert(points.end(), other.points.begin(), other.points.end());
  }
};

/// Takes the pixels that hang together with one of an object out of `identities`. `positionAt`: of the surface at a
/// pixel.
template <class PositionAt>
Blob takeBlob(Image<uint32_t>& identities, const PositionAt& positionAt, const glm::ivec2& first) {
  Blob blob;
  blob.object = identities(first.x, first.y);
  std::vector<glm::ivec2> open{first};
  identities(first.x, first.y) = kStructure;
  while (!open.empty()) {
    const glm::ivec2 pixel = open.back();
    open.pop_back();
    blob.add(pixel, positionAt(pixel));
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const glm::ivec2 next = pixel + glm::ivec2(dx, dy);
        if (identities.contains(next.x, next.y) && identities(next.x, next.y) == blob.object) {
          identities(next.x, next.y) = kStructure;
          open.push_back(next);
        }
      }
    }
  }
  return blob;
}

/// Between the boxes of two blobs, pixels.
double gapOf(const Blob& a, const Blob& b) {
  return glm::length(glm::max(glm::max(a.lower - b.upper, b.lower - a.upper), glm::dvec2(0)));
}

void joinNear(std::vector<Blob>& blobs, double gap) {
  for (size_t i = 0; i < blobs.size(); ++i) {
    for (size_t j = i + 1; j < blobs.size();) {
      if (blobs[i].object == blobs[j].object && gapOf(blobs[i], blobs[j]) <= gap) {
        blobs[i].add(blobs[j]);
        blobs.erase(blobs.begin() + static_cast<std::ptrdiff_t>(j));
        j = i + 1;
      } else {
        ++j;
      }
    }
  }
}

Sighting sightingOf(const Blob& blob, const Landmark& landmark, int view, const glm::dvec2& corner,
                    const std::optional<PicturePerspective>& perspective) {
  const glm::dvec2 middle = blob.sum / static_cast<double>(blob.pixels);
  const auto nearest =
      std::min_element(blob.points.begin(), blob.points.end(), [&](const glm::ivec2& a, const glm::ivec2& b) {
        return glm::distance(glm::dvec2(a) + 0.5, middle) < glm::distance(glm::dvec2(b) + 0.5, middle);
      });
  return {.shape = landmark.shape,
          .color = landmark.color,
          .view = view,
          .pixels = blob.pixels,
          .lower = corner + blob.lower,
          .upper = corner + blob.upper,
          .centroid = corner + middle,
          .aim = corner + glm::dvec2(*nearest) + 0.5,
          .place = blob.placeSum / static_cast<double>(blob.pixels),
          .perspective = perspective};
}

/// From what shows in and around the box of a blob. `positionAt`: of the surface at a pixel that shows one.
template <class PositionAt>
std::optional<PicturePerspective> perspectiveAround(const Blob& blob, const Image<uint32_t>& identities,
                                                    const PositionAt& positionAt, double around) {
  const glm::ivec2 lower = glm::max(glm::ivec2(glm::floor(blob.lower - around)), glm::ivec2(0));
  const glm::ivec2 upper =
      glm::min(glm::ivec2(glm::ceil(blob.upper + around)), glm::ivec2(identities.width(), identities.height()));
  const int step = std::max(1, std::max(upper.x - lower.x, upper.y - lower.y) / kAroundPixels);
  PerspectiveFit fit;
  for (int y = lower.y + step / 2; y < upper.y; y += step) {
    for (int x = lower.x + step / 2; x < upper.x; x += step) {
      if (identities(x, y) != kNothing) {
        fit.add(glm::dvec2(x, y) + 0.5, glm::dvec3(positionAt({x, y})));
      }
    }
  }
  return fit.result();
}

/// Which patch of the maze a point is above: index of the cell times kPatches, plus the patch; nothing at the
/// corners of cells, at the faces of walls and beyond the maze.
std::optional<size_t> patchOf(const Maze& maze, const glm::vec3& point) {
  const std::optional<MazeCell> cell = maze.cellAt(point);
  if (!cell) {
    return std::nullopt;
  }
  const glm::vec2 within =
      glm::vec2(point.x - maze.origin.x, point.z - maze.origin.z) / maze.cellSize - glm::vec2(cell->column, cell->row);
  const float half = maze.wallThickness / 2 / maze.cellSize;
  // At the faces of walls rounding would decide whether a point is within.
  const glm::vec2 fromFace = glm::abs(glm::abs(within - 0.5f) - (0.5f - half));
  if (std::min(fromFace.x, fromFace.y) < kFaceShare * half) {
    return std::nullopt;
  }
  const glm::bvec2 low(within.x < half, within.y < half);
  const glm::bvec2 high(within.x > 1 - half, within.y > 1 - half);
  const bool atSide = low.x || high.x;
  if (atSide && (low.y || high.y)) {
    return std::nullopt;
  }
  if (atSide || low.y || high.y) {
    const Direction to = low.x ? Direction::kWest : low.y ? Direction::kNorth : Direction::kEast;
    const MazeCell from = low.x || low.y ? cell->neighbor(to) : *cell;
    const MazeCell beyond = from.neighbor(atSide ? Direction::kEast : Direction::kSouth);
    if (!maze.contains(from) || !maze.contains(beyond)) {
      return std::nullopt;
    }
    return maze.indexOf(from) * kPatches + static_cast<size_t>(atSide ? kEastWay : kSouthWay);
  }
  const glm::ivec2 third =
      glm::clamp(glm::ivec2((within - half) / (1 - 2 * half) * 3.0f), glm::ivec2(0), glm::ivec2(2));
  return maze.indexOf(*cell) * kPatches + static_cast<size_t>(third.y * 3 + third.x);
}

FloorPatch emptyPatch(const Maze& maze, size_t index, int view) {
  const auto cell = static_cast<int>(index / kPatches);
  const auto patch = static_cast<int>(index % kPatches);
  FloorPatch empty;
  empty.cell = {cell / maze.columns(), cell % maze.columns()};
  empty.view = view;
  if (patch == kEastWay || patch == kSouthWay) {
    empty.way = patch == kEastWay ? Direction::kEast : Direction::kSouth;
  } else {
    empty.ninth = patch;
  }
  return empty;
}

const PinholeCamera& rootOf(const StudyCamera& camera) {
  const auto* graph = std::get_if<GraphCamera>(&camera);
  return graph ? graph->root() : std::get<PinholeCamera>(camera);
}

/// What shows of a patch of floor.
struct PatchSamples {
  size_t count = 0;
  size_t straight = 0;
  glm::dvec2 sum{0};
  glm::dvec2 placeSum{0};
};

struct SpotSamples {
  size_t count = 0;
  glm::dvec2 sum{0};
};

/// Where the last straight piece of a ray begins that ends at a point which it meets.
glm::vec3 beginOfLastPiece(const StudyCamera& camera, const glm::vec2& pixel, const glm::vec3& point) {
  const RayPath path = std::visit([&](const auto& each) { return each.rayPath(pixel); }, camera);
  return path.size() > 1 ? path[path.positionNear(point).segment] : point;
}

/// Calls `visit(patch, place)` for the patches that a straight piece of a ray passes low above, each once.
template <class Visit>
void forEachPatchBelow(const Maze& maze, const glm::vec3& from, const glm::vec3& to, const Visit& visit) {
  const float top = maze.origin.y + kLowShare * maze.cellSize;
  const float low = from.y > top ? (from.y - top) / (from.y - to.y) : 0.0f;  // it ends below the top
  const float length = glm::distance(from, to) * (1 - low);
  const auto steps = static_cast<int>(length / (kFollowShare * maze.cellSize)) + 1;
  std::optional<size_t> last;
  for (int i = 0; i < steps; ++i) {
    const float share = low + (1 - low) * (static_cast<float>(i) + 0.5f) / static_cast<float>(steps);
    const glm::vec3 point = glm::mix(from, to, share);
    const std::optional<size_t> patch = patchOf(maze, point);
    if (patch && patch != last) {
      visit(*patch, glm::dvec2(point.x, point.z));
    }
    last = patch;
  }
}

void addStructure(const Maze& maze, const StudyCamera& camera, const FragmentImage& fragments, const ViewMesh& of,
                  int view, const glm::dvec2& corner, Percept& percept) {
  const PinholeCamera& root = rootOf(camera);
  const int step = std::max(1, fragments.width() / kFloorRays);
  const float top = maze.origin.y + kLowShare * maze.cellSize;
  std::vector<PatchSamples> patches(maze.cellCount() * kPatches);
  std::map<std::array<int, 3>, SpotSamples> spots;
  for (int y = step / 2; y < fragments.height(); y += step) {
    for (int x = step / 2; x < fragments.width(); x += step) {
      const Fragment& fragment = fragments(x, y);
      if (!fragment.covered() || (*of.objectOfTriangle)[fragment.triangle] != kStructure) {
        continue;
      }
      const glm::vec3 position = positionOf(fragment, *of.mesh);
      const glm::dvec2 pixel = glm::dvec2(x, y) + 0.5;
      const glm::ivec3 cube(glm::floor((position - maze.origin) / (kCubeShare * maze.cellSize)));
      SpotSamples& spot = spots[{cube.x, cube.y, cube.z}];
      ++spot.count;
      spot.sum += pixel;
      if (position.y >= top) {
        continue;
      }
      const std::optional<ImagePoint> straight = root.project(position);
      const bool isStraight = straight && glm::distance(glm::dvec2(straight->u, straight->v), pixel) < kSamePixel;
      const glm::vec3 from = isStraight ? root.eye() : beginOfLastPiece(camera, glm::vec2(pixel), position);
      forEachPatchBelow(maze, from, position, [&](size_t patch, const glm::dvec2& place) {
        PatchSamples& samples = patches[patch];
        ++samples.count;
        samples.straight += isStraight ? 1 : 0;
        samples.sum += pixel;
        samples.placeSum += place;
      });
    }
  }
  for (size_t i = 0; i < patches.size(); ++i) {
    const PatchSamples& samples = patches[i];
    if (samples.count > 0) {
      const auto count = static_cast<double>(samples.count);
      FloorPatch patch = emptyPatch(maze, i, view);
      patch.pixels = samples.count * static_cast<size_t>(step) * static_cast<size_t>(step);
      patch.centroid = corner + samples.sum / count;
      patch.place = samples.placeSum / count;
      patch.straight = samples.straight == samples.count;
      percept.floor.push_back(patch);
    }
  }
  for (const auto& [cube, samples] : spots) {
    percept.surfaces.push_back(
        {{cube[0], cube[1], cube[2]}, corner + samples.sum / static_cast<double>(samples.count)});
  }
}

SeenGrid gridOf(const Maze& maze) {
  // FNV-1a over what walls stand.
  uint64_t hash = 0xcbf29ce484222325u;
  const auto add = [&](uint64_t value) { hash = (hash ^ value) * 0x100000001b3u; };
  add(static_cast<uint64_t>(maze.columns()));
  for (int row = 0; row < maze.rows(); ++row) {
    for (int column = 0; column < maze.columns(); ++column) {
      const MazeCell cell{row, column};
      add((maze.isOpen(cell, Direction::kEast) ? 1u : 0u) + (maze.isOpen(cell, Direction::kSouth) ? 2u : 0u));
    }
  }
  return {.origin = {static_cast<double>(maze.origin.x), static_cast<double>(maze.origin.z)},
          .cellSize = static_cast<double>(maze.cellSize),
          .surroundings = hash};
}

WalkerPose poseOf(const StudyCamera& camera) {
  const PinholeCamera& root = rootOf(camera);
  return {.x = static_cast<double>(root.eye().x),
          .z = static_cast<double>(root.eye().z),
          .headingRadians = std::atan2(static_cast<double>(root.forward().x), -static_cast<double>(root.forward().z))};
}

}  // namespace

VisibilitySensor::VisibilitySensor(const TrialScreen& screen, StudyRenderer renderer)
    : screen_(screen), renderer_(std::move(renderer)) {}

Percept VisibilitySensor::look(const TrialLayout& layout, bool withFloor) const {
  Percept percept;
  percept.maps = layout.maps;
  percept.choices = layout.choices;
  percept.scale = layout.scale;
  percept.dial = layout.dial;
  percept.pointer = layout.pointer;
  if (layout.views.empty()) {
    return percept;
  }
  OC_CHECK(layout.scene != nullptr, "views show a scene");
  if (layout.targetObject) {
    const Landmark& sought = layout.scene->maze().landmarks[static_cast<size_t>(*layout.targetObject)];
    percept.soughtShape = sought.shape;
    percept.soughtColor = sought.color;
  }
  percept.grid = gridOf(layout.scene->maze());
  const StudyScene& scene = layout.scene->bare();
  Mesh mesh = scene.mesh();
  scene.moveObjects(mesh, layout.objectOffsets);
  for (size_t view = 0; view < layout.views.size(); ++view) {
    addView(layout, mesh, static_cast<int>(view), withFloor, percept);
  }
  if (layout.views.size() == 1) {
    percept.standing = poseOf(layout.views.front().camera);
  }
  return percept;
}

void VisibilitySensor::addView(const TrialLayout& layout, const Mesh& mesh, int view, bool withFloor,
                               Percept& percept) const {
  const TrialLayout::View& each = layout.views[static_cast<size_t>(view)];
  const StudyScene& scene = layout.scene->bare();
  const glm::dvec2 corner(each.place.left, each.place.top);
  percept.views.push_back(each.place);
  const auto addObjects = [&](const Image<uint32_t>& identities, const auto& positionAt) {
    std::vector<Blob> blobs;
    Image<uint32_t> left = identities;
    for (int y = 0; y < left.height(); ++y) {
      for (int x = 0; x < left.width(); ++x) {
        if (left(x, y) != kStructure && left(x, y) != kNothing) {
          blobs.push_back(takeBlob(left, positionAt, {x, y}));
        }
      }
    }
    joinNear(blobs, kGapShare * screen_.width);
    for (const Blob& blob : blobs) {
      percept.objects.push_back(
          sightingOf(blob, scene.maze().landmarks[blob.object - 1], view, corner,
                     perspectiveAround(blob, identities, positionAt, kAroundShare * screen_.width)));
    }
  };
  const std::shared_ptr<const ShownContent> shown = shownIn(layout, each);
  const std::optional<ViewMesh> of = viewMesh(shown.get(), scene, mesh);
  if (!of) {
    const auto& image = std::get<ShownImage>(*shown);
    addObjects(image.objects, [&](const glm::ivec2& pixel) { return image.positionAt(pixel); });
    return;
  }
  const FragmentImage fragments = renderer_(each.camera, *of->mesh);
  addObjects(identityImage(fragments, *of->objectOfTriangle),
             [&](const glm::ivec2& pixel) { return positionOf(fragments(pixel.x, pixel.y), *of->mesh); });
  if (withFloor) {
    addStructure(scene.maze(), each.camera, fragments, *of, view, corner, percept);
  }
}

}  // namespace ocelli
