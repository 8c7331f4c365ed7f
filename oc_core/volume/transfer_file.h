// Transfer functions as people write and keep them: JSON files (transfer_function.schema.json), which fit many volumes.
//
// The values of their points stand on one of the scales of transferScales(): absolute, as voxels mean them (CT, in
// Hounsfield units), or relative to the range or to percentiles of a volume (MRI, whose values have no unit).
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "oc_core/volume/volume_scene.h"

namespace ocelli {

/// What the values of points mean, for one volume.
struct TransferScale {
  std::string_view name;     ///< as files write it
  std::string_view summary;  ///< one line
  /// The values of the volume that a point's value of 0 and of 1 stand for; linear between and beyond.
  ValueRange (*zeroAndOne)(const ScalarVolume& volume);
};
const std::vector<TransferScale>& transferScales();

/// A transfer function that may not know its volume yet.
struct TransferDescription {
  static constexpr size_t kMaxPoints = 1024;
  static constexpr double kMaxValue = 1e12;  ///< and -kMaxValue the least
  static constexpr double kMinOpacityLength = 1e-9;
  static constexpr double kMaxOpacityLength = 1e9;
  static constexpr double kMaxShade = 4;  ///< of ambient, diffuse and specular light
  static constexpr double kMinShininess = 1;
  static constexpr double kMaxShininess = 1000;

  std::string scale = "absolute";  ///< a name of transferScales()
  std::vector<TransferPoint> points{};
  /// In the unit of the volume's world; none: the mean distance of its voxels (VolumeGrid::meanSpacing()).
  std::optional<double> opacityLength{};
  VolumeShading shading{};
};

/// Throws InputError, naming file, line and field, for what the schema does not allow, and for points out of order.
TransferDescription readTransferFile(const std::filesystem::path& path);
TransferDescription transferFromJsonText(const std::string& text, const std::string& where);

/// The text of a file that is read as the same description, but for rounding: colours that bytes of sRGB stand for are
/// written as "#rrggbb", and numbers with 9 digits.
std::string transferToJsonText(const TransferDescription& description);

/// What it is for a volume. Where it says no opacity length, `meanSpacing` is it: that of the volume, or, of a coarse
/// level of one, that of the whole, so that no level is more transparent than another. Where hasScaleFor() is false,
/// all is clear: no point of a relative scale says more of the one value that there is than any other.
VolumeAppearance appearanceOf(const TransferDescription& description, const ScalarVolume& volume, double meanSpacing);

/// Whether the volume's values have a 0 and a 1 on the scale of the description: on a relative one, a volume of one
/// value has none.
bool hasScaleFor(const TransferDescription& description, const ScalarVolume& volume);

/// The same appearance with absolute values.
TransferDescription describe(const VolumeAppearance& appearance);

}  // namespace ocelli
