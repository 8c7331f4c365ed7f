#include "display_driver/pacing/device_log_writer.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>

#include "display_driver/wire/wire_format.h"
#include "oc_core/base/json_fields.h"

namespace ocelli {
namespace {

using device_log::RecordType;
using nlohmann::ordered_json;

constexpr size_t kSlicesAtOnce = 24;
/// A stream goes to the file in pieces of this size or somewhat more.
constexpr size_t kPieceBytes = size_t{1} << 18;

const char* nameOf(FrameStage stage) {
  switch (stage) {
    case FrameStage::kWaiting:
      return "waiting";
    case FrameStage::kSending:
      return "sending";
    case FrameStage::kArrived:
      return "arrived";
    case FrameStage::kShown:
      return "shown";
    case FrameStage::kDropped:
      return "dropped";
    case FrameStage::kLost:
      return "lost";
  }
  return "";
}

void addTime(ordered_json& json, const char* name, HostTime time, HostTime opened) {
  if (time != HostTime{}) {
    const auto since = std::chrono::duration_cast<std::chrono::microseconds>(time - opened).count();
    json[name] = std::max<int64_t>(0, since);
  }
}

}  // namespace

DeviceLogWriter::DeviceLogWriter(const std::filesystem::path& path, const DeviceInfo& device,
                                 const DisplayProfile& profile)
    : file_(path),
      encoder_(profile, device_log::kWireCapabilities),
      messages_(device_log::kWireSession),
      before_(profile) {
  file_.write(device_log::fileHeader());
  const ordered_json opening = {{"kind", device.kind},
                                {"name", device.name},
                                {"serial", device.serial},
                                {"link", device.link},
                                {"profile", ordered_json::parse(jsonText(profile))}};
  writeText(RecordType::kOpening, {}, textOfJson(opening));
  file_.publish();
}

void DeviceLogWriter::write(RecordType type, Time time, std::span<const uint8_t> payload) {
  last_ = std::max(last_, static_cast<uint64_t>(std::max<int64_t>(0, time.count())));
  file_.write(device_log::recordHeader(type, last_, payload));
  file_.write(payload);
  file_.flush();
}

void DeviceLogWriter::writeText(RecordType type, Time time, const std::string& text) {
  write(type, time, {reinterpret_cast<const uint8_t*>(text.data()), text.size()});
}

void DeviceLogWriter::submitted(FrameNumber frame, const Volume& volume, std::optional<std::span<const int>> changed,
                                Time time) {
  const bool first = beforeNumber_ == 0;
  encoder_.begin(volume, first ? nullptr : &before_, first ? std::nullopt : changed);
  stream_.clear();
  messages_.frameBegin(stream_, frame, {.base = beforeNumber_, .records = encoder_.records()});
  for (auto slices = encoder_.next(kSlicesAtOnce); !slices.empty(); slices = encoder_.next(kSlicesAtOnce)) {
    for (const auto& [slice, coded] : slices) {
      messages_.slice(stream_, frame, slice, coded);
    }
    while (stream_.size() >= kPieceBytes) {
      write(RecordType::kStream, time, std::span(stream_).first(kPieceBytes));
      stream_.erase(stream_.begin(), stream_.begin() + kPieceBytes);
    }
  }
  messages_.frameEnd(stream_, frame);
  write(RecordType::kStream, time, stream_);
  before_ = volume;
  beforeNumber_ = frame;
}

void DeviceLogWriter::presented(FrameNumber frame, const Presentation& presentation, Time time) {
  stream_.clear();
  messages_.present(stream_, frame,
                    {.refresh = presentation.at ? presentation.at->refresh : 0,
                     .slice = static_cast<uint16_t>(presentation.at ? presentation.at->slice : 0),
                     .atNextRefresh = !presentation.at,
                     .tearWhenLate = presentation.tearWhenLate,
                     .coarseWhenLate = presentation.coarseWhenLate});
  write(RecordType::kStream, time, stream_);
}

void DeviceLogWriter::ended(FrameNumber frame, const FrameState& state, HostTime opened, Time time) {
  ordered_json json = {{"frame", frame}, {"stage", nameOf(state.stage)}};
  addTime(json, "sent", state.sent, opened);
  addTime(json, "arrived", state.arrived, opened);
  if (state.stage == FrameStage::kShown) {
    addTime(json, "shown", state.shown, opened);
    json["refresh"] = state.shownRefresh;
    json["slice"] = state.shownSlice;
    json["late"] = state.late;
    json["coarse"] = state.coarse;
  }
  json["bytes"] = state.bytes;
  json["problem"] = state.problem;
  writeText(RecordType::kFate, time, textOfJson(json));
}

void DeviceLogWriter::told(const Telemetry& telemetry, HostTime opened, Time time) {
  ordered_json json = {{"connected", telemetry.connected}};
  if (telemetry.rotation) {
    addTime(json, "rotation_time", telemetry.rotation->time, opened);
    json["refresh"] = telemetry.rotation->refresh;
    json["share"] = telemetry.rotation->share;
    json["refresh_seconds"] = telemetry.rotation->refreshSeconds;
  }
  json["rotations_per_minute"] = telemetry.rotationsPerMinute;
  json["phase_error_degrees"] = telemetry.phaseErrorDegrees;
  if (telemetry.temperatureCelsius) {
    json["temperature_celsius"] = *telemetry.temperatureCelsius;
  }
  json["frames_submitted"] = telemetry.framesSubmitted;
  json["frames_arrived"] = telemetry.framesArrived;
  json["frames_shown"] = telemetry.framesShown;
  json["frames_shown_coarse"] = telemetry.framesShownCoarse;
  json["frames_dropped"] = telemetry.framesDropped;
  json["frames_lost"] = telemetry.framesLost;
  json["underruns"] = telemetry.underruns;
  json["reconnections"] = telemetry.reconnections;
  json["bytes_sent"] = telemetry.bytesSent;
  json["problem"] = telemetry.lastProblem;
  writeText(RecordType::kTelemetry, time, textOfJson(json));
}

void DeviceLogWriter::finish(Time time) {
  write(RecordType::kEnd, time, {});
  file_.commit();
}

}  // namespace ocelli
