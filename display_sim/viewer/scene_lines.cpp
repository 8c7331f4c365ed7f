#include "display_sim/viewer/scene_lines.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <iterator>

#include "display_sim/viewer/viewer_colors.h"
#include "oc_core/base/parallel.h"
#include "oc_core/ocri/eoc_builder.h"

namespace ocelli {
namespace {

/// A ray counts as bent where it departs from a straight line by this share of the scene's radius.
constexpr float kBendTolerance = 2e-3f;

struct Depths {
  float nearest = 1e30f;
  float farthest = 0;
};

Depths depthsOf(const PinholeCamera& camera, const Box& bounds) {
  Depths depths;
  for (const glm::vec3& corner : cornersOf(bounds)) {
    const float z = camera.cameraFromWorld(corner).z;
    depths.nearest = std::min(depths.nearest, z);
    depths.farthest = std::max(depths.farthest, z);
  }
  depths.nearest = std::max(depths.nearest, camera.view().zNear);
  depths.farthest = std::clamp(depths.farthest, 2 * depths.nearest, camera.view().zFar);
  return depths;
}

/// The corners of a pinhole's image at a depth, in order around it.
std::vector<glm::vec3> imageCorners(const PinholeCamera& camera, float depth) {
  const auto width = static_cast<float>(camera.width());
  const auto height = static_cast<float>(camera.height());
  std::vector<glm::vec3> corners;
  for (const glm::vec2& q : {glm::vec2(0, 0), glm::vec2(width, 0), glm::vec2(width, height), glm::vec2(0, height)}) {
    corners.push_back(camera.worldFromCamera(camera.cameraFromImage({q.x, q.y, depth})));
  }
  return corners;
}

void addFrustum(std::vector<ColoredLine>& lines, const PinholeCamera& camera, const std::vector<float>& depths,
                const glm::vec4& color, float width) {
  for (const float depth : depths) {
    std::vector<glm::vec3> corners = imageCorners(camera, depth);
    corners.push_back(corners.front());
    addPolyline(lines, corners, color, width);
  }
  for (const glm::vec3& corner : imageCorners(camera, depths.back())) {
    lines.push_back({camera.eye(), corner, color, width});
  }
}

void addCell(std::vector<ColoredLine>& lines, const BuiltCamera& camera, float width) {
  const View& view = camera.reference.view();
  const glm::vec4 color = opaque(kCellColor);
  if (camera.choice.isForSegment()) {  // made for a segment
    const ViewSegment segment = segmentAround(view, camera.choice.segmentDirection, camera.choice.cellSideRadii);
    lines.push_back({segment.left, segment.right, color, 2 * width});
    return;
  }
  const float half = camera.choice.cellSideRadii / 2;
  std::vector<glm::vec3> corners;
  for (unsigned corner = 0; corner < 8; ++corner) {
    corners.push_back(movedEye(view, {(corner & 1) != 0 ? half : -half, (corner & 2) != 0 ? half : -half,
                                      (corner & 4) != 0 ? half : -half})
                          .eye);
  }
  addBoxEdges(lines, corners, color, width);
}

/// The user's eye: a small pyramid of what it sees.
void addEye(std::vector<ColoredLine>& lines, const View& view, const PinholeCamera& reference, float width) {
  const PinholeCamera eye(view, reference.width(), reference.height());
  const float distance = glm::distance(view.eye, view.target);
  addFrustum(lines, eye, {0.13f * distance}, opaque(kEyeColor), width);
  lines.push_back({view.eye, view.target, withOpacity(kEyeColor, 0.4f), 0.75f * width});
}

}  // namespace

SampledRay sampledRay(const BuiltCamera& camera, const std::vector<RayFunction>& rays, const Box& bounds,
                      const PickedPixel& at) {
  const auto index = static_cast<size_t>(at.image);
  if (index >= rays.size()) {
    return {};
  }
  // Depths of a sample are along its own image's view.
  const ReferenceImage& image = camera.representation.images[index];
  const PinholeCamera reference = image.reference();
  const float nearest = reference.view().zNear;
  const float farthest = depthsOf(reference, bounds).farthest;
  const float z = image.t(at.pixel.x, at.pixel.y);
  const RayPath ray = rays[index](glm::vec2(at.pixel) + 0.5f);
  if (!(z > 0)) {
    return {{}, rayBetween(ray, reference, nearest, farthest)};
  }
  return {rayBetween(ray, reference, nearest, z), rayBetween(ray, reference, z, std::max(z, farthest))};
}

namespace {

bool bends(const SampledRay& ray) {
  std::vector<glm::vec3> all = ray.toSample;
  all.insert(all.end(), ray.beyond.begin(), ray.beyond.end());
  return isBent(all, kBendTolerance);
}

/// Rays of one row of pixels, `steps` of them; every kBentSearch-th counts as one of the grid.
struct RowOfRays {
  RayGrid onGrid;
  std::vector<SampledRay> bentBetween;
};

RowOfRays rowOfRays(const BuiltCamera& camera, const std::vector<RayFunction>& rays, const Box& bounds, int imageIndex,
                    int y, int steps) {
  const ReferenceImage& image = camera.representation.images[static_cast<size_t>(imageIndex)];
  RowOfRays row;
  for (int step = 0; step < steps; ++step) {
    const int x = (2 * step + 1) * image.width() / (2 * steps);
    SampledRay ray = sampledRay(camera, rays, bounds, {imageIndex, {x, y}});
    if (ray.toSample.size() < 2) {
      continue;
    }
    const bool bent = bends(ray);
    if (step % kBentSearch == kBentSearch / 2) {
      (bent ? row.onGrid.bent : row.onGrid.straight).push_back(std::move(ray));
    } else if (bent) {
      row.bentBetween.push_back(std::move(ray));
    }
  }
  return row;
}

}  // namespace

RayGrid rayGrid(const BuiltCamera& camera, const std::vector<RayFunction>& rays, const Box& bounds, int columns,
                int rows) {
  const ReferenceImages& images = camera.representation.images;
  const auto rowsOfImage = static_cast<size_t>(rows);
  std::vector<RowOfRays> found(images.size() * rowsOfImage);
  parallelFor(found.size(), 1, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const size_t image = i / rowsOfImage;
      const int y = (2 * static_cast<int>(i % rowsOfImage) + 1) * images[image].height() / (2 * rows);
      found[i] = rowOfRays(camera, rays, bounds, static_cast<int>(image), y, columns * kBentSearch);
    }
  });
  RayGrid grid;
  std::vector<SampledRay> between;
  for (RowOfRays& row : found) {
    std::ranges::move(row.onGrid.straight, std::back_inserter(grid.straight));
    std::ranges::move(row.onGrid.bent, std::back_inserter(grid.bent));
    std::ranges::move(row.bentBetween, std::back_inserter(between));
  }
  if (grid.bent.size() < kFewBent) {
    std::ranges::move(between, std::back_inserter(grid.bent));
  }
  return grid;
}

