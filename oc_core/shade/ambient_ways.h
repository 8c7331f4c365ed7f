// The ways in which ambient light is drawn: rays at the geometry, horizons in depth buffers, rays at reference images.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "oc_core/base/progress.h"
#include "oc_core/shade/ambient_scene.h"

namespace ocelli {

struct AmbientLight {
  std::vector<float> light;      ///< of each point of the sight
  size_t samples = 0;            ///< of the images that tell what hides light; 0 where the geometry does
  double buildMilliseconds = 0;  ///< of images and structures, but for the geometry's acceleration structure
  double lightMilliseconds = 0;  ///< of all points, on all threads: the least of the runs
};

/// What a user sets.
struct AmbientSettings {
  std::optional<double> radius = {};      ///< AmbientOptions::radius; by default AmbientScene::defaultRadius()
  std::optional<double> splitShare = {};  ///< SplitCurve::share() of the splitting point, instead of the curve's
  double turnDegrees = ThreeFrustaOptions{}.turnDegrees;
  /// Of the viewpoints of occlusion cameras, world units; by default 1.2 of the eye's distance from the scene's middle.
  std::optional<float> cellSide = {};
};

struct AmbientInputs {
  const AmbientScene& scene;
  const AmbientSight& sight;
  AmbientSettings settings;
  const Progress& progress;
};

/// Rays a point of the traced light, and of those at images.
inline constexpr int kTruthRays = 256;
inline constexpr int kImageRays = 64;

/// `way` is
///   traced         rays at the geometry: kTruthRays; traced-N: N
///   horizon        horizons in the view's own depth buffer
///   horizon-wide   with a border of a quarter of the picture's height around it
///   graph          horizons in the image of three frusta (three_frusta.h) with the same border; points that it does
///                  not hold take those of the view with that border
///   graph-rays     rays at the samples of the same image
///   NAME:horizon   horizons in the image of a graph camera: a constructor's name or a JSON file
///   NAME           rays at the reference images of a camera, for the view with that border: a name, or a JSON file of
///                  an occlusion camera or a graph camera
/// Throws InputError for another, and where images cannot be built.
AmbientLight ambientLightBy(const std::string& way, const AmbientInputs& inputs, int runs = 1);

/// Throws as ambientLightBy() does for a way that there is not.
void checkAmbientWay(const std::string& way);

}  // namespace ocelli
