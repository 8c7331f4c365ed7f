// How a reference image is constructed: by rasterisation, which draws all triangles, or by rays against a standing
// acceleration structure (raycast.h), which costs what its pixels cost, however large the scene.
#pragma once

#include <cstddef>
#include <string>

#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/render/scene_renderer.h"

namespace ocelli {

enum class Construction {
  kAuto,  ///< whichever is faster
  kRaster,
  kRays,
};

/// Number of triangles above which rays are faster than rasterisation, where the acceleration structure stands: CPU
/// time at 720x480, measured by bench/raycast_bench on `builtin:statues`. The cost of rasterisation grows in proportion
/// to the triangles.
struct RayCrossover {
  static constexpr size_t kDepthImage = 600'000;
  static constexpr size_t kSpoc = 0;
  static constexpr size_t kDdoc = 4'500'000;
  static constexpr size_t kEoc = 1'100'000;
  static constexpr size_t kCell = 400'000;
};

/// What there is to cast rays at.
enum class RayStructure {
  kNone,
  kStands,
  kRefits,  ///< it follows a scene that moves before each image (RayScene::update())
};

/// What refitting the structure for each image of a scene that moves takes, as a share of what it takes to draw its
/// triangles for the image: of the CPU times of bench/moving_scene_bench, one million triangles.
struct RefitShare {
  static constexpr double kDepthImage = 0.8;
  static constexpr double kOther = 0.25;  ///< of cameras that draw them more than once; eoc-h: 0.21 to 0.24
};

/// Of a structure that follows a scene that moves.
struct RefitCost {
  double share = RefitShare::kOther;
  size_t pixels = 0;  ///< of the image
};

/// Whether to construct by rays. The cost of rays grows with the pixels, that of refitting and of drawing with the
/// triangles; so images of what moves that are made smaller, as time runs short, are sooner cast than drawn. Where no
/// acceleration structure stands, kAuto rasterises: to build the structure takes longer than to draw all triangles of
/// any scene once. Only a cell camera, which draws many views, would gain.
bool constructWithRays(Construction wanted, size_t crossover, size_t triangleCount, RayStructure structure,
                       const RefitCost& refit = {});

/// Throws InputError, naming `where`, for anything but "auto", "raster" and "rays".
Construction constructionFromText(const std::string& text, const std::string& where);

/// How reference images were constructed.
struct ConstructionReport {
  bool byRays = false;
  size_t triangles = 0;     ///< of the scene
  double buildSeconds = 0;  ///< what the acceleration structure took, where it did not stand
};

/// For a message: "by rays (BVH of 1,071,000 triangles built in 0.5 s)" or "by rasterisation".
std::string describe(const ConstructionReport& report);

/// What the pinhole sees: by `renderer` where there is one.
FragmentImage seenFrom(const PinholeCamera& camera, const Mesh& mesh, const SceneRenderer* renderer);

}  // namespace ocelli
