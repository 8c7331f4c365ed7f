#include "display_sim/frames/svol_writer.h"

#include <algorithm>

#include "display_sim/frames/svol_codec.h"
#include "display_sim/frames/svol_metadata.h"
#include "oc_core/base/check.h"
#include "oc_core/base/error.h"
#include "oc_core/base/parallel.h"

namespace ocelli {
SvolWriter::SvolWriter(std::filesystem::path path, const DisplayProfile& profile, SvolOptions options)
    : path_(std::move(path)), options_(std::move(options)), file_(path_), profile_(profile) {
  OC_CHECK(options_.framesPerKey >= 1, "some frames must be key frames");
  svol::requireMetadata(options_.metadata, path_.string());
  if (options_.framesPerKey > 1) {
    previous_.emplace(profile_);
  }
  write(svol::headerRecord(profile, options_.metadata));
  if (options_.growing) {
    file_.publish();
  }
}

void SvolWriter::write(std::span<const uint8_t> bytes) {
  file_.write(bytes);
  bytes_ += bytes.size();
}

void SvolWriter::requireUsable() const {
  if (!usable_) {
    throw WorkError("nothing more can be written after a failure, or after the end", path_.string(),
                    "start another file");
  }
}

void SvolWriter::append(const Volume& volume, uint64_t timeMicroseconds) {
  requireUsable();
  OC_CHECK(volume.profile() == profile_, "a volume of another display");
  OC_CHECK(frames_.empty() || frames_.back().timeMicroseconds <= timeMicroseconds, "time runs backwards");
  OC_CHECK(timeMicroseconds <= svol::kMaxMicroseconds, "no recording is that long");
  const bool key = frames_.size() % static_cast<size_t>(options_.framesPerKey) == 0;
  const size_t slices = volume.layout().slices;
  std::vector<svol::EncodedSlice> encoded(slices);
  usable_ = false;
  parallelFor(slices, svol::kSlicesPerRange, [&](size_t begin, size_t end) {
    svol::SliceEncoder encoder;
    for (size_t i = begin; i < end; ++i) {
      const std::span<const uint8_t> planes = volume.slice(static_cast<int>(i));
      const std::span<uint8_t> before = previous_ ? previous_->slice(static_cast<int>(i)) : std::span<uint8_t>();
      encoded[i] = encoder.encode(planes, key ? std::span<const uint8_t>() : before);
      if (previous_ && encoded[i].entry.kind != SvolSliceKind::kUnchanged) {
        std::ranges::copy(planes, before.begin());
      }
    }
  });
  svol::FrameHead head{static_cast<uint32_t>(frames_.size()), timeMicroseconds, key, {}};
  for (const svol::EncodedSlice& slice : encoded) {
    head.slices.push_back(slice.entry);
  }
  const uint64_t offset = bytes_;
  write(svol::frameRecordHead(head));
  for (const svol::EncodedSlice& slice : encoded) {
    write(slice.payload);
  }
  if (options_.growing) {
    file_.flush();
  }
  frames_.push_back({offset, timeMicroseconds, key});
  usable_ = true;
}

void SvolWriter::finish() {
  requireUsable();
  usable_ = false;
  write(svol::indexAndEnd(frames_, bytes_));
  file_.commit();
}

}  // namespace ocelli
