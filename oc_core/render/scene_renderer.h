// What cameras see of one scene, drawn by other means than rasterisation on the CPU: by rays against a standing
// acceleration structure (RayRenderer) or against what is no mesh (target_renderer.h), or on a GPU
// (oc_core/gl/gl_renderer.h). What constructs an image from others
// (oc_core/ocri) takes it as a pointer; without one it rasterises.
//
// One call draws one image: within it, renderers know the type of the camera. So this set of types is closed: a camera
// that OpenGL, and ranks together, are to draw takes an overload here and in each renderer. All others are drawn along
// their rays (oc_core/ocri/cast_representation.h).
#pragma once

#include <optional>
#include <vector>

#include "oc_core/camera/curved_ray_camera.h"
#include "oc_core/camera/ddoc_camera.h"
#include "oc_core/camera/epipolar_camera.h"
#include "oc_core/camera/gpc_camera.h"
#include "oc_core/camera/graph_camera.h"
#include "oc_core/camera/reverse_pinhole_camera.h"
#include "oc_core/camera/spoc_camera.h"
#include "oc_core/render/rasterize_subdivided.h"
#include "oc_core/render/raycast.h"

namespace ocelli {

class SceneRenderer {
 public:
  virtual ~SceneRenderer() = default;

  /// The closest fragment at each pixel.
  virtual FragmentImage draw(const PinholeCamera& camera) const = 0;
  virtual FragmentImage draw(const SpocCamera& camera) const = 0;
  virtual FragmentImage draw(const ReversePinholeCamera& camera) const = 0;
  virtual FragmentImage draw(const GpcCamera& camera) const = 0;
  /// `seen` is what the reference pinhole sees; `subdivision` is for those that draw by it.
  virtual FragmentImage draw(const DdocCamera& camera, const FragmentImage& seen,
                             const SubdivisionOptions& subdivision) const = 0;
  /// What `base` sees along its epipolar lines (rasterize_spans.h).
  virtual FragmentImage drawLines(const PinholeCamera& base, const EpipolarLines& lines) const = 0;
  /// `baseImage` is what drawLines() gives for the base and the lines of the camera.
  virtual FragmentImage draw(const EpipolarCamera& camera, const FragmentImage& baseImage) const = 0;
  /// The same, where the disocclusions of the camera lie within those of the epipolar camera that was drawn before.
  virtual FragmentImage drawTrimmed(const EpipolarCamera& camera, const FragmentImage& baseImage) const {
    return draw(camera, baseImage);
  }
  virtual FragmentImage draw(const GraphCamera& camera) const = 0;
  virtual FragmentImage draw(const CurvedRayCamera& camera) const = 0;

  /// What the rays of any camera meet, where this casts rays.
  virtual std::optional<FragmentImage> drawAlong(const CameraRays& /*rays*/) const { return std::nullopt; }
  /// The closest fragments of each pixel in order, one image a layer, where this can tell what lies behind the first;
  /// otherwise the mesh tells it (rasterize_layers.h).
  virtual std::optional<std::vector<FragmentImage>> drawLayers(const PinholeCamera& /*camera*/, int /*layers*/) const {
    return std::nullopt;
  }

  /// What this casts rays at, where it does: with it, a caller need not look at all triangles.
  virtual const RayTarget* rays() const { return nullptr; }
  /// Whether what this draws is a mesh. Where not, all that is known of it is what rays() meet.
  virtual bool hasMesh() const { return true; }
};

/// The rays of `base` along its epipolar lines, a row of pixels a line; both must outlive it.
std::function<RayPath(const glm::vec2& pixel)> raysOfLines(const PinholeCamera& base, const EpipolarLines& lines);
/// Gives fragments the z of their points as their t.
void takeDepths(FragmentImage& fragments, const PinholeCamera& camera, const Mesh& mesh);

/// Casts rays: the cost is bounded by the pixels, however large the scene.
class RayRenderer final : public SceneRenderer {
 public:
  /// Both must outlive it.
  RayRenderer(const Mesh& mesh, const RayScene& rays) : mesh_(mesh), rays_(rays) {}

  FragmentImage draw(const PinholeCamera& camera) const override;
  FragmentImage draw(const SpocCamera& camera) const override;
  FragmentImage draw(const ReversePinholeCamera& camera) const override;
  FragmentImage draw(const GpcCamera& camera) const override;
  FragmentImage draw(const DdocCamera& camera, const FragmentImage& seen,
                     const SubdivisionOptions& subdivision) const override;
  FragmentImage drawLines(const PinholeCamera& base, const EpipolarLines& lines) const override;
  FragmentImage draw(const EpipolarCamera& camera, const FragmentImage& baseImage) const override;
  FragmentImage draw(const GraphCamera& camera) const override;
  FragmentImage draw(const CurvedRayCamera& camera) const override;
  std::optional<FragmentImage> drawAlong(const CameraRays& rays) const override;
  const RayScene* rays() const override { return &rays_; }

 private:
  const Mesh& mesh_;
  const RayScene& rays_;
};

}  // namespace ocelli
