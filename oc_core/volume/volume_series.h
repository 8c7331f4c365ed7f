// Volumes of one thing at several times: recordings. A source with one volume is a series of one.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "oc_core/volume/volume_scene.h"

namespace ocelli {

struct TransferDescription;  // transfer_file.h

struct VolumeSeries {
  std::string source;
  std::vector<std::shared_ptr<const ScalarVolume>> volumes{};  ///< at least 1; all of one grid and type
  std::vector<double> times{};                                 ///< s, rising, one a volume; empty where there is one
  std::optional<VolumeAppearance> appearance{};  ///< of a made volume: what it looks like unless the user says another
  std::vector<std::string> warnings{};           ///< what the user should know of, a sentence each

  /// The last volume that begins at that time or before it. Throws InputError where the series has no such time.
  size_t indexAt(double seconds) const;
};

/// Throws as loadVolumeScene() does. What it gives is mapped or made, and not looked at yet. `series` is that of
/// VolumeSceneOptions.
VolumeSeries loadVolumeSeries(const std::string& source, const std::string& series = {}, const Progress& progress = {});

/// One of its volumes as a scene; `options.seconds` and `options.series` are not looked at. Where the transfer function
/// is relative to a volume's values, that is the first one for all times: nothing flickers. Throws as loadVolumeScene()
/// does.
VolumeScene volumeSceneAt(const VolumeSeries& series, size_t index, const VolumeSceneOptions& options = {},
                          const Progress& progress = {});
/// The same with a transfer function that stands in no file, in place of `options.transfer`.
VolumeScene volumeSceneAt(const VolumeSeries& series, size_t index, const TransferDescription& transfer,
                          const VolumeSceneOptions& options = {}, const Progress& progress = {});

}  // namespace ocelli
