// The device's side of the wire protocol, as a builder of a display may write it: it answers requests, takes the bulk
// stream, keeps frames in buffers and shows them as the screen turns. It knows neither USB nor clocks: who calls it
// says what time it is.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "display_driver/firmware/refresh_sink.h"
#include "display_driver/firmware/rotor.h"
#include "display_driver/wire/frame_assembler.h"
#include "display_driver/wire/message_reader.h"
#include "display_driver/wire/wire_format.h"
#include "display_sim/frames/volume.h"

namespace ocelli {

struct FirmwareOptions {
  DisplayProfile profile;
  std::string name = "Ocelli emulated display";
  std::string serial = "EMULATED";
  int frameBuffers = 3;  ///< 2 at least
  uint32_t capabilities =
      wire::kCanRunLength | wire::kCanZstd | wire::kCanDelta | wire::kCanCoarse | wire::kCanAnyPhase;
  RotorOptions rotor = {};
};

class Firmware {
 public:
  explicit Firmware(FirmwareOptions options);
  ~Firmware();

  const FirmwareOptions& options() const { return options_; }

  /// Requests of the control pipe. nullopt and false: not understood, which stalls the pipe until the next request.
  std::optional<std::vector<uint8_t>> controlIn(uint8_t request, uint16_t value, size_t most, DeviceMicroseconds now);
  bool controlOut(uint8_t request, uint16_t value, std::span<const uint8_t> bytes, DeviceMicroseconds now);

  /// Takes bytes of the bulk stream, and says how many: fewer than there are while every frame buffer is in use, until
  /// advance() has freed one.
  size_t receive(std::span<const uint8_t> bytes, DeviceMicroseconds now);
  /// Whole events, at most `most` bytes, oldest first.
  std::vector<uint8_t> takeEvents(size_t most);

  /// Turns the screen on. Call it often: frames change at the slice at which this is called.
  void advance(DeviceMicroseconds now);
  /// When advance() has something to do again: the begin of the next slice.
  DeviceMicroseconds nextChange() const;

  Rotor& rotor() { return rotor_; }
  /// Hears of every refresh that ends. nullptr: nobody does.
  void setSink(RefreshSink* sink) { sink_ = sink; }
  /// Hears of every frame as it is acknowledged.
  void setArrivalSink(ArrivalSink* sink) { arrivals_ = sink; }

  /// As after power came back: the rotation goes on, all else is forgotten. What is shown is dark.
  void restart(DeviceMicroseconds now);

  /// So many frames have begun, whatever became of them.
  uint32_t framesBegun() const { return framesBegun_; }
  /// Takes the next message for another one than it is: for emulated faults.
  void skipSequence() { reader_.skipSequence(); }

 private:
  enum class BufferState { kFree, kReceiving, kWhole };
  struct Buffer {
    explicit Buffer(const DisplayProfile& profile) : volume(profile) {}
    Volume volume;
    BufferState state = BufferState::kFree;
    uint32_t frame = 0;  ///< 0: of no frame of this session
    std::optional<wire::Present> present;
    bool shownCoarse = false;
  };
  /// Where the screen is: the refresh is the rotor's.
  struct Place {
    uint64_t refresh = 0;
    int slice = 0;
    auto operator<=>(const Place&) const = default;
  };

  void arm(uint32_t session);
  void forgetFrames();
  bool take(const wire::Message& message);
  bool beginFrame(const wire::Message& message);
  bool isOrphan(const wire::Message& message);
  void takeSlice(const wire::Message& message);
  void endFrame(const wire::Message& message);
  void takePresent(const wire::Message& message);
  void loseFrame(wire::ErrorCode code, uint32_t frame);
  const Buffer* wholeFrame(uint32_t frame) const;
  Buffer* bufferOf(uint32_t frame);
  Buffer* freeBuffer(const Buffer* base);
  bool isWaiting(const Buffer& buffer) const;
  void stepTo(int slice);
  void changeFrames(Place place);
  bool isDue(const Buffer& buffer, Place place) const;
  void show(Buffer& buffer, Place place, bool coarse);
  void showPart(const ShownRefresh::Part& part);
  void keepShownSlices(int upTo);
  void endRefresh();
  void report(wire::EventType type, uint32_t frame, uint16_t code = 0, uint8_t flags = 0);

  FirmwareOptions options_;
  std::string profileJson_;
  Rotor rotor_;
  RefreshSink* sink_ = nullptr;
  ArrivalSink* arrivals_ = nullptr;

  DeviceMicroseconds now_ = 0;
  uint32_t session_ = 0;
  wire::MessageReader reader_;
  wire::FrameAssembler assembler_;
  std::vector<Buffer> buffers_;
  Buffer coarse_;                ///< what is shown of a frame that is still coming
  Buffer* front_ = nullptr;      ///< one of buffers_, or coarse_
  Buffer* receiving_ = nullptr;  ///< nullptr: slices belong to a frame that is lost
  uint32_t lastLost_ = 0;        ///< the frame of the last error
  uint32_t newestWhole_ = 0;     ///< the frame that arrived last in this session
  uint32_t framesBegun_ = 0;

  Place place_;                   ///< up to which changes of frames are done
  ShownRefresh shown_;            ///< of the refresh under way
  std::unique_ptr<Volume> kept_;  ///< its slices that earlier frames showed, where it is torn

  std::deque<wire::Event> events_;
  wire::DeviceTelemetry counts_;  ///< its counters and last error
};

}  // namespace ocelli
