#include "display_driver/devices/shown_images.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "display_sim/frames/svol_player.h"
#include "display_sim/frames/svol_reader.h"
#include "display_sim/observing/tone.h"
#include "oc_core/base/conventions.h"
#include "oc_core/image/png_file.h"

namespace ocelli {
namespace {

/// Frames that the common gain is found from.
constexpr size_t kGainFrames = 9;

std::vector<size_t> pickRefreshes(const std::vector<RecordedRefresh>& refreshes, double framesPerSecond) {
  std::vector<size_t> picked;
  double next = -1e300;
  const auto first = std::ranges::find_if(refreshes, [](const RecordedRefresh& refresh) {
    return std::ranges::any_of(refresh.shown.parts, [](const auto& part) { return part.frame != 0; });
  });
  for (auto i = static_cast<size_t>(first - refreshes.begin()); i < refreshes.size(); ++i) {
    const auto begin = static_cast<double>(refreshes[i].shown.begin);
    // A little early is in time: refreshes jitter around the frames of a video of the same rate.
    if (begin >= next - 0.25e6 / framesPerSecond) {
      picked.push_back(i);
      next = std::max(next, begin) + 1e6 / framesPerSecond;
    }
  }
  return picked;
}

}  // namespace

glm::vec3 eyeForPhaseError(const glm::vec3& eye, double phaseErrorDegrees) {
  // The screen turns from x towards z with the phase; the eye goes the other way.
  const double angle = -phaseErrorDegrees * kPi / 180;
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  const double x = static_cast<double>(eye.x);
  const double z = static_cast<double>(eye.z);
  return {static_cast<float>(c * x - s * z), eye.y, static_cast<float>(s * x + c * z)};
}

size_t drawShown(const std::filesystem::path& svol, const std::vector<RecordedRefresh>& refreshes,
                 const ObserverOptions& options, double framesPerSecond, FrameSink& sink, const Progress& progress) {
  SvolReader reader(svol);
  SvolPlayer player(reader);
  const std::vector<size_t> picked = pickRefreshes(refreshes, framesPerSecond);
  const auto lightOf = [&](const RecordedRefresh& refresh) {
    player.seek(*refresh.volume);
    ObserverOptions turned = options;
    turned.eye = eyeForPhaseError(options.eye, refresh.shown.phaseErrorDegrees);
    return collectLight(player.volume(), turned);
  };
  Tone tone = options.tone;
  if (tone.gain == 0) {
    CommonGain common;
    for (size_t k = 0; k < kGainFrames && !picked.empty(); ++k) {
      const RecordedRefresh& refresh = refreshes[picked[k * (picked.size() - 1) / (kGainFrames - 1)]];
      if (refresh.volume) {
        common.add(lightOf(refresh));
      }
    }
    tone.gain = common.gain();
  }
  Image<Rgb8> image(options.width, options.height);
  for (size_t k = 0; k < picked.size(); ++k) {
    const RecordedRefresh& refresh = refreshes[picked[k]];
    if (refresh.volume) {
      Image<glm::vec3> light = lightOf(refresh);
      applyTone(light, tone);
      image = srgbFromLinear(light);
    }
    sink.add(image);
    report(progress, "observing", static_cast<double>(k + 1) / static_cast<double>(picked.size()));
  }
  return picked.size();
}

}  // namespace ocelli
