// A volume as a scene: where it stands, what its values look like, and how it is lit.
#pragma once

#include <functional>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "oc_core/base/progress.h"
#include "oc_core/scene/mesh.h"
#include "oc_core/volume/scalar_volume.h"
#include "oc_core/volume/transfer_function.h"
#include "oc_core/volume/volume_levels.h"

namespace ocelli {

/// How places of a volume are lit: a fixed light from where the fixed light of meshes is (scene/shading.h), by the
/// gradient of the field. The colour of a place is multiplied by what comes of it.
struct VolumeShading {
  bool isOn = false;  ///< off: colours as the transfer function has them
  double ambient = 0.3;
  double diffuse = 0.7;
  double specular = 0.2;  ///< added, in white
  double shininess = 20;
};

/// Where the gradient, by the mean distance of voxels, is below this share of the volume's range of values, a place is
/// flat: it has no direction, and is not lit.
inline constexpr double kFlatShare = 1e-3;

/// What a volume looks like.
struct VolumeAppearance {
  TransferFunction transfer;
  VolumeShading shading{};
};

/// A half space of the world that is shown: where dot(normal, p) >= distance.
struct ClipPlane {
  glm::dvec3 normal{1, 0, 0};  ///< of length 1
  double distance = 0;
};

struct VolumeScene {
  std::shared_ptr<const ScalarVolume> volume;
  glm::dmat4 worldFromIndex{1};  ///< affine: where the volume stands in the scene, from index coordinates
  VolumeAppearance appearance;
  std::vector<ClipPlane> clips{};  ///< of the volume alone
  Mesh surfaces{};                 ///< opaque, in the scene's world; or none
  /// What `volume` is a coarser level of; the same volume where it is none.
  std::shared_ptr<const ScalarVolume> whole{};
  int levelFactor = 1;          ///< voxels of `whole` along each edge of one of `volume`
  std::vector<double> times{};  ///< s: those of the time series that it is a moment of; or empty

  /// How much of the scene's lengths the unit of the grid's world is: extinctions by the scene's lengths are those of
  /// the transfer function divided by this.
  double sceneLengthOfUnit() const;
  /// The mean distance of the voxels of the whole, in the unit of the grid's world: the length that a transfer function
  /// without one of its own means.
  double voxelSpacing() const { return (whole ? whole : volume)->grid().meanSpacing(); }
  Box bounds() const { return boundsOf(volume->grid(), worldFromIndex); }
};

struct VolumeSceneOptions {
  bool fit = true;         ///< its box into the unit sphere, as meshes
  std::string transfer{};  ///< a preset's name or a file's; empty: what fits the volume
  std::vector<ClipPlane> clips{};
  std::string series{};  ///< of a folder of DICOM files with several: its UID or its number
  /// Of a time series: its moment, s, which shows the last volume that begins by then; nothing: the first one.
  std::optional<double> seconds{};
  LevelOptions level{};  ///< of volumes larger than memory
  /// Is told what the user should know of the volume, a sentence each.
  std::function<void(const std::string&)> warn{};
};

/// Whether a SCENE is a volume: `builtin:volume,...`, or a file or a folder that isVolumeFile() knows
/// (volume_reader.h).
bool isVolumeSource(const std::string& source);

/// Throws InputError for what is wrong with the source, the transfer function or a file, for voxels that are no
/// numbers, and for a moment that it does not have. Of a volume that is shown by a coarser level, only the voxels that
/// the level is made of are looked at: all, for means.
VolumeScene loadVolumeScene(const std::string& source, const VolumeSceneOptions& options = {},
                            const Progress& progress = {});

}  // namespace ocelli
