// A frame on its way from submit() to the display.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "display_driver/device/device.h"
#include "display_driver/wire/wire_format.h"

namespace ocelli {

struct OutgoingFrame {
  explicit OutgoingFrame(FrameNumber number) : fence(std::make_shared<FrameFence>(number)) {}

  FrameNumber number() const { return fence->number(); }
  void moveTo(FrameStage stage) {
    state.stage = stage;
    fence->moveTo(state);
  }
  void end(FrameStage stage, std::string problem) {
    state.problem = std::move(problem);
    moveTo(stage);
  }

  std::shared_ptr<FrameFence> fence;
  FrameState state;
  std::shared_ptr<const Volume> volume;
  std::optional<std::vector<int>> changed;  ///< since the frame that was begun before it; nullopt: perhaps all
  std::optional<Presentation> presentation;
  std::chrono::steady_clock::time_point begun{};  ///< to be coded
  std::chrono::steady_clock::time_point coded{};
  bool waited = false;  ///< for the link, with a part of it
  bool presentationSent = false;
  bool wholeSent = false;     ///< all of its bytes are in transfers
  uint64_t lastTransfer = 0;  ///< the one with its last byte, counted from 1; 0: not known yet
};

/// Slices in either list; nullopt is all of them.
std::optional<std::vector<int>> unite(const std::optional<std::vector<int>>& a,
                                      const std::optional<std::vector<int>>& b);

wire::Present toWire(const Presentation& presentation);

}  // namespace ocelli
