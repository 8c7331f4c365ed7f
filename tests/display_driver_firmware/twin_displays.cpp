#include "tests/display_driver_firmware/twin_displays.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace ocelli::test {
namespace {

uint32_t maxPayloadOf(Firmware& firmware) {
  const auto identity = firmware.controlIn(1, 0, 64, 0);
  return u32(identity.value(), 16);
}

std::string describe(const SeenEvent& event) {
  return fmt::format("(type {} flags {} code {} frame {} refresh {})", event.type, event.flags, event.code, event.frame,
                     event.refresh);
}

std::string describe(const std::vector<SeenEvent>& events) {
  std::string text;
  for (const SeenEvent& event : events) {
    text += describe(event);
  }
  return text.empty() ? "nothing" : text;
}

/// The page gives no order to frames that are dropped at once.
void sortDropped(std::vector<SeenEvent>& events) {
  for (auto at = events.begin(); at != events.end();) {
    const auto end = std::find_if(at, events.end(), [](const SeenEvent& event) { return event.type != kDropped; });
    std::sort(at, end, [](const SeenEvent& a, const SeenEvent& b) { return a.frame < b.frame; });
    at = end == events.end() ? end : end + 1;
  }
}

std::vector<SeenEvent> eventsOf(ByteSpan bytes, uint32_t session) {
  std::vector<SeenEvent> events;
  for (size_t at = 0; at < bytes.size(); at += 32) {
    const auto event = eventOf(bytes.subspan(at, std::min<size_t>(32, bytes.size() - at)));
    if (!event || event->session != session) {
      throw Difference("an event that is none, or of another session");
    }
    events.push_back(*event);
  }
  return events;
}

}  // namespace

DisplayProfile tinyProfile(int slices, int bits) {
  DisplayProfile profile = loadProfile("test");
  profile.slicesPerHalfTurn = slices;
  profile.width = 13;
  profile.height = 8;
  profile.colorBitsPerChannel = bits;
  return profile;
}

SlowOptions slowOptions(const FirmwareOptions& options, size_t maxPayload) {
  const auto can = [&](uint32_t bit) { return (options.capabilities & bit) != 0; };
  return {.slices = static_cast<size_t>(options.profile.storedSlices()),
          .width = static_cast<size_t>(options.profile.width),
          .height = static_cast<size_t>(options.profile.height),
          .bits = static_cast<size_t>(options.profile.colorBitsPerChannel),
          .buffers = static_cast<size_t>(options.frameBuffers),
          .maxPayload = maxPayload,
          .runLength = can(1),
          .zstd = can(2),
          .differences = can(4),
          .coarse = can(8),
          .anyPhase = can(16)};
}

Slices slicesOf(const Volume& volume) {
  Slices slices;
  for (int i = 0; i < volume.slices(); ++i) {
    const auto slice = volume.slice(i);
    slices.emplace_back(slice.begin(), slice.end());
  }
  return slices;
}

TwinDisplays::TwinDisplays(const FirmwareOptions& options)
    : firmware_(options), slow_(slowOptions(options, maxPayloadOf(firmware_))) {
  firmware_.setSink(this);
  firmware_.setArrivalSink(this);
}

void TwinDisplays::refreshEnded(const ShownRefresh& refresh, const Volume& volume) {
  Ended ended{slicesOf(volume), {}};
  for (const ShownRefresh::Part& part : refresh.parts) {
    ended.parts.emplace_back(static_cast<size_t>(part.fromSlice), part.coarse ? -int64_t{part.frame} : part.frame);
  }
  ended_.push_back(std::move(ended));
}

void TwinDisplays::frameArrived(uint32_t session, uint32_t frame, const Volume& volume) {
  if (session != session_ || !arrived_.emplace(frame, slicesOf(volume)).second) {
    throw Difference("a frame arrived twice, or of another session");
  }
  arrivedFrames_.push_back(frame);
}

void TwinDisplays::arm(uint32_t session) {
  session_ = session;
  waiting_.clear();
  arrivedFrames_.clear();
  slow_.arm(session);
  if (!firmware_.controlOut(3, 1, armRecord(session), now_)) {
    throw Difference("a session was refused");
  }
  compare();
}

void TwinDisplays::disarm() {
  session_ = 0;
  waiting_.clear();
  slow_.disarm();
  if (!firmware_.controlOut(3, 0, armRecord(0), now_)) {
    throw Difference("the end of a session was refused");
  }
  compare();
}

void TwinDisplays::reset() {
  session_ = 0;
  waiting_.clear();
  slow_.reset();
  if (!firmware_.controlOut(5, 0, {}, now_)) {
    throw Difference("a reset was refused");
  }
  compare();
}

void TwinDisplays::send(ByteSpan bytes) {
  append(waiting_, bytes);
  offer();
  compare();
}

