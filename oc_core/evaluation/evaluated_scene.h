// What representations are measured against: what a scene shows from a viewpoint, and where its surfaces are. A mesh,
// or whatever else rays can be cast at.
#pragma once

#include <utility>

#include "oc_core/evaluation/frame_errors.h"
#include "oc_core/ocri/representation.h"
#include "oc_core/render/target_renderer.h"

namespace ocelli {

/// Its functions may be called from several threads.
class EvaluatedScene {
 public:
  virtual ~EvaluatedScene() = default;

  virtual ViewFrame frame(const PinholeCamera& camera) const = 0;
  /// Whether a point of a surface, seen or hidden, lies within `reach` of `point`.
  virtual bool hasSurfaceNear(const glm::vec3& point, float reach) const = 0;
  /// Throws InputError where the eye lies where none can be.
  virtual void requireViewpoint(const glm::vec3& eye) const = 0;
  /// Of the depth image of a view: what others are compared with.
  virtual Mesh depthImageMesh(const PinholeCamera& reference) const = 0;
  /// Throws as buildRepresentation() does.
  virtual Representation represent(const CameraChoice& choice, const PinholeCamera& reference, const Progress& progress,
                                   RepresentationTimes* times) const = 0;
};

class MeshScene final : public EvaluatedScene {
 public:
  /// The mesh must outlive it.
  explicit MeshScene(const Mesh& mesh) : mesh_(mesh), rays_(mesh) {}

  ViewFrame frame(const PinholeCamera& camera) const override { return renderFrame(camera, mesh_); }
  bool hasSurfaceNear(const glm::vec3& point, float reach) const override { return rays_.hasSurfaceNear(point, reach); }
  void requireViewpoint(const glm::vec3& eye) const override;
  Mesh depthImageMesh(const PinholeCamera& reference) const override;
  Representation represent(const CameraChoice& choice, const PinholeCamera& reference, const Progress& progress,
                           RepresentationTimes* times) const override {
    return buildRepresentation(choice, reference, mesh_, progress, times);
  }

 private:
  const Mesh& mesh_;
  RayScene rays_;
};

/// What rays hit first, from wherever they come. An eye may be anywhere.
class TargetScene final : public EvaluatedScene {
 public:
  /// The target must outlive it.
  TargetScene(const RayTarget& target, TargetRenderer::Behind behind, SurfaceSearch hasSurfaceNear)
      : target_(target), behind_(std::move(behind)), hasSurfaceNear_(std::move(hasSurfaceNear)) {}

  ViewFrame frame(const PinholeCamera& camera) const override { return renderFrame(camera, target_); }
  bool hasSurfaceNear(const glm::vec3& point, float reach) const override { return hasSurfaceNear_(point, reach); }
  void requireViewpoint(const glm::vec3& /*eye*/) const override {}
  Mesh depthImageMesh(const PinholeCamera& reference) const override;
  Representation represent(const CameraChoice& choice, const PinholeCamera& reference, const Progress& progress,
                           RepresentationTimes* times) const override {
    return buildRepresentation(choice, reference, TargetRenderer(target_, behind_), progress, times);
  }

 private:
  const RayTarget& target_;
  TargetRenderer::Behind behind_;
  SurfaceSearch hasSurfaceNear_;
};

}  // namespace ocelli
