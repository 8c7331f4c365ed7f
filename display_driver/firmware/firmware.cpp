#include "display_driver/firmware/firmware.h"

#include <algorithm>

#include "oc_core/base/check.h"

namespace ocelli {
namespace {

using wire::ErrorCode;
using wire::EventType;
using wire::MessageType;

/// A host that reads no events loses the oldest ones.
constexpr size_t kMaxEvents = 4096;

/// Payloads of slices are at most as long as the raw planes; a FRAME_BEGIN of a tiny display may be longer.
size_t maxPayload(const DisplayProfile& profile) {
  const VolumeLayout layout(profile);
  return std::max({layout.sliceBytes, wire::frameBeginBytes(layout.slices), wire::kPresentBytes, wire::kFrameEndBytes});
}

}  // namespace

Firmware::Firmware(FirmwareOptions options)
    : options_(std::move(options)),
      profileJson_(jsonText(options_.profile)),
      rotor_(options_.profile, options_.rotor),
      reader_(maxPayload(options_.profile)),
      assembler_(options_.profile, options_.capabilities),
      coarse_(options_.profile) {
  OC_CHECK(options_.frameBuffers >= 2, "one buffer is shown while the other one fills");
  buffers_.reserve(static_cast<size_t>(options_.frameBuffers));
  for (int i = 0; i < options_.frameBuffers; ++i) {
    buffers_.emplace_back(options_.profile);
  }
  front_ = &buffers_.front();
  shown_.parts = {{}};
}

Firmware::~Firmware() = default;

std::optional<std::vector<uint8_t>> Firmware::controlIn(uint8_t request, uint16_t value, size_t most,
                                                        DeviceMicroseconds now) {
  advance(now);
  std::vector<uint8_t> answer;
  if (request == static_cast<uint8_t>(wire::Request::kIdentify) && value == 0) {
    const std::span profile(reinterpret_cast<const uint8_t*>(profileJson_.data()), profileJson_.size());
    answer = toBytes(wire::Identity{.capabilities = options_.capabilities,
                                    .frameBuffers = static_cast<uint8_t>(options_.frameBuffers),
                                    .maxPayloadBytes = static_cast<uint32_t>(maxPayload(options_.profile)),
                                    .profileBytes = static_cast<uint32_t>(profileJson_.size()),
                                    .profileChecksum = wire::crc32c(profile),
                                    .name = options_.name});
  } else if (request == static_cast<uint8_t>(wire::Request::kProfile) && value == 0) {
    answer.assign(profileJson_.begin(), profileJson_.end());
  } else if (request == static_cast<uint8_t>(wire::Request::kTelemetry) && value == 0) {
    wire::DeviceTelemetry telemetry = counts_;
    telemetry.session = session_;
    telemetry.timeMicroseconds = static_cast<uint64_t>(now);
    telemetry.refresh = rotor_.refresh();
    const double share = static_cast<double>(now - rotor_.begin()) / rotor_.lengthMicroseconds();
    telemetry.refreshShare = static_cast<uint32_t>(std::clamp(share, 0.0, 1 - 0x1p-32) * 0x1p32);
    telemetry.refreshNanoseconds = static_cast<uint32_t>(std::min(rotor_.lengthMicroseconds() * 1e3, 4294967295.0));
    telemetry.phaseErrorMicrodegrees = static_cast<int32_t>(std::clamp(rotor_.phaseErrorDegrees(), -2e3, 2e3) * 1e6);
    telemetry.state = session_ == 0     ? wire::DeviceState::kIdle
                      : rotor_.locked() ? wire::DeviceState::kArmed
                                        : wire::DeviceState::kSpinningUp;
    answer = toBytes(telemetry);
  } else {
    return std::nullopt;
  }
  answer.resize(std::min(answer.size(), most));
  return answer;
}

bool Firmware::controlOut(uint8_t request, uint16_t value, std::span<const uint8_t> bytes, DeviceMicroseconds now) {
  advance(now);
  if (request == static_cast<uint8_t>(wire::Request::kReset) && value == 0 && bytes.empty()) {
    restart(now);
    return true;
  }
  if (request != static_cast<uint8_t>(wire::Request::kArm) || value > 1) {
    return false;
  }
  const std::optional<wire::Arm> asked = wire::armFrom(bytes);
  if (!asked || asked->majorVersion != wire::kMajorVersion || (value == 1 && asked->session == 0)) {
    return false;
  }
  arm(value == 1 ? asked->session : 0);
  return true;
}

void Firmware::arm(uint32_t session) {
  session_ = session;
  forgetFrames();
  events_.clear();
  reader_.begin(session);
}

/// What is shown stays, but no new frame may refer to it.
void Firmware::forgetFrames() {
  assembler_.drop();
  receiving_ = nullptr;
  lastLost_ = 0;
  newestWhole_ = 0;
  for (Buffer& buffer : buffers_) {
    buffer.frame = 0;
    buffer.present.reset();
    buffer.shownCoarse = false;
    if (&buffer != front_) {
      buffer.state = BufferState::kFree;
    }
  }
}

void Firmware::restart(DeviceMicroseconds now) {
  advance(now);
  arm(0);
  counts_ = {};
  Buffer& dark = front_ == &buffers_.front() ? buffers_.back() : buffers_.front();
  dark.volume.clear();
  dark.state = BufferState::kWhole;
  keepShownSlices(place_.slice);
  front_->state = BufferState::kFree;
  front_ = &dark;
  if (shown_.parts.back().frame != 0) {
    showPart({.fromSlice = place_.slice});
  }
}

size_t Firmware::receive(std::span<const uint8_t> bytes, DeviceMicroseconds now) {
  advance(now);
  const wire::MessageReader::Handler handler = {
      .message = [this](const wire::Message& message) { return take(message); },
      .problem = [this](ErrorCode code, uint32_t frame) { loseFrame(code, frame); }};
  return session_ == 0 ? bytes.size() : reader_.read(bytes, handler);
}

bool Firmware::take(const wire::Message& message) {
  switch (message.header.type) {
    case MessageType::kFrameBegin:
      return beginFrame(message);
    case MessageType::kSlice:
      takeSlice(message);
      return true;
    case MessageType::kFrameEnd:
      endFrame(message);
      return true;
    case MessageType::kPresent:
      takePresent(message);
      return true;
  }
  return true;
}

void Firmware::loseFrame(ErrorCode code, uint32_t frame) {
  if (receiving_ != nullptr) {
    frame = receiving_->frame;
    assembler_.drop();
    receiving_->state = BufferState::kFree;
    receiving_->frame = 0;
    receiving_->present.reset();
    receiving_ = nullptr;
  }
  lastLost_ = frame;
  counts_.lastError = code;
  report(EventType::kError, frame, static_cast<uint16_t>(code));
}

const Firmware::Buffer* Firmware::wholeFrame(uint32_t frame) const {
  const auto found = std::ranges::find_if(
      buffers_, [&](const Buffer& buffer) { return buffer.state == BufferState::kWhole && buffer.frame == frame; });
  return found == buffers_.end() ? nullptr : &*found;
}

Firmware::Buffer* Firmware::bufferOf(uint32_t frame) {
  const auto found = std::ranges::find_if(
      buffers_, [&](const Buffer& buffer) { return buffer.state != BufferState::kFree && buffer.frame == frame; });
  return found == buffers_.end() ? nullptr : &*found;
}

bool Firmware::isWaiting(const Buffer& buffer) const {
  return &buffer != front_ && buffer.state == BufferState::kWhole;
}

/// nullptr: all are in use. The oldest frame that waits without a time to be shown gives way, unless it is the base.
Firmware::Buffer* Firmware::freeBuffer(const Buffer* base) {
  for (Buffer& buffer : buffers_) {
    if (&buffer != front_ && buffer.state == BufferState::kFree) {
      return &buffer;
    }
  }
  Buffer* oldest = nullptr;
  for (Buffer& buffer : buffers_) {
    if (isWaiting(buffer) && !buffer.present && &buffer != base &&
        (oldest == nullptr || buffer.frame < oldest->frame)) {
      oldest = &buffer;
    }
  }
  if (oldest != nullptr) {
    ++counts_.framesDropped;
    report(EventType::kDropped, oldest->frame);
  }
  return oldest;
}

bool Firmware::beginFrame(const wire::Message& message) {
  const uint32_t frame = message.header.frame;
  if (receiving_ != nullptr) {
    loseFrame(ErrorCode::kIncomplete, receiving_->frame);
  }
  const auto begin = wire::frameBeginFrom(message.payload, static_cast<size_t>(options_.profile.storedSlices()));
  if (!begin || frame <= newestWhole_) {
    loseFrame(begin ? ErrorCode::kOutOfPlace : ErrorCode::kLength, frame);
    return true;
  }
  const Buffer* base = begin->base == 0 ? nullptr : wholeFrame(begin->base);
  if (begin->base != 0 && base == nullptr) {
    ++framesBegun_;
    loseFrame(ErrorCode::kNoBase, frame);
    return true;
  }
  Buffer* target = freeBuffer(base);
  if (target == nullptr) {
    const bool willBeFree =
        std::ranges::any_of(buffers_, [&](const Buffer& buffer) { return isWaiting(buffer) && buffer.present; });
    if (willBeFree) {
      return false;
    }
    ++framesBegun_;
    loseFrame(ErrorCode::kNoBase, frame);  // it could only be made in the place of its own base
    return true;
  }
  ++framesBegun_;
  target->state = BufferState::kReceiving;
  target->frame = frame;
  target->present.reset();
  target->shownCoarse = false;
  receiving_ = target;
  assembler_.begin(*begin, base == nullptr ? nullptr : &base->volume, target->volume);
  return true;
}

/// A part of a frame that is lost, or whose begin was: that is reported once.
bool Firmware::isOrphan(const wire::Message& message) {
  if (receiving_ != nullptr) {
    return false;
  }
  if (message.header.frame != lastLost_) {
    loseFrame(ErrorCode::kOutOfPlace, message.header.frame);
  }
  return true;
}

void Firmware::takeSlice(const wire::Message& message) {
  if (isOrphan(message)) {
    return;
  }
  const ErrorCode error = message.header.frame != receiving_->frame ? ErrorCode::kOutOfPlace
                                                                    : assembler_.slice(message.header, message.payload);
  if (error != ErrorCode::kNone) {
    loseFrame(error, message.header.frame);
  }
}

void Firmware::endFrame(const wire::Message& message) {
  if (isOrphan(message)) {
    return;
  }
  const auto end = wire::frameEndFrom(message.payload);
  const ErrorCode error = message.header.frame != receiving_->frame ? ErrorCode::kOutOfPlace
                          : !end                                    ? ErrorCode::kLength
                                                                    : assembler_.end(*end);
  if (error != ErrorCode::kNone) {
    loseFrame(error, message.header.frame);
    return;
  }
  receiving_->state = BufferState::kWhole;
  newestWhole_ = receiving_->frame;
  ++counts_.framesArrived;
  report(EventType::kArrived, receiving_->frame);
  if (arrivals_ != nullptr) {
    arrivals_->frameArrived(session_, receiving_->frame, receiving_->volume);
  }
  receiving_ = nullptr;
}

void Firmware::takePresent(const wire::Message& message) {
  const auto present = wire::presentFrom(message.payload);
  const bool anyPhase = (options_.capabilities & wire::kCanAnyPhase) != 0;
  const bool possible =
      present && (present->atNextRefresh || present->slice == 0 ||
                  (anyPhase && present->slice < static_cast<size_t>(options_.profile.storedSlices())));
  if (!possible) {
    loseFrame(ErrorCode::kLength, message.header.frame);
    return;
  }
  // A frame that is lost or shown already needs no time.
  Buffer* buffer = bufferOf(message.header.frame);
  if (buffer != nullptr && buffer != front_ && message.header.frame != 0) {
    buffer->present = *present;
  }
}

void Firmware::advance(DeviceMicroseconds now) {
  now_ = std::max(now_, now);
  while (rotor_.end() <= now_) {
    stepTo(options_.profile.storedSlices() - 1);
    endRefresh();
    rotor_.nextRefresh();
    place_ = {rotor_.refresh(), 0};
    changeFrames(place_);
  }
  stepTo(rotor_.sliceAt(now_));
}

DeviceMicroseconds Firmware::nextChange() const {
  return place_.slice + 1 < options_.profile.storedSlices() ? rotor_.beginOf(place_.slice + 1) : rotor_.end();
}

void Firmware::stepTo(int slice) {
  while (place_.slice < slice) {
    ++place_.slice;
    changeFrames(place_);
  }
}

bool Firmware::isDue(const Buffer& buffer, Place place) const {
  if (!buffer.present) {
    return false;
  }
  const wire::Present& present = *buffer.present;
  if (present.atNextRefresh) {
    return place.slice == 0;
  }
  const Place at{present.refresh, present.slice};
  const bool anySlice = present.tearWhenLate && (options_.capabilities & wire::kCanAnyPhase) != 0;
  return place == at || (place > at && (anySlice || place.slice == at.slice));
}

void Firmware::changeFrames(Place place) {
  Buffer* next = nullptr;
  for (Buffer& buffer : buffers_) {
    if (isWaiting(buffer) && isDue(buffer, place) && (next == nullptr || buffer.frame > next->frame)) {
      next = &buffer;
    }
  }
  Buffer* coming = receiving_;
  const bool shows = coming != nullptr && !coming->shownCoarse && (options_.capabilities & wire::kCanCoarse) != 0 &&
                     isDue(*coming, place) && coming->present->coarseWhenLate && !coming->present->atNextRefresh;
  // It is newer than all that are whole.
  if (shows && assembler_.received() > 0) {
    keepShownSlices(place.slice);
    coarse_.volume = coming->volume;
    coarse_.frame = coming->frame;
    coarse_.present = coming->present;
    assembler_.fillGaps(coarse_.volume);
    coming->shownCoarse = true;
    show(coarse_, place, true);
  } else if (next != nullptr) {
    show(*next, place, false);
  }
}

void Firmware::show(Buffer& buffer, Place place, bool coarse) {
  if (!coarse) {
    keepShownSlices(place.slice);
  }
  uint8_t flags = static_cast<uint8_t>((coarse ? wire::kEventCoarse : 0) | (place.slice > 0 ? wire::kEventTorn : 0));
  if (buffer.present && !buffer.present->atNextRefresh &&
      place > Place{buffer.present->refresh, buffer.present->slice}) {
    flags |= wire::kEventLate;
    const uint64_t refreshes = place.refresh - buffer.present->refresh;
    counts_.underruns += static_cast<uint32_t>(std::min<uint64_t>(std::max<uint64_t>(refreshes, 1), 1u << 20));
  }
  if (front_ != &coarse_) {
    front_->state = BufferState::kFree;
    front_->frame = 0;
    front_->present.reset();
  }
  front_ = &buffer;
  for (Buffer& other : buffers_) {
    if (isWaiting(other) && other.frame < buffer.frame) {
      ++counts_.framesDropped;
      report(EventType::kDropped, other.frame);
      other.state = BufferState::kFree;
      other.frame = 0;
      other.present.reset();
    }
  }
  counts_.framesShown += coarse ? 0 : 1;
  report(EventType::kShown, buffer.frame, static_cast<uint16_t>(place.slice), flags);
  showPart({place.slice, buffer.frame, coarse});
}

void Firmware::showPart(const ShownRefresh::Part& part) {
  if (part.fromSlice == 0) {
    shown_.parts.clear();
  }
  shown_.parts.push_back(part);
}

/// Of the refresh under way, before the frame changes at this slice.
void Firmware::keepShownSlices(int upTo) {
  if (sink_ == nullptr || upTo == 0) {
    return;
  }
  if (kept_ == nullptr) {
    kept_ = std::make_unique<Volume>(options_.profile);
  }
  for (int i = shown_.parts.back().fromSlice; i < upTo; ++i) {
    std::ranges::copy(front_->volume.slice(i), kept_->slice(i).begin());
  }
}

void Firmware::endRefresh() {
  if (sink_ != nullptr) {
    shown_.refresh = rotor_.refresh();
    shown_.begin = rotor_.begin();
    shown_.length = rotor_.end() - rotor_.begin();
    shown_.phaseErrorDegrees = rotor_.phaseErrorDegrees();
    if (shown_.parts.size() > 1) {
      keepShownSlices(options_.profile.storedSlices());
      sink_->refreshEnded(shown_, *kept_);
    } else {
      sink_->refreshEnded(shown_, front_->volume);
    }
  }
  shown_.parts = {{0, shown_.parts.back().frame, shown_.parts.back().coarse}};
}

void Firmware::report(EventType type, uint32_t frame, uint16_t code, uint8_t flags) {
  if (events_.size() == kMaxEvents) {
    events_.pop_front();
  }
  events_.push_back({.type = type,
                     .flags = flags,
                     .code = code,
                     .session = session_,
                     .frame = frame,
                     .timeMicroseconds = static_cast<uint64_t>(now_),
                     .refresh = static_cast<uint32_t>(place_.refresh)});
}

std::vector<uint8_t> Firmware::takeEvents(size_t most) {
  std::vector<uint8_t> bytes;
  while (!events_.empty() && bytes.size() + wire::kEventBytes <= most) {
    const auto event = toBytes(events_.front());
    bytes.insert(bytes.end(), event.begin(), event.end());
    events_.pop_front();
  }
  return bytes;
}

}  // namespace ocelli
