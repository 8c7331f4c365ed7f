#include "display_driver/wire/frame_assembler.h"

#include <algorithm>

#include "oc_core/base/check.h"

namespace ocelli::wire {

FrameAssembler::FrameAssembler(const DisplayProfile& profile, uint32_t capabilities)
    : decoder_(profile, capabilities) {}

void FrameAssembler::begin(const FrameBegin& begin, const Volume* base, Volume& target) {
  OC_CHECK(begin.records.size() == static_cast<size_t>(target.slices()), "a frame of another display");
  OC_CHECK(base != &target, "a frame cannot be made from itself in place");
  base_ = base;
  target_ = &target;
  due_ = begin.records;
  received_ = 0;
  checksum_ = 0;
  for (int i = 0; i < target.slices(); ++i) {
    if (due_[static_cast<size_t>(i)]) {
      continue;
    }
    if (base != nullptr) {
      std::ranges::copy(base->slice(i), target.slice(i).begin());
    } else {
      std::ranges::fill(target.slice(i), uint8_t{0});
    }
  }
}

ErrorCode FrameAssembler::slice(const MessageHeader& header, std::span<const uint8_t> payload) {
  OC_CHECK(active(), "no frame has begun");
  if (header.slice >= due_.size() || !due_[header.slice]) {
    return ErrorCode::kSlice;
  }
  const std::span<const uint8_t> base =
      base_ == nullptr ? std::span<const uint8_t>() : base_->slice(static_cast<int>(header.slice));
  const ErrorCode error = decoder_.decode(header.coding, payload, base, target_->slice(header.slice));
  if (error != ErrorCode::kNone) {
    return error;
  }
  due_[header.slice] = false;
  ++received_;
  checksum_ = crc32cOfNumber(header.payloadChecksum, checksum_);
  return ErrorCode::kNone;
}

ErrorCode FrameAssembler::end(const FrameEnd& end) {
  OC_CHECK(active(), "no frame has begun");
  if (end.records != received_ || std::ranges::find(due_, true) != due_.end()) {
    return ErrorCode::kIncomplete;
  }
  if (end.checksum != checksum_) {
    return ErrorCode::kChecksum;
  }
  target_ = nullptr;
  return ErrorCode::kNone;
}

bool FrameAssembler::fillGaps(Volume& volume) const {
  if (received_ == 0) {
    return false;
  }
  std::vector<bool> present = due_;
  present.flip();
  const std::vector<int> nearest = nearestPresent(present);
  for (int i = 0; i < volume.slices(); ++i) {
    const int from = nearest[static_cast<size_t>(i)];
    if (from != i) {
      std::ranges::copy(volume.slice(from), volume.slice(i).begin());
    }
  }
  return true;
}

}  // namespace ocelli::wire
