// How solid a scene looks on a display that emits light and hides nothing: what is observed against the image that an
// opaque scene would give, and the share of the light that comes from surfaces which should be hidden. docs/metrics.md
// defines every figure.
//
// The opaque images are rendered once, and shared by all that is measured.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "display_sim/frames/volume.h"
#include "display_sim/solidity/eye_groups.h"
#include "display_sim/solidity/solid_reference.h"
#include "oc_core/base/progress.h"
#include "oc_core/image/png_file.h"
#include "oc_core/scene/mesh.h"

namespace ocelli {

struct SolidityOptions {
  DisplayProfile profile;
  std::vector<EyeGroup> groups;  ///< at least one, none empty; exposures suit the first eye
  /// Of the square images, pixels; 0: as many as the display has rows, so that a voxel is about a pixel.
  int imageSide = 0;
};

/// Sums over eyes, and their means.
struct SolidityErrors {
  size_t eyes = 0;
  double light = 0;        ///< of all three channels and pixels
  double hiddenLight = 0;  ///< of it from surfaces that should be hidden
  double squaredError = 0;
  double ssim = 0;
  double flip = 0;

  SolidityErrors& operator+=(const SolidityErrors& other);
  double hiddenShare() const { return light > 0 ? hiddenLight / light : 0; }
  /// Of the mean squared error over all eyes; infinite where no pixel differs.
  double psnrDecibels() const;
  double meanSsim() const { return ssim / static_cast<double>(eyes); }
  double meanFlip() const { return flip / static_cast<double>(eyes); }
};

struct SolidityFigures {
  std::string name;
  size_t triangles = 0;
  size_t litVoxels = 0;
  double gain = 0;                     ///< for all eyes
  std::vector<SolidityErrors> groups;  ///< as those of the options
};

/// What one eye sees, with the gain of the figures.
struct ObservedFrame {
  size_t group = 0;
  size_t eye = 0;  ///< in its group
  const Image<Rgb8>& opaque;
  const Image<Rgb8>& observed;
  const Image<Rgb8>& hidden;  ///< of it the light of surfaces that should be hidden
};

class SolidityMeter {
 public:
  using Visitor = std::function<void(const ObservedFrame&)>;

  enum class Shown {
    kEverything,
    kVisibleOnly,  ///< for each eye without the voxels that are hidden from it: what no display for several eyes shows
  };

  /// `scene` must outlive it; it is what the opaque images show, and what hides voxels. Throws InputError for eyes in
  /// the display.
  SolidityMeter(const Mesh& scene, const SolidityOptions& options);
  /// The same of anything that has an opaque truth, which must outlive it.
  SolidityMeter(const SolidReference& truth, const SolidityOptions& options);
  ~SolidityMeter();
  SolidityMeter(const SolidityMeter&) = delete;
  SolidityMeter& operator=(const SolidityMeter&) = delete;

  /// Of a display that shows `volume`, which has the profile of the options, sliced from so many triangles. `visit` may
  /// be empty.
  SolidityFigures measure(const std::string& name, const Volume& volume, size_t triangles,
                          Shown shown = Shown::kEverything, const Progress& progress = {}, const Visitor& visit = {});

 private:
  struct Impl;
  std::unique_ptr<SolidReference> surfaces_;  ///< of a mesh
  std::unique_ptr<Impl> impl_;
};

}  // namespace ocelli
