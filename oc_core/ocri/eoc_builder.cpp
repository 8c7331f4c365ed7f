#include "oc_core/ocri/eoc_builder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <span>

#include "oc_core/base/conventions.h"
#include "oc_core/base/error.h"
#include "oc_core/base/parallel.h"
#include "oc_core/ocri/depth_edges.h"
#include "oc_core/ocri/eoc_construction.h"
#include "oc_core/render/rasterize_spans.h"
#include "oc_core/render/scene_renderer.h"
#include "oc_core/scene/winding_number.h"

namespace ocelli {
namespace {

/// A rectangle in the image plane of a pinhole, pixels from where the view direction meets it.
struct Window {
  glm::vec2 lower{1e30f};
  glm::vec2 upper{-1e30f};

  void add(const glm::vec2& p) {
    lower = glm::min(lower, p);
    upper = glm::max(upper, p);
  }
};

/// What the scene takes up in front of a pinhole. Nothing where a vertex is nearer than zNear, or none is in front.
struct SceneExtent {
  Window window;
  float zLeast = 1e30f;
  float zMost = 0;
};

std::optional<SceneExtent> extentOf(const PinholeCamera& camera, std::span<const glm::vec3> points) {
  constexpr size_t kChunks = 16;
  std::array<SceneExtent, kChunks> extents;
  std::array<bool, kChunks> whole{};
  parallelChunks(points.size(), kChunks, [&](size_t chunk, size_t begin, size_t end) {
    SceneExtent extent;
    bool all = true;
    for (size_t i = begin; i < end; ++i) {
      const glm::vec3 p = camera.cameraFromWorld(points[i]);
      all = all && p.z >= camera.view().zNear;
      extent.window.add(glm::vec2(p) / p.z);
      extent.zLeast = std::min(extent.zLeast, p.z);
      extent.zMost = std::max(extent.zMost, p.z);
    }
    extents[chunk] = extent;
    whole[chunk] = all;
  });
  SceneExtent sum;
  for (size_t chunk = 0; chunk < kChunks; ++chunk) {
    if (!whole[chunk]) {
      return std::nullopt;
    }
    sum.window.lower = glm::min(sum.window.lower, extents[chunk].window.lower);
    sum.window.upper = glm::max(sum.window.upper, extents[chunk].window.upper);
    sum.zLeast = std::min(sum.zLeast, extents[chunk].zLeast);
    sum.zMost = std::max(sum.zMost, extents[chunk].zMost);
  }
  sum.window.lower *= camera.focalPixels();
  sum.window.upper *= camera.focalPixels();
  return sum.zMost > 0 ? std::optional(sum) : std::nullopt;
}

/// Where a pinhole sees a world point, from where the view direction meets the image.
glm::vec2 fromCenter(const PinholeCamera& camera, const glm::vec3& worldPoint) {
  const ImagePoint q = camera.imageFromCamera(camera.cameraFromWorld(worldPoint));
  return glm::vec2(q.u, q.v) - camera.centerPixels();
}

glm::vec3 forwardOf(const PinholeCamera& camera) {
  return camera.worldFromCamera({0, 0, 1}) - camera.eye();
}

/// A pinhole of the given focal length whose image is a window of its image plane.
PinholeCamera pinholeWith(View view, float focalPixels, const Window& window) {
  // Windows whose sides are whole pixels but for rounding stay as they are.
  constexpr float kRounding = 0.01f;
  const glm::vec2 size = glm::max(glm::ceil(window.upper - window.lower - kRounding), 1.0f);
  const glm::vec2 center = (window.lower + window.upper) / 2.0f;
  view.fovVerticalDegrees = degreesFromRadians(2 * std::atan(static_cast<double>(size.y) / 2 / focalPixels));
  view.centerShift = -center / size.y;
  if (!(std::max(size.x, size.y) <= static_cast<float>(PinholeCamera::kMaxPixelsASide))) {
    throw InputError("the image that covers the view segment would be larger than an image may be", "view segment",
                     "choose a shorter segment");
  }
  return {view, static_cast<int>(size.x), static_cast<int>(size.y)};
}

/// A corner of the reference's image, in the plane through its target.
glm::vec3 targetPoint(const PinholeCamera& reference, const glm::vec2& corner) {
  const float distance = glm::distance(reference.view().target, reference.eye());
  const glm::vec2 pixel = corner * glm::vec2(reference.width(), reference.height());
  return reference.worldFromCamera(reference.cameraFromImage({pixel.x, pixel.y, distance}));
}

/// The window of a frustum of the size of the reference's, around the same point of the plane through its target.
Window windowOfTarget(const PinholeCamera& reference, const PinholeCamera& base, float roll) {
  const glm::vec2 center = fromCenter(base, targetPoint(reference, glm::vec2(0.5f)));
  const glm::vec2 along(std::abs(std::cos(roll)), std::abs(std::sin(roll)));
  const glm::vec2 middle = glm::vec2(reference.width(), reference.height()) / 2.0f;
  const glm::vec2 half(middle.x * along.x + middle.y * along.y, middle.x * along.y + middle.y * along.x);
  Window window;
  window.add(center - half);
  window.add(center + half);
  return window;
}

/// Adds what is seen through the reference's window in the plane through its target, from the ends and the middle of
/// the segment, where the scene is.
void addSeen(Window& window, const PinholeCamera& reference, const ViewSegment& segment, const PinholeCamera& base,
             const SceneExtent& extent) {
  Window seen;
  for (const glm::vec3& eye : {segment.left, (segment.left + segment.right) * 0.5f, segment.right}) {
    const glm::vec3 start = base.cameraFromWorld(eye);
    for (const glm::vec2& corner : {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(0, 1), glm::vec2(1, 1)}) {
      const glm::vec3 step = base.cameraFromWorld(targetPoint(reference, corner)) - start;
      for (const float z : {extent.zLeast, extent.zMost}) {
        if (step.z > 0 && z >= start.z) {
          const glm::vec3 p = start + step * ((z - start.z) / step.z);
          seen.add(glm::vec2(p) / p.z * base.focalPixels());
        }
      }
    }
  }
  // No more than the scene takes up; a comparison with a NaN is false, and changes nothing.
  const glm::vec2 lower = glm::max(seen.lower, extent.window.lower);
  const glm::vec2 upper = glm::min(seen.upper, extent.window.upper);
  for (int axis = 0; axis < 2; ++axis) {
    if (lower[axis] < window.lower[axis]) {
      window.lower[axis] -= std::ceil(window.lower[axis] - lower[axis]);
    }
    if (upper[axis] > window.upper[axis]) {
      window.upper[axis] += std::ceil(upper[axis] - window.upper[axis]);
    }
  }
}

/// basePinhole() of a scene that lies between the points.
PinholeCamera baseAround(const PinholeCamera& reference, const ViewSegment& segment,
                         std::span<const glm::vec3> outerPoints) {
  validate(segment, "view segment");
  View view = reference.view();
  view.eye = segment.left;
  view.target = segment.left + forwardOf(reference) * glm::distance(reference.view().target, reference.eye());
  view.centerShift = glm::vec2(0);
  view.fovVerticalDegrees = view.resolvedFovVerticalDegrees();
  float roll = 0;
  PinholeCamera base(view, reference.width(), reference.height());
  const glm::vec3 step = base.cameraFromWorld(segment.right);
  // Those that are parallel but for the rounding of the eyes.
  constexpr float kMinAdvance = 1e-4f;
  if (std::abs(step.z) <= kMinAdvance * glm::length(step)) {
    roll = std::atan2(step.y, step.x);
    view.up = base.eye() - base.worldFromCamera({-std::sin(roll), std::cos(roll), 0});
    base = PinholeCamera(view, reference.width(), reference.height());
  }
  Window window = windowOfTarget(reference, base, roll);
  if (const std::optional<SceneExtent> extent = extentOf(base, outerPoints)) {
    addSeen(window, reference, segment, base, *extent);
  }
  return pinholeWith(view, reference.focalPixels(), window);
}

/// 1/z of the farthest of the points, as far as the pinhole sees.
float farthestInverseZ(const PinholeCamera& camera, std::span<const glm::vec3> points) {
  float farthest = 0;
  for (const glm::vec3& p : points) {
    farthest = std::max(farthest, camera.cameraFromWorld(p).z);
  }
  return 1 / std::clamp(farthest, camera.view().zNear, camera.view().zFar);
}

/// What the renderer casts rays at, where it does.
const RayTarget* raysOf(const SceneRenderer* renderer) {
  return renderer != nullptr ? renderer->rays() : nullptr;
}

/// How the scene is looked at in one construction: by a renderer where there is one.
class Scene {
 public:
  Scene(const Mesh& mesh, const SceneRenderer* by) : mesh_(mesh), renderer_(by) {
    const Box box = raysOf(by) != nullptr ? raysOf(by)->bounds() : Box();
    if (!box.empty()) {
      const std::array<glm::vec3, 8> ofBox = cornersOf(box);
      corners_.assign(ofBox.begin(), ofBox.end());
    }
  }

