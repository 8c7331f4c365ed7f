#include <algorithm>
#include <utility>

#include "display_driver/wire/streaming_device.h"

namespace ocelli {
namespace {

/// Slices that are coded before the link is looked after again: a few milliseconds of work.
constexpr size_t kSlicesAtOnce = 24;

}  // namespace

/// The buffer that messages are put in: nullptr where all are on their way.
std::vector<uint8_t>* StreamingDevice::staging() {
  if (staging_ == nullptr) {
    const auto free = std::ranges::find(buffers_, uint64_t{0}, &Buffer::transfer);
    staging_ = free == buffers_.end() ? nullptr : &*free;
  }
  return staging_ == nullptr ? nullptr : &staging_->bytes;
}

void StreamingDevice::flush() {
  if (staging_ == nullptr || staging_->bytes.empty()) {
    return;
  }
  if (transfersDone_ == transfers_) {
    lastProgress_ = Clock::now();  // the link was at rest
  }
  staging_->transfer = ++transfers_;
  if (!link_->send(static_cast<size_t>(staging_ - buffers_.data()), staging_->bytes)) {
    transfersDone_ = transfers_;
    staging_->transfer = 0;
    staging_->bytes.clear();
    problem_ = problem_.value_or(wire::LinkStatus::kFailed);
  }
  staging_ = nullptr;
}

/// Some more of the stream. False where nothing can be done now.
bool StreamingDevice::sendSome() {
  if (staging() == nullptr) {
    if (sending_ != nullptr) {
      sending_->waited = true;
    }
    return false;
  }
  sendPresentations();
  if (sending_ == nullptr) {
    beginFrame();
  }
  if (sending_ == nullptr) {
    flush();
    return false;
  }
  if (nextCoded_ == coded_.size()) {
    coded_ = encoder_->next(kSlicesAtOnce);
    nextCoded_ = 0;
  }
  std::vector<uint8_t>& out = *staging();
  const size_t before = out.size();
  while (nextCoded_ < coded_.size() && out.size() < options_.transferBytes) {
    const wire::FrameEncoder::Coded& coded = coded_[nextCoded_++];
    writer_->slice(out, sending_->number(), coded.slice, coded.coded);
  }
  const bool whole = nextCoded_ == coded_.size() && encoder_->slicesLeft() == 0;
  if (whole) {
    writer_->frameEnd(out, sending_->number());
  }
  {
    const std::lock_guard lock(mutex_);
    sending_->state.bytes += out.size() - before;
    if (whole) {
      sending_->wholeSent = true;
      sending_->coded = Clock::now();
      sending_->lastTransfer = transfers_ + 1;
      base_ = sending_->volume;
      baseNumber_ = sending_->number();
      if (sending_->presentation) {
        noteSent(*sending_);
      }
    }
  }
  if (whole) {
    sending_.reset();
  }
  if (whole || out.size() >= options_.transferBytes) {
    flush();
  }
  return true;
}

void StreamingDevice::beginFrame() {
  {
    const std::lock_guard lock(mutex_);
    if (waiting_ == nullptr) {
      return;
    }
    sending_ = std::move(waiting_);
    waiting_.reset();
    sending_->moveTo(FrameStage::kSending);
    underWay_.emplace(sending_->number(), sending_);
  }
  std::optional<std::span<const int>> candidates;
  if (base_ != nullptr && sending_->changed) {
    candidates = *sending_->changed;
  }
  sending_->begun = Clock::now();
  sending_->waited = false;
  encoder_->setEffort(effort_.effort());
  encoder_->begin(*sending_->volume, base_.get(), candidates);
  coded_.clear();
  nextCoded_ = 0;
  std::vector<uint8_t>& out = *staging();
  const size_t before = out.size();
  writer_->frameBegin(out, sending_->number(), {base_ == nullptr ? 0 : baseNumber_, encoder_->records()});
  {
    const std::lock_guard lock(mutex_);
    sending_->state.bytes = out.size() - before;
  }
  sendPresentations();
}

void StreamingDevice::sendPresentations() {
  const std::lock_guard lock(mutex_);
  for (const auto& [number, frame] : underWay_) {
    if (frame->presentation && !frame->presentationSent) {
      frame->presentationSent = true;
      writer_->present(*staging(), number, toWire(*frame->presentation));
      if (frame->wholeSent) {
        noteSent(*frame);
      }
    }
  }
}

}  // namespace ocelli