SceneLines sceneLines(const ViewerState& state, const BuiltCamera& camera, const RayGrid& rays, const Box& bounds,
                      float lineScale) {
  SceneLines result;
  if (state.scene.rays && state.scene.straightRays) {
    for (const SampledRay& ray : rays.straight) {
      addPolyline(result.lines, ray.toSample, withOpacity(kRayColor, 0.3f), lineScale);
    }
    result.straightRays = rays.straight.size();
  }
  if (state.scene.rays) {
    for (const SampledRay& ray : rays.bent) {
      addPolyline(result.lines, ray.toSample, withOpacity(kBentRayColor, 0.65f), lineScale);
      addPolyline(result.lines, ray.beyond, withOpacity(kBentRayColor, 0.25f), lineScale);
    }
    result.bentRays = rays.bent.size();
  }
  const Depths depths = depthsOf(camera.reference, bounds);
  if (state.scene.frustum) {
    addFrustum(result.lines, camera.reference, {depths.nearest, depths.farthest}, opaque(kReferenceColor), lineScale);
  }
  if (state.scene.cell) {
    addCell(result.lines, camera, 1.25f * lineScale);
  }
  addEye(result.lines, state.reconstruction.view, camera.reference, 1.5f * lineScale);
  return result;
}

}  // namespace ocelli
