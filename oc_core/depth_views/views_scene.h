// A scene whose representations are made from views with depth of it, and measured against the scene itself.
#pragma once

#include "oc_core/evaluation/evaluated_scene.h"

namespace ocelli {

class ViewsScene final : public EvaluatedScene {
 public:
  /// `surface` is that of the views (views_surface.h), in the coordinates of the scene. Both must outlive it.
  ViewsScene(const Mesh& scene, const Mesh& surface) : truth_(scene), surface_(surface) {}

  ViewFrame frame(const PinholeCamera& camera) const override { return truth_.frame(camera); }
  bool hasSurfaceNear(const glm::vec3& point, float reach) const override {
    return truth_.hasSurfaceNear(point, reach);
  }
  void requireViewpoint(const glm::vec3& eye) const override { truth_.requireViewpoint(eye); }
  /// Of the scene: what all others are compared with.
  Mesh depthImageMesh(const PinholeCamera& reference) const override { return truth_.depthImageMesh(reference); }
  Representation represent(const CameraChoice& choice, const PinholeCamera& reference, const Progress& progress,
                           RepresentationTimes* times) const override;

 private:
  MeshScene truth_;
  const Mesh& surface_;
};

}  // namespace ocelli
