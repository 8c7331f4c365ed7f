#include "display_driver/pacing/device_log_reader.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "display_driver/pacing/device_log_format.h"
#include "display_driver/wire/frame_assembler.h"
#include "display_driver/wire/message_reader.h"
#include "display_sim/frames/volume_pool.h"
#include "oc_core/base/json_fields.h"

namespace ocelli {
namespace {

using device_log::RecordType;

constexpr double kMaxCount = 9007199254740991.0;  // 2^53 - 1
constexpr double kMaxNumber = 1e12;

uint64_t count(JsonFields& fields, const char* name) {
  const double number = fields.number(name, 0, kMaxCount);
  if (number != std::floor(number)) {
    fields.fail(name, "must be a whole number");
  }
  return static_cast<uint64_t>(number);
}

HostTime time(JsonFields& fields, const char* name) {
  return fields.has(name) ? HostTime(std::chrono::microseconds(count(fields, name))) : HostTime{};
}

FrameStage stageOf(JsonFields& fields) {
  const std::string name = fields.text("stage");
  for (const auto& [known, stage] :
       {std::pair{"shown", FrameStage::kShown}, {"dropped", FrameStage::kDropped}, {"lost", FrameStage::kLost}}) {
    if (name == known) {
      return stage;
    }
  }
  fields.fail("stage", "must be shown, dropped or lost");
}

DeviceLogRecord::Ended endedFrom(const std::string& text, const std::string& where) {
  const nlohmann::json json = parseJson(text, where);
  JsonFields fields(json, where);
  DeviceLogRecord::Ended ended;
  ended.frame = static_cast<FrameNumber>(fields.number("frame", 1, 4294967295.0));
  ended.state.stage = stageOf(fields);
  ended.state.sent = time(fields, "sent");
  ended.state.arrived = time(fields, "arrived");
  if (ended.state.stage == FrameStage::kShown) {
    ended.state.shown = time(fields, "shown");
    ended.state.shownRefresh = count(fields, "refresh");
    ended.state.shownSlice = fields.integer("slice", 0, 1 << 20);
    ended.state.late = fields.boolean("late", false);
    ended.state.coarse = fields.boolean("coarse", false);
  }
  ended.state.bytes = count(fields, "bytes");
  ended.state.problem = fields.text("problem");
  fields.rejectUnknown();
  return ended;
}

Telemetry telemetryFrom(const std::string& text, const std::string& where) {
  const nlohmann::json json = parseJson(text, where);
  JsonFields fields(json, where);
  Telemetry telemetry;
  telemetry.connected = fields.boolean("connected", false);
  if (fields.has("refresh")) {
    telemetry.rotation = RotationReading{.time = time(fields, "rotation_time"),
                                         .refresh = count(fields, "refresh"),
                                         .share = fields.number("share", 0, 1),
                                         .refreshSeconds = fields.number("refresh_seconds", 0, kMaxNumber)};
  }
  telemetry.rotationsPerMinute = fields.number("rotations_per_minute", 0, kMaxNumber);
  telemetry.phaseErrorDegrees = fields.number("phase_error_degrees", -kMaxNumber, kMaxNumber);
  if (fields.has("temperature_celsius")) {
    telemetry.temperatureCelsius = fields.number("temperature_celsius", -kMaxNumber, kMaxNumber);
  }
  telemetry.framesSubmitted = count(fields, "frames_submitted");
  telemetry.framesArrived = count(fields, "frames_arrived");
  telemetry.framesShown = count(fields, "frames_shown");
  telemetry.framesShownCoarse = count(fields, "frames_shown_coarse");
  telemetry.framesDropped = count(fields, "frames_dropped");
  telemetry.framesLost = count(fields, "frames_lost");
  telemetry.underruns = count(fields, "underruns");
  telemetry.reconnections = count(fields, "reconnections");
  telemetry.bytesSent = count(fields, "bytes_sent");
  telemetry.lastProblem = fields.text("problem");
  fields.rejectUnknown();
  return telemetry;
}

}  // namespace

/// The messages of the wire protocol in a log, and what they have made so far.
struct DeviceLogReader::Stream {
  explicit Stream(const DisplayProfile& profile)
      : messages(VolumeLayout(profile).sliceBytes + wire::frameBeginBytes(VolumeLayout(profile).slices) + 64),
        assembler(profile, device_log::kWireCapabilities) {
    messages.begin(device_log::kWireSession);
  }

