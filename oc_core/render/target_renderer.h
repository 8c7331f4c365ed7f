// Draws what rays can be cast at and is no mesh (ray_target.h), for all that constructs images from a SceneRenderer:
// the reference images of volumes, for example. Each hit becomes a point of a mesh, a triangle whose corners all lie
// there, so that fragments name hits as they name triangles.
#pragma once

#include <functional>

#include "oc_core/render/scene_renderer.h"

namespace ocelli {

class TargetRenderer final : public SceneRenderer {
 public:
  /// What of a ray lies behind the thing that it has hit, for images of several layers: empty where that is nothing.
  using Behind = std::function<RayPath(const RayPath& ray, const Hit& hit)>;

  /// The target must outlive it. Without `behind` there is one layer. Images are drawn one after the other: no two
  /// threads may draw at once, nor look at mesh() meanwhile.
  explicit TargetRenderer(const RayTarget& target, Behind behind = {});

  /// The points that have been hit so far, in the order of their images: the mesh that fragments of all of these are
  /// of.
  const Mesh& mesh() const { return hits_; }

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
  std::optional<std::vector<FragmentImage>> drawLayers(const PinholeCamera& camera, int layers) const override;
  const RayTarget* rays() const override { return &target_; }
  bool hasMesh() const override { return false; }

 private:
  /// As castRays(), with fragments of mesh().
  FragmentImage cast(int width, int height, const std::function<RayPath(const glm::vec2& pixel)>& ray) const;
  /// As raycast(), which see.
  FragmentImage cast(const CameraRays& rays, const FragmentImage& known) const;
  template <Camera C>
  FragmentImage cast(const C& camera, const FragmentImage& known) const;
  template <Camera C>
  FragmentImage cast(const C& camera) const;

  const RayTarget& target_;
  Behind behind_;
  mutable Mesh hits_;
};

}  // namespace ocelli
