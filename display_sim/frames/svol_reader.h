// Opens `.svol` files and reads any frame and slice of them (docs/svol.md). svol_player.h plays them.
//
// The reader trusts nothing: what it returns has passed its checksum, and any wrong byte is an InputError that names
// the file, the frame, the slice, the byte and the problem. It takes no more memory than one frame of the display.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <istream>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "display_sim/frames/display_profile.h"
#include "display_sim/frames/svol_format.h"
#include "display_sim/frames/volume.h"
#include "oc_core/base/error.h"

namespace ocelli {

enum class SvolEnding {
  kFinished,    ///< with an index
  kUnfinished,  ///< a recording that was cut short, or one that still grows: whole frames, perhaps a part of another
  kDamaged,     ///< a record is wrong: damage() tells which; the frames before it can be read
};

class SvolReader {
 public:
  /// Throws InputError where the header is not right. What comes later may be damaged or missing: see ending().
  explicit SvolReader(const std::filesystem::path& path);
  /// From a seekable stream that outlives the reader; `where` names it in errors.
  SvolReader(std::istream& in, std::string where);
  SvolReader(const SvolReader&) = delete;
  SvolReader& operator=(const SvolReader&) = delete;

  const DisplayProfile& profile() const { return profile_; }
  const VolumeLayout& layout() const { return layout_; }
  /// A JSON object (svol_metadata.h).
  const std::string& metadata() const { return metadata_; }

  const std::vector<SvolFrame>& frames() const { return frames_; }
  /// The frame that is shown at this time: the last one that does not begin later, or the first.
  size_t frameAt(uint64_t timeMicroseconds) const;
  /// From the first frame's time to one refresh of the display after the last one's; 0 without frames.
  uint64_t durationMicroseconds() const { return durationMicroseconds(frames_.size()); }
  /// Of the first so many frames.
  uint64_t durationMicroseconds(size_t frames) const;

  SvolEnding ending() const { return ending_; }
  /// Has a value where ending() is kDamaged.
  const std::optional<InputError>& damage() const { return damage_; }
  uint64_t fileBytes() const { return fileBytes_; }
  /// Up to the end of the last whole frame.
  uint64_t wholeBytes() const { return framesEnd_; }
  const std::string& where() const { return where_; }

  /// Brings the bit planes of a slice (layout().sliceBytes) to what they are in this frame.
  void readSlice(size_t frame, int slice, std::span<uint8_t> planes);

  /// For those that follow a file frame by frame: how a frame holds its slices, and its payloads one after the other.
  svol::FrameHead readHead(size_t frame);
  void readPayloads(size_t frame, std::vector<uint8_t>& payloads);
  /// The last frame up to this one that needs no other.
  size_t keyFrameOf(size_t frame) const;
  [[noreturn]] void fail(size_t frame, std::optional<size_t> slice, const std::string& what) const;

 private:
  void open();
  void readHeader();
  bool readIndex();
  bool placesFit(std::span<const SvolFrame> frames, uint64_t end) const;
  void scan();
  bool scanRecord();
  void scanIndex();
  void checkLastPayloads();
  /// Reads a frame's head as it stands at `offset`; `number` is what it must be.
  svol::FrameHead readHeadAt(size_t number, uint64_t offset);
  /// Where the payloads of a frame begin in the file.
  uint64_t payloadsOffset(size_t frame) const;
  uint64_t frameEnd(size_t frame) const;
  void readAt(uint64_t offset, std::span<uint8_t> bytes);
  /// `offset` is where the record begins in the file, and `framesBefore` how many frames may be whole without it.
  [[noreturn]] void fail(const std::string& part, uint64_t offset, const std::string& what,
                         size_t framesBefore = 0) const;
  [[noreturn]] void failInFrame(size_t frame, std::optional<size_t> slice, uint64_t offset,
                                const std::string& what) const;

  std::ifstream file_;
  std::istream& in_;
  std::string where_;
  uint64_t fileBytes_ = 0;
  DisplayProfile profile_;
  VolumeLayout layout_{profile_};
  std::string metadata_;
  uint64_t headerEnd_ = 0;
  std::vector<SvolFrame> frames_;
  uint64_t framesEnd_ = 0;
  SvolEnding ending_ = SvolEnding::kFinished;
  std::optional<InputError> damage_;
};

}  // namespace ocelli
