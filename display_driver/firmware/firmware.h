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
  RotorOptions rotor;
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
  /// Whole events, of so many bytes at most, oldest first.
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

 private:
  struct Buffer;
  // Filled in with the implementation.

  FirmwareOptions options_;
  Rotor rotor_;
  RefreshSink* sink_ = nullptr;
  ArrivalSink* arrivals_ = nullptr;
};

}  // namespace ocelli
