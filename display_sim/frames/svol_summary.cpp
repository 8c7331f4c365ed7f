#include "display_sim/frames/svol_summary.h"

#include "display_sim/frames/svol_player.h"

namespace ocelli {

namespace {

SvolFrameSummary summarizeFrame(const svol::FrameHead& head) {
  SvolFrameSummary frame;
  frame.timeMicroseconds = head.timeMicroseconds;
  frame.key = head.key;
  frame.bytes = svol::frameHeadBytes(head.slices.size());
  for (const svol::SliceEntry& slice : head.slices) {
    frame.bytes += slice.bytes;
    ++frame.slices[static_cast<size_t>(slice.kind)];
  }
  return frame;
}

}  // namespace

SvolSummary summarizeSvol(SvolReader& reader, const Progress& progress) {
  SvolSummary summary;
  summary.damage = reader.damage();
  const size_t count = reader.frames().size();
  try {
    SvolPlayer player(reader);
    for (size_t k = 0; k < count; ++k) {
      report(progress, "reading", static_cast<double>(k) / static_cast<double>(count));
      const SvolFrameSummary frame = summarizeFrame(reader.readHead(k));
      if (k == 0) {
        player.seek(0);
        summary.litVoxels = player.volume().litVoxels();
      }
      summary.frames.push_back(frame);
      summary.keyFrames += frame.key ? 1 : 0;
    }
  } catch (const InputError& error) {
    summary.damage = error;
  }
  summary.durationMicroseconds = reader.durationMicroseconds(summary.frames.size());
  return summary;
}

void verifySvol(SvolReader& reader, const Progress& progress) {
  const size_t count = reader.frames().size();
  SvolPlayer player(reader);
  for (size_t k = 0; k < count; ++k) {
    report(progress, "verifying", static_cast<double>(k) / static_cast<double>(count));
    player.seek(k);
  }
  if (reader.damage()) {
    throw *reader.damage();
  }
}

}  // namespace ocelli
