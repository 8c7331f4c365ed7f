#include "oc_core/remote_measure/stream_play.h"

#include <algorithm>
#include <cmath>

#include "oc_core/base/check.h"
#include "oc_core/remote_measure/image_play.h"

namespace ocelli {
namespace {

constexpr double kArrivalRounding = 1e-9;

constexpr double kRateMargin = 0.05;
constexpr double kMinStreamShare = 0.1;

}  // namespace

Playback playStream(const RemotePath& path, const LinkSpeed& speed, std::span<const size_t> frameBytes,
                    double serverSeconds) {
  OC_CHECK(frameBytes.size() == path.views.size(), "a stream has each frame of its path");
  VirtualLink link(speed);
  Playback playback;
  std::vector<double> arrivals;
  for (size_t j = 0; j < frameBytes.size(); ++j) {
    const double ready = path.secondsOf(j) + speed.oneWaySeconds() + serverSeconds;
    arrivals.push_back(link.arrival(ready, bytesOnTheWire(frameBytes[j])));
  }
  size_t come = 0;
  for (size_t k = 0; k < frameBytes.size(); ++k) {
    while (come < arrivals.size() && arrivals[come] <= path.secondsOf(k) + kArrivalRounding) {
      ++come;
    }
    playback.shown.push_back(come > 0 ? ShownView{come - 1} : ShownView{});
  }
  playback.bytes = link.sentBytes();
  playback.images = frameBytes.size();
  if (come > 0) {
    playback.firstPictureSeconds = arrivals.front();
  }
  return playback;
}

double streamBytesPerSecond(const LinkSpeed& speed, double framesPerSecond) {
  // Those of a frame that takes all of the link.
  const auto frame = static_cast<size_t>(std::ceil(speed.bytesPerSecond / framesPerSecond));
  const auto headers = static_cast<double>(bytesOnTheWire(frame) - frame);
  return std::max((speed.bytesPerSecond - headers * framesPerSecond) * (1 - kRateMargin),
                  kMinStreamShare * speed.bytesPerSecond);
}

}  // namespace ocelli
