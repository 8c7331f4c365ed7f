// A scene whose ambient light is drawn, and what a view of it shows.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "oc_core/ambient/ambient_options.h"
#include "oc_core/ambient/ambient_points.h"
#include "oc_core/ambient/three_frusta.h"
#include "oc_core/render/raycast.h"
#include "oc_core/shade/shaded_scene.h"

namespace ocelli {

struct AmbientScene {
  /// The radius is defaultRadius() where none is given.
  AmbientScene(std::shared_ptr<const ShadedScene> shaded, std::optional<double> radius);

  /// 0.15 of the diagonal of all objects: 0.3 where they fill the unit sphere.
  static double defaultRadius(const Box& bounds);
  const Mesh& mesh() const { return shaded->whole.mesh; }
  /// Whether light is measured on a triangle: on objects with the role `receive`, on all where none has it.
  bool receives(uint32_t triangle) const;

  std::shared_ptr<const ShadedScene> shaded;
  RayScene rays;
  SplitCurve curve;
  Box bounds;
  AmbientOptions options;
  bool allReceive = true;
};

/// What a view shows of it.
struct AmbientSight {
  AmbientSight(const AmbientScene& scene, const PinholeCamera& camera);

  PinholeCamera camera;
  FragmentImage seen;
  std::vector<AmbientPoint> points;
};

}  // namespace ocelli
