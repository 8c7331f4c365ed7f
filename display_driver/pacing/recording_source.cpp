#include "display_driver/pacing/recording_source.h"

#include <algorithm>

#include "oc_core/base/error.h"

namespace ocelli {

RecordingSource::RecordingSource(const std::filesystem::path& path, bool loop)
    : reader_(path), player_(reader_), loop_(loop) {
  if (reader_.frames().empty()) {
    throw InputError("this recording has no frame", path.string(), "ocelli volume info");
  }
}

SourcedVolume RecordingSource::volumeFor(HostTime seen) {
  if (!start_) {
    start_ = seen;
  }
  const auto since = std::chrono::duration_cast<std::chrono::microseconds>(seen - *start_).count();
  auto time = static_cast<uint64_t>(std::max<int64_t>(0, since));
  const uint64_t duration = std::max<uint64_t>(1, reader_.durationMicroseconds());
  const bool still = frames() == 1;
  if (time >= duration && (loop_ || still)) {
    time %= duration;
  } else if (time >= duration) {
    return {};
  }
  const size_t frame = reader_.frameAt(reader_.frames().front().timeMicroseconds + time);
  if (frame == frame_) {
    return {.kind = SourcedVolume::Kind::kSame};
  }
  const bool first = !frame_;
  player_.seek(frame);
  frame_ = frame;
  SourcedVolume sourced{.kind = SourcedVolume::Kind::kNew, .volume = copies_.copyOf(player_.volume())};
  if (!first) {
    sourced.changed = player_.changed();
  }
  return sourced;
}

}  // namespace ocelli
