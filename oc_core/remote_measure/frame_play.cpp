#include "oc_core/remote_measure/frame_play.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "oc_core/remote_measure/image_play.h"

namespace ocelli {
namespace {

constexpr double kClockRounding = 1e-9;

constexpr std::array<FramePacing, 2> kPacings{{
    {"asked", "each frame is asked for when the last one has come", false},
    {"sent on", "the next frame follows as soon as the link is free", true},
}};

}  // namespace

std::span<const FramePacing> framePacings() {
  return kPacings;
}

const std::vector<std::byte>& FrameBytes::of(size_t frame) {
  const auto found = frames_.find(frame);
  return found != frames_.end() ? found->second
                                : frames_.emplace(frame, codec_.encode(film_.frame(frame), quality_)).first->second;
}

Image<Rgb8> FrameBytes::picture(size_t frame) {
  return codec_.decode(of(frame), film_.screen());
}

Playback playFrames(const RemotePath& path, const LinkSpeed& speed, const FramePacing& pacing, FrameBytes& frames,
                    double serverSeconds) {
  VirtualLink link(speed);
  Playback playback;
  struct Arrival {
    double seconds;
    size_t frame;
  };
  std::vector<Arrival> arrivals;
  const double end = path.seconds();
  const auto frameAt = [&](double seconds) {
    return static_cast<size_t>(std::max(0.0, std::floor(seconds * path.framesPerSecond + kClockRounding)));
  };
  // The client's clock; a view reaches the server half of a round trip later.
  double asked = 0;
  while (asked < end) {
    const size_t frame = std::min(frameAt(asked), path.views.size() - 1);
    const double ready = asked + speed.oneWaySeconds() + serverSeconds;
    const double arrival = link.arrival(ready, bytesOnTheWire(frames.of(frame).size()));
    arrivals.push_back({arrival, frame});
    ++playback.images;
    if (!pacing.sendsOn) {
      asked = std::max(arrival, path.secondsOf(frame + 1));  // no frame twice
      continue;
    }
    // The server draws the next one so that it is ready when the link is free, from the newest view that it has then.
    const double next = link.freeAt() - serverSeconds - speed.oneWaySeconds();
    asked = std::max(next, path.secondsOf(frame + 1));
  }
  playback.bytes = link.sentBytes();
  size_t come = 0;
  for (size_t k = 0; k < path.views.size(); ++k) {
    while (come < arrivals.size() && arrivals[come].seconds <= path.secondsOf(k) + kClockRounding) {
      ++come;
    }
    playback.shown.push_back(come > 0 ? ShownView{arrivals[come - 1].frame} : ShownView{});
  }
  if (come > 0) {
    playback.firstPictureSeconds = arrivals.front().seconds;
  }
  return playback;
}

}  // namespace ocelli
