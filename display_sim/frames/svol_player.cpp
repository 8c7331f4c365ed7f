#include "display_sim/frames/svol_player.h"

#include <string>

#include "display_sim/frames/svol_codec.h"
#include "oc_core/base/check.h"
#include "oc_core/base/parallel.h"

namespace ocelli {
SvolPlayer::SvolPlayer(SvolReader& reader) : reader_(reader), volume_(reader.profile()) {}

void SvolPlayer::seek(size_t frame) {
  OC_CHECK(frame < reader_.frames().size(), "there is no such frame");
  size_t next = reader_.keyFrameOf(frame);
  if (frame_ && *frame_ <= frame && *frame_ >= next) {
    next = *frame_ + 1;
  }
  std::vector<uint8_t> changed(volume_.layout().slices, 0);
  frame_.reset();
  for (; next <= frame; ++next) {
    apply(next, changed);
  }
  frame_ = frame;
  changed_.clear();
  for (size_t i = 0; i < changed.size(); ++i) {
    if (changed[i] != 0) {
      changed_.push_back(static_cast<int>(i));
    }
  }
}

void SvolPlayer::apply(size_t frame, std::vector<uint8_t>& changed) {
  const svol::FrameHead head = reader_.readHead(frame);
  reader_.readPayloads(frame, payloads_);
  const size_t slices = head.slices.size();
  std::vector<size_t> begins(slices);
  for (size_t i = 1; i < slices; ++i) {
    begins[i] = begins[i - 1] + head.slices[i - 1].bytes;
  }
  // The problem of the first slice is reported, whatever thread is the first to find one.
  std::vector<std::string> problems(slices);
  parallelFor(slices, svol::kSlicesPerRange, [&](size_t begin, size_t end) {
    svol::SliceDecoder decoder(reader_.profile());
    for (size_t i = begin; i < end; ++i) {
      svol::SliceDecoder::Result result =
          decoder.apply(head.slices[i], std::span(payloads_).subspan(begins[i], head.slices[i].bytes),
                        volume_.slice(static_cast<int>(i)));
      changed[i] |= result.changed ? 1 : 0;
      problems[i] = std::move(result.problem);
    }
  });
  for (size_t i = 0; i < slices; ++i) {
    if (!problems[i].empty()) {
      reader_.fail(frame, i, problems[i]);
    }
  }
}

}  // namespace ocelli
