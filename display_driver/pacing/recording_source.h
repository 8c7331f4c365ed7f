// The frames of a `.svol` file at their own times.
#pragma once

#include <filesystem>
#include <optional>

#include "display_driver/pacing/volume_source.h"
#include "display_sim/frames/svol_player.h"
#include "display_sim/frames/svol_reader.h"
#include "display_sim/frames/volume_pool.h"

namespace ocelli {

class RecordingSource final : public VolumeSource {
 public:
  /// The first frame is seen first, and the others as much later as they come later in the file. `loop`: after the last
  /// one it begins again. A single frame stays, without an end. Throws InputError where the file cannot be read or has
  /// no frame; so does volumeFor() where a frame is damaged.
  RecordingSource(const std::filesystem::path& path, bool loop);

  const DisplayProfile& profile() const { return reader_.profile(); }
  size_t frames() const { return reader_.frames().size(); }

  SourcedVolume volumeFor(HostTime seen) override;

 private:
  SvolReader reader_;
  SvolPlayer player_;
  VolumePool copies_;  ///< the player makes the next volume from the last one
  bool loop_;
  std::optional<HostTime> start_;
  std::optional<size_t> frame_;
};

}  // namespace ocelli
