// A swept-screen volumetric display as data: a flat screen that turns about its vertical middle line and shows one
// slice after the other. The reference display is that of dissertation section 3.5.5.6.
//
// To add a profile:
//   1. write `display_sim/frames/profiles/NAME.json` (its fields: `display_profile.schema.json` beside it);
//   2. add NAME to OCELLI_PROFILES in `display_sim/frames/CMakeLists.txt`, which compiles it in.
// Nothing else: `ocelli slice --profile NAME` and the tests of every profile find it there. A profile of your own needs
// no build: `--profile FILE.json`.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace ocelli {

enum class SecondHalfTurn {
  kMirrored,  ///< shows the slices of the first half turn again, mirrored left to right
  kOwn,       ///< has slices of its own, at the same planes but dithered on their own
};

enum class ChannelTiming {
  kTogether,  ///< red, green and blue of a slice are on during its whole arc
  kInTurn,    ///< red during the first third of the arc, green during the second, blue during the last
};

struct DisplayProfile {
  std::string name;
  double radiusMetres = 0.127;
  double halfHeightRadii = 1;  ///< the rows span y from +halfHeightRadii (row 0) to -halfHeightRadii
  int slicesPerHalfTurn = 0;   ///< N of the conventions: slice i lies at i pi / N
  int width = 0;
  int height = 0;
  int colorBitsPerChannel = 1;  ///< 1 to 8; levels are equal steps of light
  ChannelTiming channelTiming = ChannelTiming::kTogether;
  double rotationsPerMinute = 720;
  SecondHalfTurn secondHalfTurn = SecondHalfTurn::kMirrored;
  double viewingDistanceMetres = 1.27;

  /// Slices that a volume holds: those of a half turn, or of a whole turn where the second half has its own.
  int storedSlices() const;
  /// Of all bit planes of a volume.
  size_t volumeBytes() const;
  /// How often a second every stored slice has been shown once.
  double refreshHertz() const;
  double viewingDistanceRadii() const { return viewingDistanceMetres / radiusMetres; }

  bool operator==(const DisplayProfile&) const = default;
};

/// A volume never takes more memory than this; profiles that ask for more are refused.
inline constexpr size_t kMaxVolumeBytes = size_t{1} << 31;
inline constexpr int kMaxSliceSide = 4096;

/// Throws InputError naming the field that is missing, unknown or out of range.
DisplayProfile profileFromJsonText(const std::string& text, const std::string& where);
DisplayProfile readProfile(const std::filesystem::path& path);
/// The same profile always gives the same text, on one line.
std::string jsonText(const DisplayProfile& profile);

/// Names of the profiles that are compiled in, in the order of the recipe's list.
const std::vector<std::string>& builtinProfileNames();
/// What `--profile` takes: the name of a compiled-in profile, or a file whose name ends in `.json`. Throws InputError.
DisplayProfile loadProfile(const std::string& nameOrFile);

}  // namespace ocelli
