// A firmware on a bench: a host that writes what a test tells it to, events as they were read, refreshes as they were
// shown. Nothing turns by itself.
#pragma once

#include <gtest/gtest.h>

#include <ostream>

#include "tests/display_driver_firmware/twin_displays.h"

namespace ocelli::test {

inline void PrintTo(const SeenEvent& event, std::ostream* out) {
  constexpr const char* kNames[] = {"?", "ARRIVED", "SHOWN", "DROPPED", "ERROR"};
  *out << kNames[event.type < 5 ? event.type : 0] << " frame " << event.frame << " code " << event.code << " flags "
       << int{event.flags} << " refresh " << event.refresh;
}

inline auto isArrived(uint32_t frame) {
  return testing::Truly([=](const SeenEvent& event) { return event.type == kArrived && event.frame == frame; });
}
inline auto isDropped(uint32_t frame) {
  return testing::Truly([=](const SeenEvent& event) { return event.type == kDropped && event.frame == frame; });
}
inline auto isError(uint16_t code, uint32_t frame) {
  return testing::Truly(
      [=](const SeenEvent& event) { return event.type == kError && event.code == code && event.frame == frame; });
}
inline auto isShown(uint32_t frame, Phase at, uint8_t flags = 0) {
  return testing::Truly([=](const SeenEvent& event) {
    return event.type == kShown && event.frame == frame && event.refresh == at.refresh && event.code == at.slice &&
           event.flags == flags;
  });
}

class FirmwareBench : public testing::Test, public RefreshSink, public ArrivalSink {
 protected:
  static constexpr size_t kSlices = 6;
  static constexpr uint32_t kSession = 0x12345678;

  static FirmwareOptions standard() { return {.profile = tinyProfile(kSlices), .frameBuffers = 3}; }

  /// A new firmware in a new session.
  void start(const FirmwareOptions& options = standard()) {
    firmware_.emplace(options);
    firmware_->setSink(this);
    firmware_->setArrivalSink(this);
    slow_ = slowOptions(options, 0);
    now_ = 0;
    sequence_ = 0;
    arm(kSession);
  }
  void SetUp() override { start(); }

  void arm(uint32_t session) {
    ASSERT_TRUE(firmware_->controlOut(3, 1, armRecord(session), now_));
    session_ = session;
    sequence_ = 0;
  }

  /// How many were taken.
  size_t offer(ByteSpan bytes) { return firmware_->receive(bytes, now_); }
  Bytes message(uint8_t type, uint32_t frame, ByteSpan payload, uint8_t coding = 0, size_t slice = 0) {
    return messageBytes({type, coding, static_cast<uint16_t>(slice), session_, sequence_++, frame}, payload);
  }
  void send(ByteSpan bytes) { ASSERT_EQ(offer(bytes), bytes.size()); }

  static std::vector<bool> all() { return std::vector<bool>(kSlices, true); }
  static std::vector<bool> some(const std::vector<size_t>& which) {
    std::vector<bool> slices(kSlices);
    for (const size_t slice : which) {
      slices[slice] = true;
    }
    return slices;
  }
  /// A slice with something in it that tells its frame and number.
  Bytes planes(uint32_t frame, size_t slice) const {
    Bytes bytes(slow_.sliceBytes());
    bytes[0] = static_cast<uint8_t>(frame);
    bytes[2] = static_cast<uint8_t>(slice + 1);
    return bytes;
  }

  void begin(uint32_t frame, uint32_t base = 0, const std::vector<bool>& slices = all()) {
    sums_.clear();
    send(message(kFrameBegin, frame, frameBeginPayload(base, slices)));
  }
  void slice(uint32_t frame, size_t slice) { sliceWith(frame, slice, kRaw, planes(frame, slice)); }
  void sliceWith(uint32_t frame, size_t slice, uint8_t coding, ByteSpan payload) {
    sums_.push_back(checksum(payload));
    send(message(kSlice, frame, payload, coding, slice));
  }
  void end(uint32_t frame) { send(message(kFrameEnd, frame, frameEndPayload(sums_.size(), sums_))); }
  void present(uint32_t frame, Phase at, uint16_t flags = 0) {
    send(message(kPresent, frame, presentPayload(at.refresh, static_cast<uint16_t>(at.slice), flags)));
  }
  void whole(uint32_t frame) {
    begin(frame);
    for (size_t i = 0; i < kSlices; ++i) {
      slice(frame, i);
    }
    end(frame);
  }
  /// The bytes of a whole frame.
  Bytes wholeBytes(uint32_t frame, uint32_t base = 0) {
    Bytes bytes = message(kFrameBegin, frame, frameBeginPayload(base, all()));
    std::vector<uint32_t> sums;
    for (size_t i = 0; i < kSlices; ++i) {
      sums.push_back(checksum(planes(frame, i)));
      append(bytes, message(kSlice, frame, planes(frame, i), kRaw, i));
    }
    append(bytes, message(kFrameEnd, frame, frameEndPayload(kSlices, sums)));
    return bytes;
  }

  std::vector<SeenEvent> events() {
    std::vector<SeenEvent> events;
    const Bytes bytes = firmware_->takeEvents(size_t{1} << 20);
    for (size_t at = 0; at < bytes.size(); at += 32) {
      const auto event = eventOf(ByteSpan(bytes).subspan(at, 32));
      EXPECT_TRUE(event && event->session == session_ && event->time <= static_cast<uint64_t>(now_));
      events.push_back(event.value_or(SeenEvent{}));
    }
    return events;
  }

  void step() {
    now_ = firmware_->nextChange();
    firmware_->advance(now_);
    if (++phase_.slice == kSlices) {
      phase_ = {phase_.refresh + 1, 0};
    }
  }
  void turnTo(Phase phase) {
    while (phase_ < phase) {
      step();
    }
  }
  /// Fetched anew.
  Bytes telemetry() { return firmware_->controlIn(4, 0, 64, now_).value(); }

  void refreshEnded(const ShownRefresh& refresh, const Volume& volume) override {
    EXPECT_EQ(refresh.refresh, refreshes_.size());
    refreshes_.push_back(refresh);
    images_.push_back(slicesOf(volume));
  }
  void frameArrived(uint32_t session, uint32_t frame, const Volume& volume) override {
    EXPECT_EQ(session, session_);
    arrived_.insert_or_assign(frame, slicesOf(volume));
  }
  /// Of which frame each slice of a refresh was, and which slice of it; {0, 0} where it was dark.
  std::vector<std::pair<uint32_t, size_t>> image(size_t refresh) const {
    std::vector<std::pair<uint32_t, size_t>> image;
    for (const Bytes& slice : images_.at(refresh)) {
      image.emplace_back(slice[0], slice[2]);
    }
    return image;
  }

  std::optional<Firmware> firmware_;
  SlowOptions slow_;
  DeviceMicroseconds now_ = 0;
  Phase phase_;
  uint32_t session_ = 0;
  uint32_t sequence_ = 0;
  std::vector<uint32_t> sums_;
  std::vector<ShownRefresh> refreshes_;
  std::vector<Slices> images_;
  std::map<uint32_t, Slices> arrived_;
};

}  // namespace ocelli::test