  /// The scene lies between these: its vertices, or the corners of the box around it.
  std::span<const glm::vec3> outerPoints() const { return raysOf(renderer_) != nullptr ? corners_ : mesh_.positions; }

  /// What `base` sees along its epipolar lines. Both are those of all cameras that are drawn later, and outlive this.
  FragmentImage lines(const PinholeCamera& base, const EpipolarLines& lines) {
    if (renderer_ != nullptr) {
      return renderer_->drawLines(base, lines);
    }
    drawing_.emplace(base, lines, mesh_);
    return drawing_->baseImage();
  }

  /// The closest fragment along each ray.
  FragmentImage draw(const EpipolarCamera& camera, const FragmentImage& baseImage) {
    return renderer_ != nullptr ? renderer_->draw(camera, baseImage) : drawing_->draw(camera, baseImage);
  }
  /// The same for the last camera that was drawn without some of its columns.
  FragmentImage drawTrimmed(const EpipolarCamera& camera, const FragmentImage& baseImage) {
    return renderer_ != nullptr ? renderer_->drawTrimmed(camera, baseImage) : drawing_->drawAgain(camera, baseImage);
  }

 private:
  const Mesh& mesh_;
  const SceneRenderer* renderer_;
  std::vector<glm::vec3> corners_;
  std::optional<LineDrawing> drawing_;
};

/// The edges of a row without the columns at their left ends that hold no sample: rays of R that graze the occluder.
std::vector<EpipolarEdge> trimmedEdges(const EpipolarCamera& camera, int row, const FragmentImage& fragments) {
  const EpipolarLines& lines = camera.lines();
  std::vector<EpipolarEdge> edges;
  for (const EpipolarCamera::Disocclusion& disocclusion : camera.disocclusions(row)) {
    const int begin = disocclusion.position - disocclusion.added;
    int first = begin;
    while (first < disocclusion.position && !fragments(first + disocclusion.shift, row).covered()) {
      ++first;
    }
    if (first < disocclusion.position) {
      // The rays that stay keep their places: the disocclusion now begins between the last one that goes and the first
      // one that stays.
      const double xRight = disocclusion.xRight + lines.x(row, first) - lines.x(row, begin);
      const double x = lines.x(row, disocclusion.position);
      const double inverseNear = (x - xRight) / lines.disparity() / lines.inverseZScale(x);
      edges.push_back(
          {disocclusion.position, disocclusion.clip, disocclusion.position - first, static_cast<float>(inverseNear)});
    }
  }
  return edges;
}

EpipolarCamera cameraFrom(const PinholeCamera& base, const glm::vec3& right, const EpipolarLines& lines,
                          const FragmentImage& baseImage, Scene& scene, const EocOptions& options) {
  const float background = farthestInverseZ(base, scene.outerPoints());
  std::vector<std::vector<EpipolarEdge>> edges(static_cast<size_t>(lines.rowCount()));
  parallelFor(edges.size(), 8, [&](size_t begin, size_t end) {
    std::vector<float> inverseZ;
    for (size_t row = begin; row < end; ++row) {
      inverseZ.clear();
      for (int j = 0; j < lines.length(static_cast<int>(row)); ++j) {
        const Fragment& fragment = baseImage(j, static_cast<int>(row));
        inverseZ.push_back(fragment.covered() ? 1 / fragment.t : 0);
      }
      edges[row] = findEpipolarEdges(inverseZ, static_cast<int>(row), lines, base.view().zNear, background, options);
    }
  });
  EpipolarCamera camera(base, right, edges);
  if (!options.trim) {
    return camera;
  }
  const FragmentImage fragments = scene.draw(camera, baseImage);
  parallelFor(edges.size(), 8, [&](size_t begin, size_t end) {
    for (size_t row = begin; row < end; ++row) {
      edges[row] = trimmedEdges(camera, static_cast<int>(row), fragments);
    }
  });
  return {base, right, edges};
}

/// Whether the second of four values in a row is so much smaller than the third, and by as much more than the slopes on
/// both sides explain.
bool steps(double before, double first, double second, double after, double least) {
  const double step = second - first;
  return step >= least && step - (first - before) >= least && step - (after - second) >= least;
}

}  // namespace

EocOptions EocOptions::literal() {
  EocOptions options;
  options.compact = false;
  options.backgroundReachPixels = 1;
  options.trim = false;
  options.edgeDepthStepRadii = kPaperDepthStepRadii;
  return options;
}

ViewSegment segmentAround(const View& view, const glm::vec3& direction, float lengthRadii) {
  const float length = glm::length(direction);
  if (!std::isfinite(length) || !(length > 0) || !std::isfinite(lengthRadii) || !(lengthRadii > 0)) {
    throw InputError("the view segment has no length or no direction", "view segment",
                     "give a positive length and a direction such as 1,0,0");
  }
  const glm::vec3 half = direction * (lengthRadii / 2 / length);
  const ViewSegment segment{movedEye(view, -half).eye, movedEye(view, half).eye};
  validate(segment, "view segment");
  return segment;
}

PinholeCamera basePinhole(const PinholeCamera& reference, const ViewSegment& segment, const Mesh& mesh) {
  return baseAround(reference, segment, mesh.positions);
}

std::vector<EpipolarEdge> findEpipolarEdges(const std::vector<float>& inverseZ, int row, const EpipolarLines& lines,
                                            float zNear, float backgroundInverseZ, const EocOptions& options) {
  std::vector<EpipolarEdge> edges;
  const int count = static_cast<int>(inverseZ.size());
  const double disparity = lines.disparity();
  const auto depthAt = [&](int j) {
    const float w = inverseZ[static_cast<size_t>(std::clamp(j, 0, count - 1))];
    return static_cast<double>(w > 0 ? w : backgroundInverseZ);
  };
  for (int j = 0; j + 1 < count; ++j) {
    const double near = inverseZ[static_cast<size_t>(j)];
    const double far = depthAt(j + 1);
    if (!(near > far) || !lines.has(row, j + 1)) {
      continue;
    }
    // Columns of base pixels that the segment uncovers for each 1/z of the step.
    const double x = lines.x(row, j + 1);
    const double scale = lines.inverseZScale(x);
    const double pixels = disparity * scale / (x - lines.x(row, j));
    const double least = static_cast<double>(options.minAddedPixels) / pixels;
    if (options.edgeDepthStepRadii > 0 ? !steps(1 / depthAt(j - 1), 1 / near, 1 / far, 1 / depthAt(j + 2),
                                                static_cast<double>(options.edgeDepthStepRadii))
                                       : !steps(-depthAt(j - 1), -near, -far, -depthAt(j + 2), least)) {
      continue;
    }
    if (lines.advance() > 0 && near * (lines.advance() + static_cast<double>(zNear)) >= 1) {
      continue;  // R is beyond the occluder
    }
    const double yNear = near * scale;
    const auto uncovered = [&](double y) { return j + 1 - lines.position(row, x - disparity * (yNear - y)); };
    double farthest = far;
    for (int k = j + 2; k < std::min(count, j + 1 + options.backgroundReachPixels); ++k) {
      const double other = inverseZ[static_cast<size_t>(k)];
      farthest = other > 0 ? std::min(farthest, other) : farthest;
    }
    int added = static_cast<int>(std::ceil(uncovered(farthest * scale)));
    // The first added ray, from the edge to the left and away: as far as it stays under what L sees.
    int clip = j + 1;
    while (clip > 0 && clip > j + 1 - added) {
      const double centre = lines.x(row, clip - 0.5);
      const double ray = (yNear - (x - centre) / disparity) / lines.inverseZScale(centre);
      if (!(ray < static_cast<double>(inverseZ[static_cast<size_t>(clip - 1)]))) {
        break;
      }
      --clip;
    }
    const int hidden = j + 1 - clip;
    added = options.compact ? std::min(added, hidden + options.compactSlackPixels) : added;
    // Not beyond the horizon of R, nor the end of the line.
    added = std::min(added, static_cast<int>(std::floor(uncovered(0))));
    while (added > 0 && !lines.has(row, j + 1 - added)) {
      --added;
    }
    if (hidden > 0 && added > 0) {
      edges.push_back({j + 1, clip, added, static_cast<float>(near)});
    }
  }
  return edges;
}

void requireOutsideEnds(const ViewSegment& segment, const Mesh& mesh) {
  validate(segment, "view segment");
  requireOutside(mesh, segment.left, "view segment, left end");
  requireOutside(mesh, segment.right, "view segment, right end");
}

EpipolarCamera buildEpipolarCamera(const PinholeCamera& reference, const ViewSegment& segment, const Mesh& mesh,
                                   const EocOptions& options, const SceneRenderer* renderer) {
  if (raysOf(renderer) == nullptr) {
    requireOutsideEnds(segment, mesh);
  }
  Scene scene(mesh, renderer);
  const PinholeCamera base = baseAround(reference, segment, scene.outerPoints());
  const EpipolarLines lines(base, segment.right);
  return cameraFrom(base, segment.right, lines, scene.lines(base, lines), scene, options);
}

ReferenceImage eocImage(const FragmentImage& fragments, const EpipolarCamera& camera, const Mesh& mesh) {
  const PinholeCamera& base = camera.base();
  const EpipolarLines& lines = camera.lines();
  ReferenceImage image = referenceImage(fragments, mesh, base, "eoc");
  image.pinholeSize = {base.width(), base.height()};
  image.rows = lines.isRing() ? ImageRows::kShiftedRing : ImageRows::kShifted;
  // Straight rays keep to the centres of base pixels: what referenceImage() leaves there is rounding.
  parallelFor(static_cast<size_t>(image.height()), 8, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const int row = static_cast<int>(i);
      for (int column = 0; column < image.width(); ++column) {
        const float z = image.t(column, row);
        const std::optional<EpipolarCamera::PlaneRay> ray = z > 0 ? camera.planeRay(row, column + 0.5) : std::nullopt;
        if (ray && lines.inverseZScale(ray->xFar) < ray->yFar * static_cast<double>(z)) {
          const glm::dvec2 place = lines.imagePoint({row + 0.5, lines.position(row, ray->xFar)});
          image.displacement(column, row) = glm::vec2(glm::dvec2(column + 0.5, row + 0.5) - place);
        }
      }
    }
  });
  return image;
}

