// The ways to tell how much of a light is seen, by name: "traced" (1,024 rays), "traced-N", "outlines" (of the geometry
// itself), "pcss" and "backprojection" (of the plain shadow map), and the outlines of any camera's reference images.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "oc_core/base/progress.h"
#include "oc_core/ocri/view_cell.h"
#include "oc_core/shade/shaded_scene.h"
#include "oc_core/soft_shadows/area_visibility.h"

namespace ocelli {

inline constexpr int kTracedShadowRays = 1024;

struct ShadowInputs {
  const ShadedScene& scene;        ///< with a light
  const PinholeCamera& reference;  ///< of shadow maps and reference images: lightView()
  ViewCell cell;                   ///< that reference images are made for: the light lies in it
  int lightSide = 32;              ///< rows of the samples of the light
  const Progress& progress;
};

struct BuiltShadow {
  std::string name;
  std::shared_ptr<const Mesh> occluders = {};  ///< of rays, which refer to it
  std::unique_ptr<AreaVisibility> visibility = {};
  double buildMilliseconds = 0;      ///< of images
  double structureMilliseconds = 0;  ///< of edges and their hierarchy, and of acceleration structures
  size_t samples = 0;                ///< of images
  size_t edges = 0;
};

/// Throws InputError for another name, and where images cannot be built.
BuiltShadow buildShadow(const std::string& name, const ShadowInputs& inputs);

/// Throws as buildShadow() does for a name that it does not take.
void checkShadowName(const std::string& name);

/// The names that buildShadow() takes, without "traced", its numbers and files of cameras.
std::vector<std::string> shadowNames();

/// What hides light: what casts, and billboards.
Mesh shadowOccluders(const ShadedScene& scene);

}  // namespace ocelli
