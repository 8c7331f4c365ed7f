// Writes `.svol` files, frame after frame (docs/svol.md).
//
//   SvolWriter writer("demo.svol", profile, {.growing = true});
//   for (...) writer.append(volume, microseconds);
//   writer.finish();
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "display_sim/frames/display_profile.h"
#include "display_sim/frames/svol_format.h"
#include "display_sim/frames/volume.h"
#include "oc_core/base/output_file.h"

namespace ocelli {

struct SvolOptions {
  /// A JSON object: what made the volumes (`software`, `scene`, `dither`, ...). At most 1 MiB.
  std::string metadata = "{}";
  /// Every so many frames one needs no other: jumps into the file start there. 1: all of them.
  int framesPerKey = 48;
  /// For recordings: the file stands under its name from the start, and whatever ends the program, it opens up to the
  /// last whole frame. Otherwise it appears with finish().
  bool growing = false;
};

/// The same frames give the same bytes, with any number of threads (as long as the version of zstd is the same).
class SvolWriter {
 public:
  /// Throws WorkError where the file cannot be made, and InputError for metadata of another kind.
  SvolWriter(std::filesystem::path path, const DisplayProfile& profile, SvolOptions options = {});

  /// A volume of the writer's profile, shown from this time on; times never decrease, and stay below 2^53. Slices are
  /// left out, written as differences or whole, by what has changed since the frame before. Throws WorkError where the
  /// disk is full: what was written before stays readable, and nothing more can be written.
  void append(const Volume& volume, uint64_t timeMicroseconds);
  /// Writes the index. Call it after the last frame; a growing file without it is an unfinished recording.
  void finish();

  size_t frames() const { return frames_.size(); }
  /// Of the file so far.
  uint64_t bytes() const { return bytes_; }

 private:
  void write(std::span<const uint8_t> bytes);
  void requireUsable() const;

  std::filesystem::path path_;
  SvolOptions options_;
  OutputFile file_;
  DisplayProfile profile_;
  std::optional<Volume> previous_;  ///< kept where there are other than key frames
  std::vector<SvolFrame> frames_;
  uint64_t bytes_ = 0;
  bool usable_ = true;  ///< false after a failure and after finish()
};

}  // namespace ocelli