void TwinDisplays::offer() {
  const size_t taken = firmware_.receive(waiting_, now_);
  if (taken > waiting_.size()) {
    throw Difference("more was taken than there was");
  }
  slow_.take(ByteSpan(waiting_).first(taken));
  if (taken < waiting_.size() && !slow_.full()) {
    throw Difference("bytes were not taken, though there is room");
  }
  waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(taken));
}

void TwinDisplays::step() {
  now_ = firmware_.nextChange();
  firmware_.advance(now_);
  slow_.step();
  compare();
  offer();
  compare();
}

void TwinDisplays::compare() {
  std::vector<SeenEvent> got = eventsOf(firmware_.takeEvents(size_t{1} << 20), session_);
  std::vector<SeenEvent> wanted = slow_.takeEvents();
  sortDropped(got);
  sortDropped(wanted);
  const auto same = [](const SeenEvent& a, const SeenEvent& b) {
    return a.type == b.type && a.flags == b.flags && a.code == b.code && a.frame == b.frame && a.refresh == b.refresh;
  };
  if (!std::ranges::equal(got, wanted, same)) {
    throw Difference(fmt::format("events: {} instead of {}", describe(got), describe(wanted)));
  }
  events += got.size();
  if (std::exchange(arrived_, {}) != slow_.takeArrived()) {
    throw Difference("frames arrived otherwise");
  }
  for (const Ended& ended : std::exchange(ended_, {})) {
    if (ended.parts != slow_.lastRefresh().parts) {
      std::string text;
      for (const auto* parts : {&ended.parts, &slow_.lastRefresh().parts}) {
        for (const auto& [slice, frame] : *parts) {
          text += fmt::format(" {}:{}", slice, frame);
        }
        text += ";";
      }
      throw Difference("parts:" + text);
    }
    if (ended.slices != slow_.lastRefresh().slices) {
      throw Difference("what was shown");
    }
    ++refreshes;
  }
  const auto telemetry = firmware_.controlIn(4, 0, 64, now_);
  if (u32(*telemetry, 4) != session_ || u64(*telemetry, 16) != slow_.phase().refresh ||
      u32(*telemetry, 40) != slow_.arrived || u32(*telemetry, 44) != slow_.shown ||
      u32(*telemetry, 48) != slow_.dropped || u16(*telemetry, 56) != slow_.lastError) {
    throw Difference(fmt::format("telemetry: refresh {} {}, arrived {} {}, shown {} {}, dropped {} {}, error {} {}",
                                 u64(*telemetry, 16), slow_.phase().refresh, u32(*telemetry, 40), slow_.arrived,
                                 u32(*telemetry, 44), slow_.shown, u32(*telemetry, 48), slow_.dropped,
                                 u16(*telemetry, 56), slow_.lastError));
  }
}

WildHost::WildHost(TwinDisplays& displays, const SlowOptions& options, Choice choice, size_t wildness)
    : displays_(displays), options_(options), choice_(std::move(choice)), wildness_(wildness) {}

Bytes WildHost::planes() {
  Bytes bytes(options_.sliceBytes());
  for (size_t lit = choice_(4); lit > 0; --lit) {
    const size_t column = choice_(options_.width);
    const size_t row = choice_(3 * options_.bits * options_.height);
    uint8_t& byte = bytes[row * options_.rowBytes() + column / 8];
    byte = static_cast<uint8_t>(byte | 1u << (column % 8));
  }
  return bytes;
}

void WildHost::message(uint8_t type, ByteSpan payload, uint8_t coding, size_t slice) {
  Header header{type, coding, static_cast<uint16_t>(slice), session_, sequence_, frame_};
  if (!wrong()) {
    displays_.send(messageBytes(header, payload));
    ++sequence_;
    return;
  }
  switch (choice_(10)) {
    case 0:  // lost
      ++sequence_;
      return;
    case 1:
      header.type = static_cast<uint8_t>(choice_(256));
      break;
    case 2:
      header.frame = static_cast<uint32_t>(frame_ + choice_(4) - 2);
      break;
    case 3:
      header.slice = static_cast<uint16_t>(choice_(options_.slices + 2));
      break;
    case 4:
      header.session = static_cast<uint32_t>(choice_(3));
      break;
    case 5:
      header.coding = static_cast<uint8_t>(choice_(256));
      break;
    case 6: {  // cut short
      const Bytes bytes = messageBytes(header, payload);
      displays_.send(ByteSpan(bytes).first(choice_(bytes.size())));
      ++sequence_;
      return;
    }
    case 7: {  // a few wrong bits
      Bytes bytes = messageBytes(header, payload);
      for (size_t bits = 1 + choice_(3); bits > 0; --bits) {
        const size_t bit = choice_(8 * bytes.size());
        bytes[bit / 8] = static_cast<uint8_t>(bytes[bit / 8] ^ 1u << (bit % 8));
      }
      displays_.send(bytes);
      ++sequence_;
      return;
    }
    case 8: {  // another payload with the right checksums
      Bytes other(payload.begin(), payload.end());
      if (!other.empty()) {
        other[choice_(other.size())] = static_cast<uint8_t>(choice_(256));
      }
      other.resize(choice_(2) == 0 ? other.size() : choice_(options_.maxPayload + 3));
      displays_.send(messageBytes(header, other));
      ++sequence_;
      return;
    }
    default:  // twice
      displays_.send(messageBytes(header, payload));
      header.sequence += static_cast<uint32_t>(choice_(2));
      sequence_ = header.sequence;
  }
  displays_.send(messageBytes(header, payload));
  ++sequence_;
}

