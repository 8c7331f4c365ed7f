#include "display_driver/devices/coarse_frames.h"

#include <algorithm>
#include <cmath>

#include "display_driver/wire/frame_assembler.h"
#include "display_driver/wire/frame_encoder.h"
#include "oc_core/base/check.h"

namespace ocelli {
namespace {

constexpr uint32_t kCapabilities = wire::kCanZstd | wire::kCanRunLength;

}  // namespace

std::vector<CoarseFrame> coarseFrames(const Volume& volume, std::span<const double> shares) {
  wire::FrameEncoder encoder(volume.profile(), kCapabilities);
  encoder.begin(volume, nullptr, std::nullopt);
  const wire::FrameBegin begin{.base = 0, .records = encoder.records()};
  const std::vector<wire::FrameEncoder::Coded> slices = encoder.next(encoder.slicesLeft());
  std::vector<CoarseFrame> frames;
  for (const double share : shares) {
    OC_CHECK(share > 0 && share <= 1, "a share of a frame");
    CoarseFrame frame{Volume(volume.profile())};
    frame.slices = static_cast<int>(std::ceil(share * static_cast<double>(slices.size())));
    wire::FrameAssembler assembler(volume.profile(), kCapabilities);
    assembler.begin(begin, nullptr, frame.shown);
    frame.bytes = wire::kHeaderBytes + wire::toBytes(begin).size();
    for (const auto& [slice, coded] : std::span(slices).first(static_cast<size_t>(frame.slices))) {
      const wire::ErrorCode error = assembler.slice(
          {.type = wire::MessageType::kSlice, .coding = coded.coding, .slice = static_cast<uint16_t>(slice)},
          coded.payload);
      OC_CHECK(error == wire::ErrorCode::kNone, "a slice of our own does not decode");
      frame.bytes += wire::kHeaderBytes + coded.payload.size();
    }
    assembler.fillGaps(frame.shown);
    frames.push_back(std::move(frame));
  }
  return frames;
}

}  // namespace ocelli
