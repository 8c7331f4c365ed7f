// Writes a device log: all that passes the boundary of a device, with its times (docs/device_log.md).
// Times are since the opening, and never decrease. Whatever ends the program, the file can be read up to the last whole
// record. Every function throws WorkError where the disk is full; nothing more can be written then.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "display_driver/device/device.h"
#include "display_driver/pacing/device_log_format.h"
#include "display_driver/wire/frame_encoder.h"
#include "oc_core/base/output_file.h"

namespace ocelli {

class DeviceLogWriter {
 public:
  using Time = std::chrono::microseconds;

  /// Throws WorkError where the file cannot be made.
  DeviceLogWriter(const std::filesystem::path& path, const DeviceInfo& device, const DisplayProfile& profile);

  /// A volume that was submitted, of which these slices may differ from the one before (nullopt: all).
  void submitted(FrameNumber frame, const Volume& volume, std::optional<std::span<const int>> changed, Time time);
  void presented(FrameNumber frame, const Presentation& presentation, Time time);
  /// What became of it. The times of a state are those of a clock that was `opened` at the opening.
  void ended(FrameNumber frame, const FrameState& state, HostTime opened, Time time);
  void told(const Telemetry& telemetry, HostTime opened, Time time);
  void finish(Time time);

 private:
  void write(device_log::RecordType type, Time time, std::span<const uint8_t> payload);
  void writeText(device_log::RecordType type, Time time, const std::string& text);

  OutputFile file_;
  uint64_t last_ = 0;
  wire::FrameEncoder encoder_;
  wire::MessageWriter messages_;
  Volume before_;  ///< what the next frame may refer to
  FrameNumber beforeNumber_ = 0;
  std::vector<uint8_t> stream_;
};

}  // namespace ocelli
