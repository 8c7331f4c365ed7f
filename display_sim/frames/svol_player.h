// Plays a `.svol` file: the volume of any frame, and what changed since the one before.
//
//   SvolReader reader("demo.svol");
//   SvolPlayer player(reader);
//   for (size_t k = 0; k < reader.frames().size(); ++k) {
//     player.seek(k);
//     send(player.volume(), player.changed());
//   }
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "display_sim/frames/svol_reader.h"
#include "display_sim/frames/volume.h"

namespace ocelli {

class SvolPlayer {
 public:
  /// All voxels are dark before the first seek(). The reader outlives the player.
  explicit SvolPlayer(SvolReader& reader);

  /// Brings volume() to this frame. To the next one that costs what changed; elsewhere it starts from a key frame.
  /// Throws InputError; then volume() may hold anything until the next seek() that succeeds.
  void seek(size_t frame);

  const Volume& volume() const { return volume_; }
  /// The slices that the last seek() changed, in their order. To the next frame these are exactly the slices that
  /// differ; over several frames also those that have changed back on the way.
  const std::vector<int>& changed() const { return changed_; }

 private:
  void apply(size_t frame, std::vector<uint8_t>& changed);

  SvolReader& reader_;
  Volume volume_;
  std::optional<size_t> frame_;  ///< that volume_ holds
  std::vector<int> changed_;
  std::vector<uint8_t> payloads_;
};

}  // namespace ocelli