ReferenceImage buildEocImage(const EpipolarCamera& camera, const Mesh& mesh, const SceneRenderer* renderer) {
  Scene scene(mesh, renderer);
  const FragmentImage baseImage = scene.lines(camera.base(), camera.lines());
  return eocImage(scene.draw(camera, baseImage), camera, mesh);
}

EocConstruction constructEoc(const PinholeCamera& reference, const ViewSegment& segment, const Mesh& mesh,
                             const EocOptions& options, const SceneRenderer* renderer) {
  if (raysOf(renderer) == nullptr) {
    requireOutsideEnds(segment, mesh);
  }
  Scene scene(mesh, renderer);
  const PinholeCamera base = baseAround(reference, segment, scene.outerPoints());
  const EpipolarLines lines(base, segment.right);
  const FragmentImage baseImage = scene.lines(base, lines);
  EpipolarCamera camera = cameraFrom(base, segment.right, lines, baseImage, scene, options);
  const FragmentImage fragments = options.trim ? scene.drawTrimmed(camera, baseImage) : scene.draw(camera, baseImage);
  ReferenceImage image = eocImage(fragments, camera, mesh);
  return {std::move(camera), std::move(image)};
}

ReferenceImage buildEocImage(const PinholeCamera& reference, const ViewSegment& segment, const Mesh& mesh,
                             const EocOptions& options, const SceneRenderer* renderer) {
  return constructEoc(reference, segment, mesh, options, renderer).image;
}

}  // namespace ocelli