  wire::MessageReader messages;
  wire::FrameAssembler assembler;
  VolumePool volumes;
  std::shared_ptr<Volume> base;    ///< the last whole frame; nullptr before the first
  std::shared_ptr<Volume> coming;  ///< the one under way
  FrameNumber baseNumber = 0;
  FrameNumber comingNumber = 0;
  std::vector<int> changed;
  std::optional<DeviceLogRecord> ready;
};

DeviceLogReader::DeviceLogReader(const std::filesystem::path& path)
    : file_(path, std::ios::binary), in_(file_), where_(path.string()) {
  if (!file_) {
    throw InputError("cannot be opened", where_, "check that the file exists");
  }
  open(kMaxVolumeBytes);
}

DeviceLogReader::DeviceLogReader(std::istream& in, std::string where, size_t maxVolumeBytes)
    : in_(in), where_(std::move(where)) {
  open(maxVolumeBytes);
}

DeviceLogReader::~DeviceLogReader() = default;

void DeviceLogReader::fail(const std::string& what) const {
  throw InputError(fmt::format("the record at byte {} is wrong: {}", offset_, what), where_,
                   "what comes before it can be used");
}

void DeviceLogReader::open(size_t maxVolumeBytes) {
  std::array<uint8_t, device_log::kHeaderBytes> header{};
  in_.read(reinterpret_cast<char*>(header.data()), header.size());
  if (in_.gcount() != static_cast<std::streamsize>(header.size()) || !device_log::isFileHeader(header)) {
    throw InputError("this is no device log", where_, "ocelli present ... --record FILE.session makes one");
  }
  offset_ = header.size();
  if (!readRecord() || type_ != static_cast<uint32_t>(RecordType::kOpening)) {
    throw InputError("this log has no opening", where_, "record it again");
  }
  const nlohmann::json json = parseJson(std::string(payload_.begin(), payload_.end()), where_);
  JsonFields fields(json, where_);
  device_.kind = fields.text("kind");
  device_.name = fields.text("name");
  device_.serial = fields.text("serial");
  device_.link = fields.text("link");
  profile_ = profileFromJsonText(fields.value("profile").dump(), where_ + ", profile");
  fields.rejectUnknown();
  if (profile_->volumeBytes() > maxVolumeBytes) {
    throw InputError("the volumes of this display are too large", where_, "a smaller display");
  }
  offset_ += device_log::kRecordHeaderBytes + payload_.size();
  payload_.clear();
}

/// The record at offset_. False where the file ends before it does.
bool DeviceLogReader::readRecord() {
  std::array<uint8_t, device_log::kRecordHeaderBytes> bytes{};
  in_.read(reinterpret_cast<char*>(bytes.data()), bytes.size());
  if (in_.gcount() != static_cast<std::streamsize>(bytes.size())) {
    return false;
  }
  const auto header = device_log::recordHeaderFrom(bytes);
  if (!header) {
    fail("it does not begin as records do");
  }
  payload_.resize(header->payloadBytes);
  in_.read(reinterpret_cast<char*>(payload_.data()), static_cast<std::streamsize>(payload_.size()));
  if (in_.gcount() != static_cast<std::streamsize>(payload_.size())) {
    return false;
  }
  if (!device_log::checksumFits(bytes, payload_)) {
    fail("its checksum does not fit");
  }
  if (header->microseconds < microseconds_) {
    fail("its time is before that of the record before it");
  }
  type_ = static_cast<uint32_t>(header->type);
  microseconds_ = header->microseconds;
  return true;
}

/// Until something is ready, or all bytes of the record have been taken.
void DeviceLogReader::readStream() {
  if (stream_ == nullptr) {
    stream_ = std::make_unique<Stream>(*profile_);
  }
  Stream& stream = *stream_;
  const auto require = [&](bool right, const char* what) {
    if (!right) {
      fail(what);
    }
  };
  const auto begin = [&](const wire::Message& message) {
    const auto frame = wire::frameBeginFrom(message.payload, VolumeLayout(*profile_).slices);
    require(frame && message.header.frame != 0 && !stream.assembler.active(), "a frame begins wrongly");
    require(frame->base == stream.baseNumber, "a frame refers to one that is not the one before it");
    if (stream.coming == nullptr) {
      stream.coming = stream.volumes.take(*profile_);
    }
    stream.changed.clear();
    for (size_t i = 0; i < frame->records.size(); ++i) {
      if (frame->records[i]) {
        stream.changed.push_back(static_cast<int>(i));
      }
    }
    stream.comingNumber = message.header.frame;
    stream.assembler.begin(*frame, stream.base.get(), *stream.coming);
  };
  const auto take = [&](const wire::Message& message) {
    if (stream.ready) {
      return false;  // later: what is ready comes first
    }
    const bool ofThisFrame = stream.assembler.active() && message.header.frame == stream.comingNumber;
    switch (message.header.type) {
      case wire::MessageType::kFrameBegin:
        begin(message);
        break;
      case wire::MessageType::kSlice:
        require(ofThisFrame && stream.assembler.slice(message.header, message.payload) == wire::ErrorCode::kNone,
                "a slice is wrong");
        break;
      case wire::MessageType::kFrameEnd: {
        const auto end = wire::frameEndFrom(message.payload);
        require(ofThisFrame && end && stream.assembler.end(*end) == wire::ErrorCode::kNone, "a frame ends wrongly");
        stream.base = std::exchange(stream.coming, nullptr);
        stream.baseNumber = stream.comingNumber;
        stream.ready = {microseconds_, DeviceLogRecord::Submitted{stream.baseNumber, stream.base, stream.changed}};
        break;
      }
      case wire::MessageType::kPresent: {
        const auto present = wire::presentFrom(message.payload);
        require(present && (present->atNextRefresh || present->slice < profile_->storedSlices()),
                "a presentation is wrong");
        Presentation presentation{.tearWhenLate = present->tearWhenLate, .coarseWhenLate = present->coarseWhenLate};
        if (!present->atNextRefresh) {
          presentation.at = RotationPhase{present->refresh, present->slice};
        }
        stream.ready = {microseconds_, DeviceLogRecord::Presented{message.header.frame, presentation}};
        break;
      }
    }
    return true;
  };
  payloadRead_ += stream.messages.read(
      std::span(payload_).subspan(payloadRead_),
      {.message = take, .problem = [&](wire::ErrorCode, uint32_t) { fail("its messages do not follow one another"); }});
}

std::optional<DeviceLogRecord> DeviceLogReader::next() {
  if (over_) {
    return std::nullopt;
  }
  try {
    while (true) {
      if (type_ == static_cast<uint32_t>(RecordType::kStream)) {
        // Also with no bytes left: the reader may hold a message back that came with the last ones.
        readStream();
        if (stream_->ready) {
          return std::exchange(stream_->ready, std::nullopt);
        }
        offset_ += device_log::kRecordHeaderBytes + payload_.size();
      }
      type_ = 0;
      payloadRead_ = 0;
      if (!readRecord()) {
        over_ = true;
        return std::nullopt;
      }
      const std::string text(payload_.begin(), payload_.end());
      const std::string where = fmt::format("{}, the record at byte {}", where_, offset_);
      const auto type = static_cast<RecordType>(type_);
      if (type != RecordType::kStream) {
        offset_ += device_log::kRecordHeaderBytes + payload_.size();
      }
      switch (type) {
        case RecordType::kOpening:
          fail("a log has one opening");
        case RecordType::kStream:
          break;
        case RecordType::kFate:
          return DeviceLogRecord{microseconds_, endedFrom(text, where)};
        case RecordType::kTelemetry:
          return DeviceLogRecord{microseconds_, telemetryFrom(text, where)};
        case RecordType::kEnd:
          over_ = true;
          ending_ = RecordingEnding::kFinished;
          return std::nullopt;
      }
    }
  } catch (const InputError& error) {
    over_ = true;
    ending_ = RecordingEnding::kDamaged;
    damage_ = error;
    return std::nullopt;
  }
}

}  // namespace ocelli
