// A short device log.
#pragma once

#include <sstream>
#include <string>
#include <vector>

#include "display_driver/pacing/device_log_reader.h"
#include "display_driver/pacing/device_log_writer.h"
#include "tests/display_driver_wire/made_volumes.h"

namespace ocelli::test {

/// What a log held, with volumes copied.
struct DeviceLogContent {
  std::vector<DeviceLogRecord> records;  ///< their volumes are nullptr
  std::vector<Volume> volumes;
  std::optional<RecordingEnding> ending;
};

inline DeviceLogContent readAll(DeviceLogReader& reader) {
  DeviceLogContent content;
  while (auto record = reader.next()) {
    if (auto* submitted = std::get_if<DeviceLogRecord::Submitted>(&record->what)) {
      content.volumes.push_back(*submitted->volume);
      submitted->volume = nullptr;
    }
    content.records.push_back(std::move(*record));
  }
  content.ending = reader.ending();
  return content;
}

/// The kind of each record, and what tells it from others.
inline std::vector<std::string> describe(const DeviceLogContent& content) {
  std::vector<std::string> lines;
  for (const DeviceLogRecord& record : content.records) {
    std::string line = std::to_string(record.microseconds) + " ";
    if (const auto* submitted = std::get_if<DeviceLogRecord::Submitted>(&record.what)) {
      line += "submitted " + std::to_string(submitted->frame);
    } else if (const auto* presented = std::get_if<DeviceLogRecord::Presented>(&record.what)) {
      line += "presented " + std::to_string(presented->frame);
      line += presented->presentation.at ? " at " + std::to_string(presented->presentation.at->refresh) : " next";
    } else if (const auto* ended = std::get_if<DeviceLogRecord::Ended>(&record.what)) {
      line += "ended " + std::to_string(ended->frame) + " " + std::to_string(static_cast<int>(ended->state.stage));
    } else {
      line += "told " + std::to_string(std::get<Telemetry>(record.what).framesShown);
    }
    lines.push_back(line);
  }
  return lines;
}

inline std::vector<Volume> deviceLogVolumes() {
  const DisplayProfile profile = smallProfile(5);
  std::vector<Volume> volumes = {madeVolume(profile, 1)};
  volumes.push_back(volumes[0]);
  volumes[1].light(2, 3, 4, 7);
  volumes.push_back(madeVolume(profile, 3, 0.2));
  volumes.push_back(volumes[2]);  // nothing changes
  return volumes;
}

inline void writeDeviceLog(const std::filesystem::path& path) {
  using std::chrono::microseconds;
  const HostTime opened(std::chrono::hours(1));
  DeviceLogWriter writer(path, {.kind = "sim", .name = "a \"name\"", .serial = "7", .link = "memory"}, smallProfile(5));
  const std::vector<Volume> volumes = deviceLogVolumes();
  Telemetry telemetry;
  telemetry.connected = true;
  telemetry.rotation = RotationReading{opened + microseconds(500), 100, 0.25, 1.0 / 24};
  telemetry.temperatureCelsius = 40.5;
  writer.told(telemetry, opened, microseconds(600));
  for (uint32_t i = 0; i < volumes.size(); ++i) {
    const microseconds time(1000 * (i + 1));
    const std::vector<int> changed = {2};
    writer.submitted(i + 1, volumes[i], i == 1 ? std::optional<std::span<const int>>(changed) : std::nullopt, time);
    Presentation presentation{.tearWhenLate = i == 2};
    if (i % 2 == 0) {
      presentation.at = RotationPhase{110 + i, static_cast<int>(i)};
    }
    writer.presented(i + 1, presentation, time + microseconds(10));
    FrameState state{.stage = i == 1 ? FrameStage::kDropped : FrameStage::kShown,
                     .sent = opened + time + microseconds(20),
                     .arrived = opened + time + microseconds(30)};
    if (i != 1) {
      state.shown = opened + time + microseconds(40);
      state.shownRefresh = 110 + i;
    }
    state.problem = i == 1 ? "a newer\none" : "";
    writer.ended(i + 1, state, opened, time + microseconds(50));
  }
  writer.finish(microseconds(9000));
}

}  // namespace ocelli::test