void WildHost::beginFrame() {
  ++frame_;
  base_ = 0;
  const auto& arrived = displays_.arrivedFrames();
  if (wrong()) {
    base_ = static_cast<uint32_t>(choice_(frame_ + 2));
  } else if (!arrived.empty() && choice_(3) != 0) {
    base_ = arrived[arrived.size() - 1 - choice_(std::min<size_t>(arrived.size(), 3))];
  }
  std::vector<bool> announced(options_.slices);
  toSend_.clear();
  for (size_t i = 0; i < options_.slices; ++i) {
    announced[i] = choice_(3) != 0;
    if (announced[i]) {
      toSend_.insert(toSend_.begin() + static_cast<std::ptrdiff_t>(choice_(toSend_.size() + 1)), i);
    }
  }
  sums_.clear();
  open_ = true;
  message(kFrameBegin, frameBeginPayload(base_, announced));
}

void WildHost::sendSlices(size_t count) {
  for (; count > 0 && !toSend_.empty(); --count) {
    const size_t slice = toSend_.back();
    toSend_.pop_back();
    const Bytes content = planes();
    auto coding = static_cast<uint8_t>(choice_(3));
    const bool takes = coding == kRaw || (coding == kRunLength ? options_.runLength : options_.zstd);
    coding = takes || wrong() ? coding : kRaw;
    const Bytes payload = coding == kRaw         ? content
                          : coding == kRunLength ? runLengthPayload(content)
                                                 : zstdPayload(content);
    if (choice_(2) == 0 && ((base_ != 0 && options_.differences) || wrong())) {
      coding = static_cast<uint8_t>(coding | kDifference);
    }
    sums_.push_back(checksum(payload));
    message(kSlice, payload, coding, slice);
  }
}

void WildHost::endFrame() {
  message(kFrameEnd, frameEndPayload(sums_.size() + (wrong() ? 1 : 0), sums_));
  open_ = false;
}

void WildHost::present() {
  const auto flags = static_cast<uint16_t>(wrong() ? choice_(32) : choice_(8));
  const uint64_t refresh = displays_.slow().phase().refresh + choice_(3);
  const size_t slice = options_.anyPhase || wrong() ? choice_(options_.slices + (wrong() ? 1 : 0)) : 0;
  const uint32_t frame = frame_;
  frame_ -= static_cast<uint32_t>(frame_ > 1 && choice_(6) == 0 ? 1 : 0);
  message(kPresent, presentPayload(refresh - (refresh > 0 ? choice_(2) : 0), static_cast<uint16_t>(slice), flags));
  frame_ = frame;
}

void WildHost::doSomething() {
  if (!armed_ || choice_(400) == 0) {
    armed_ = true;
    session_ += 1 + static_cast<uint32_t>(choice_(2));
    sequence_ = frame_ = 0;
    open_ = false;
    displays_.arm(session_);
    return;
  }
  if (wrong()) {
    switch (choice_(8)) {
      case 0:
        displays_.disarm();
        armed_ = choice_(8) == 0;
        return;
      case 1:
        displays_.reset();
        armed_ = choice_(8) == 0;
        return;
      case 2: {
        Bytes noise(choice_(80));
        for (uint8_t& byte : noise) {
          byte = static_cast<uint8_t>(choice_(256));
        }
        displays_.send(noise);
        return;
      }
      case 3:
        open_ = false;
        return;
      default:
        break;
    }
  }
  const bool blocked = !displays_.idle();
  const size_t action = blocked ? 9 : choice_(10);
  if (action < 6) {
    if (!open_) {
      beginFrame();
    } else if (toSend_.empty() || wrong()) {
      endFrame();
    } else {
      sendSlices(action < 4 ? toSend_.size() : 1 + choice_(3));
    }
  } else if (action < 8) {
    if (frame_ != 0) {
      present();
    }
  } else {
    for (size_t steps = 1 + choice_(3); steps > 0; --steps) {
      displays_.step();
    }
  }
}

}  // namespace ocelli::test
