#include "display_sim/svol_summary.h"

#include "display_sim/svol_player.h"

namespace ocelli {

std::vector<SvolFrameSummary> summarizeFrames(SvolReader& reader, const Progress& progress) {
  const size_t count = reader.frames().size();
  std::vector<SvolFrameSummary> frames(count);
  for (size_t k = 0; k < count; ++k) {
    report(progress, "reading", static_cast<double>(k) / static_cast<double>(count));
    const svol::FrameHead head = reader.readHead(k);
    frames[k].timeMicroseconds = head.timeMicroseconds;
    frames[k].key = head.key;
    frames[k].bytes = svol::frameHeadBytes(head.slices.size());
    for (const svol::SliceEntry& slice : head.slices) {
      frames[k].bytes += slice.bytes;
      ++frames[k].slices[static_cast<size_t>(slice.kind)];
    }
  }
  return frames;
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
