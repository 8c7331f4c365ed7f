// A display as docs/wire_protocol.md tells it, written from that page alone: plain, slow, and without anything of
// display_driver/. Tests and fuzz targets compare the firmware with it, event by event.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "tests/display_driver_firmware/wire_bytes.h"

namespace ocelli::test {

struct SlowOptions {
  size_t slices = 0;  ///< of a refresh
  size_t width = 0;
  size_t height = 0;
  size_t bits = 1;
  size_t buffers = 2;
  size_t maxPayload = 0;
  bool runLength = true;
  bool zstd = true;  ///< of zstd frames only those that zstdPayload() writes
  bool differences = true;
  bool coarse = true;
  bool anyPhase = true;

  size_t rowBytes() const { return (width + 7) / 8; }
  size_t sliceBytes() const { return 3 * bits * height * rowBytes(); }
};

using Slices = std::vector<Bytes>;

struct Phase {
  uint64_t refresh = 0;
  size_t slice = 0;
  auto operator<=>(const Phase&) const = default;
};

class SlowDisplay {
 public:
  explicit SlowDisplay(const SlowOptions& options);

  void arm(uint32_t session);
  void disarm() { arm(0); }
  void reset();

  /// What the display took of the stream.
  void take(ByteSpan bytes);
  /// A frame begins for which there is no room: the display takes nothing more.
  bool full() const { return held_; }
  /// The screen comes to the next slice.
  void step();
  Phase phase() const { return phase_; }

  /// Since the last call; without session and time.
  std::vector<SeenEvent> takeEvents();
  /// Frames that arrived, since the last call.
  std::map<uint32_t, Slices> takeArrived();

  /// What the refresh before this one showed, and which frames: pairs of the first slice and the frame (negative where
  /// a coarse one; 0 is darkness).
  struct Refresh {
    Slices slices;
    std::vector<std::pair<size_t, int64_t>> parts;
  };
  const Refresh& lastRefresh() const { return last_; }

  uint32_t arrived = 0;
  uint32_t shown = 0;
  uint32_t dropped = 0;
  uint16_t lastError = 0;

 private:
  struct Presentation {
    Phase phase;
    uint16_t flags = 0;
  };
  struct Frame {
    uint32_t number = 0;
    uint32_t base = 0;
    Slices slices = {};
    std::vector<bool> due = {};
    std::vector<uint32_t> sums = {};
    bool whole = false;
    std::optional<Presentation> presentation = {};
    bool shownCoarse = false;
    bool gone = false;  ///< not shown or waiting any more, but the base of what is being received
  };

  bool message(const Header& header, ByteSpan payload);
  bool begin(const Header& header, ByteSpan payload);
  void slice(const Header& header, ByteSpan payload);
  void end(const Header& header, ByteSpan payload);
  void present(const Header& header, ByteSpan payload);
  bool isOrphan(const Header& header);
  void error(uint16_t code, uint32_t frame);
  void event(uint8_t type, uint32_t frame, uint16_t code = 0, uint8_t flags = 0);
  std::optional<Bytes> content(uint8_t coding, ByteSpan payload) const;
  bool isDue(const Frame& frame) const;
  void show(Frame& frame);
  void freeBases();
  void changeParts();
  void drop(uint32_t number);
  Slices filled(const Frame& frame) const;
  Slices dark() const;

  SlowOptions options_;
  uint32_t session_ = 0;
  Bytes bytes_;  ///< of a message that has not come whole
  bool lost_ = false;
  bool held_ = false;
  std::optional<uint32_t> sequence_;  ///< of the next message; nullopt: whatever comes
  uint32_t newestWhole_ = 0;
  uint32_t lastLost_ = 0;

  std::map<uint32_t, Frame> frames_;  ///< received, waiting or shown: those that are in a buffer
  uint32_t receiving_ = 0;
  uint32_t front_ = 0;            ///< in frames_; 0: none of this session
  bool frontInOldBuffer_ = true;  ///< what is shown is in a buffer, but darkness or of a session before
  int64_t frontName_ = 0;
  Slices frontSlices_;
  Phase phase_;
  Refresh now_;
  Refresh last_;
  std::vector<SeenEvent> events_;
  std::map<uint32_t, Slices> arrivals_;
};

}  // namespace ocelli::test
