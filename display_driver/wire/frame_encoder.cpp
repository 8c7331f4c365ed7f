#include "display_driver/wire/frame_encoder.h"

#include <algorithm>

#include "oc_core/base/parallel.h"

namespace ocelli::wire {
namespace {

/// Parts that a batch of slices is coded in, each with a coder of its own.
constexpr size_t kCoders = 8;

}  // namespace

void MessageWriter::append(std::vector<uint8_t>& out, MessageHeader header, std::span<const uint8_t> payload) {
  header.session = session_;
  header.sequence = sequence_++;
  header.payloadBytes = static_cast<uint32_t>(payload.size());
  header.payloadChecksum = crc32c(payload);
  const auto bytes = toBytes(header);
  out.insert(out.end(), bytes.begin(), bytes.end());
  out.insert(out.end(), payload.begin(), payload.end());
  if (header.type == MessageType::kSlice) {
    ++end_.records;
    end_.checksum = crc32cOfNumber(header.payloadChecksum, end_.checksum);
  }
}

void MessageWriter::frameBegin(std::vector<uint8_t>& out, uint32_t frame, const FrameBegin& begin) {
  end_ = {};
  append(out, {.type = MessageType::kFrameBegin, .frame = frame}, toBytes(begin));
}

void MessageWriter::slice(std::vector<uint8_t>& out, uint32_t frame, int slice, const CodedSlice& coded) {
  append(out,
         {.type = MessageType::kSlice, .coding = coded.coding, .slice = static_cast<uint16_t>(slice), .frame = frame},
         coded.payload);
}

void MessageWriter::frameEnd(std::vector<uint8_t>& out, uint32_t frame) {
  append(out, {.type = MessageType::kFrameEnd, .frame = frame}, toBytes(end_));
}

void MessageWriter::present(std::vector<uint8_t>& out, uint32_t frame, const Present& present) {
  append(out, {.type = MessageType::kPresent, .frame = frame}, toBytes(present));
}

FrameEncoder::FrameEncoder(const DisplayProfile& profile, uint32_t capabilities)
    : order_(coarseToFineOrder(profile.storedSlices())) {
  for (size_t i = 0; i < kCoders; ++i) {
    coders_.push_back(std::make_unique<SliceCoder>(capabilities));
  }
}

FrameEncoder::~FrameEncoder() = default;

void FrameEncoder::setEffort(Effort effort) {
  for (const std::unique_ptr<SliceCoder>& coder : coders_) {
    coder->setEffort(effort);
  }
}

void FrameEncoder::begin(const Volume& volume, const Volume* base, std::optional<std::span<const int>> candidates) {
  volume_ = &volume;
  base_ = base;
  const auto count = static_cast<size_t>(volume.slices());
  std::vector<uint8_t> differs(count, candidates ? 0 : 1);
  if (candidates) {
    for (const int slice : *candidates) {
      differs[static_cast<size_t>(slice)] = 1;
    }
  }
  parallelFor(count, 4, [&](size_t from, size_t to) {
    for (size_t i = from; i < to; ++i) {
      if (differs[i] != 0) {
        const auto slice = static_cast<int>(i);
        const bool same =
            base == nullptr ? isDark(volume.slice(slice)) : areEqual(volume.slice(slice), base->slice(slice));
        differs[i] = same ? 0 : 1;
      }
    }
  });
  records_.assign(count, false);
  left_.clear();
  at_ = 0;
  for (const int slice : order_) {
    if (differs[static_cast<size_t>(slice)] != 0) {
      records_[static_cast<size_t>(slice)] = true;
      left_.push_back(slice);
    }
  }
}

std::vector<FrameEncoder::Coded> FrameEncoder::next(size_t most) {
  std::vector<Coded> coded(std::min(most, slicesLeft()));
  parallelChunks(coded.size(), std::min(kCoders, coded.size()), [&](size_t chunk, size_t from, size_t to) {
    for (size_t i = from; i < to; ++i) {
      const int slice = left_[at_ + i];
      const std::span<const uint8_t> base = base_ == nullptr ? std::span<const uint8_t>() : base_->slice(slice);
      coded[i] = {slice, coders_[chunk]->encode(volume_->slice(slice), base)};
    }
  });
  at_ += coded.size();
  return coded;
}

}  // namespace ocelli::wire
