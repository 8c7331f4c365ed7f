#include "display_sim/viewer/scene_lines.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "display_sim/viewer/viewer_colors.h"
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
  for (size_t corner = 0; corner < 8; ++corner) {
    const glm::vec3 point((corner & 1) != 0 ? bounds.upper.x : bounds.lower.x,
                          (corner & 2) != 0 ? bounds.upper.y : bounds.lower.y,
                          (corner & 4) != 0 ? bounds.upper.z : bounds.lower.z);
    const float z = camera.cameraFromWorld(point).z;
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
  if (camera.choice.model == CameraChoice::Model::kEoc) {  // made for a segment
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

class RayLines {
 public:
  RayLines(const BuiltCamera& camera, const std::vector<RayFunction>& rays, const Box& bounds)
      : camera_(camera), rays_(rays), bounds_(bounds), depths_(depthsOf(camera.reference, bounds)) {}

  std::vector<glm::vec3> points(const PickedPixel& at) const {
    const ReferenceImage& image = camera_.representation.images[static_cast<size_t>(at.image)];
    const float z = image.z(at.pixel.x, at.pixel.y);
    const glm::vec2 center = glm::vec2(at.pixel) + 0.5f;
    // Depths of a sample are along its own image's view, those of other ends along the reference's.
    const PinholeCamera reference = image.reference();
    const float farthest = z > 0 ? z : depthsOf(reference, bounds_).farthest;
    return rayBetween(rays_[static_cast<size_t>(at.image)](center), reference, reference.view().zNear, farthest);
  }

  void addGrid(const SceneShown& shown, float width, SceneLines& result) const {
    const ReferenceImages& images = camera_.representation.images;
    std::vector<ColoredLine> bent;
    for (size_t i = 0; i < images.size(); ++i) {
      for (int row = 0; row < shown.rayRows; ++row) {
        for (int column = 0; column < shown.rayColumns; ++column) {
          const PickedPixel at{static_cast<int>(i),
                               {(2 * column + 1) * images[i].width() / (2 * shown.rayColumns),
                                (2 * row + 1) * images[i].height() / (2 * shown.rayRows)}};
          if (!(images[i].z(at.pixel.x, at.pixel.y) > 0)) {
            continue;  // it samples nothing
          }
          const std::vector<glm::vec3> ray = points(at);
          if (isBent(ray, kBendTolerance)) {
            addPolyline(bent, ray, withOpacity(kBentRayColor, 0.9f), width);
            ++result.bentRays;
          } else if (shown.straightRays && ray.size() > 1) {
            addPolyline(result.lines, ray, withOpacity(kRayColor, 0.28f), 0.75f * width);
            ++result.straightRays;
          }
        }
      }
    }
    result.lines.insert(result.lines.end(), bent.begin(), bent.end());
  }

 private:
  const BuiltCamera& camera_;
  const std::vector<RayFunction>& rays_;
  Box bounds_;
  Depths depths_;
};

}  // namespace

SceneLines sceneLines(const ViewerState& state, const BuiltCamera& camera, const std::vector<RayFunction>* rays,
                      const Box& bounds, const std::optional<PickedPixel>& picked, float lineScale) {
  SceneLines result;
  const Depths depths = depthsOf(camera.reference, bounds);
  if (rays != nullptr) {
    const RayLines rayLines(camera, *rays, bounds);
    if (state.scene.rays) {
      rayLines.addGrid(state.scene, 1.25f * lineScale, result);
    }
    if (picked && static_cast<size_t>(picked->image) < rays->size()) {
      addPolyline(result.lines, rayLines.points(*picked), opaque(kPickedColor), 2.5f * lineScale);
    }
  }
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
