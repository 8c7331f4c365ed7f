#include "display_sim/observing/observe_series.h"

#include <algorithm>

#include "oc_core/base/check.h"
#include "oc_core/base/error.h"

namespace ocelli {
namespace {

ObserverOptions seenFrom(ObserverOptions options, const glm::vec3& eye) {
  options.eye = eye;
  return options;
}

Image<glm::vec3> collectFrame(const CollectLight& collect, const ObserverOptions& options, const ObserverSeries& series,
                              size_t frame) {
  const ObserverOptions here = seenFrom(options, series.eyes[frame]);
  return series.separationRadii > 0 ? sideBySide(collectPair(collect, here, series.separationRadii)) : collect(here);
}

}  // namespace

LightPair collectPair(const CollectLight& collect, const ObserverOptions& options, double separationRadii) {
  const EyePair eyes = eyePair(options.eye, separationRadii);
  return {collect(seenFrom(options, eyes.left)), collect(seenFrom(options, eyes.right))};
}

Image<glm::vec3> sideBySide(const LightPair& pair) {
  const Image<glm::vec3>& left = pair.left;
  OC_CHECK(left.height() == pair.right.height(), "images side by side are equally high");
  Image<glm::vec3> both(left.width() + pair.right.width(), left.height());
  for (int y = 0; y < both.height(); ++y) {
    for (int x = 0; x < both.width(); ++x) {
      both(x, y) = x < left.width() ? left(x, y) : pair.right(x - left.width(), y);
    }
  }
  return both;
}

void checkWay(const std::vector<EyePose>& poses, double framesPerSecond, const DisplayProfile& profile,
              const std::string& where) {
  const std::vector<glm::vec3> eyes = eyesAlong(poses, framesPerSecond);
  for (size_t frame = 0; frame < eyes.size(); ++frame) {
    if (isInDisplay(eyes[frame], profile)) {
      throw InputError("the eye is inside of the display", where + ", " + placeOnWay(poses, framesPerSecond, frame),
                       "keep it more than one display radius away from the centre");
    }
  }
}

void checkSeries(const ObserverSeries& series, const ObserverOptions& options, const DisplayProfile& profile) {
  for (const glm::vec3& eye : series.eyes) {
    checkObserverOptions(seenFrom(options, eye), profile);
  }
}

double seriesGain(const CollectLight& collect, const ObserverOptions& options, const ObserverSeries& series) {
  if (options.tone.gain > 0) {
    return options.tone.gain;
  }
  OC_CHECK(!series.eyes.empty(), "a series has frames");
  const size_t tried = std::min<size_t>(series.eyes.size(), 9);
  CommonGain common;
  for (size_t i = 0; i < tried; ++i) {
    common.add(collectFrame(collect, options, series, i * series.eyes.size() / tried));
  }
  return common.gain();
}

void observeSeries(const CollectLight& collect, const ObserverOptions& options, const ObserverSeries& series,
                   double gain, FrameSink& sink, const Progress& progress) {
  Tone tone = options.tone;
  tone.gain = gain;
  for (size_t frame = 0; frame < series.eyes.size(); ++frame) {
    report(progress, "observing", static_cast<double>(frame) / static_cast<double>(series.eyes.size()));
    Image<glm::vec3> light = collectFrame(collect, options, series, frame);
    applyTone(light, tone);
    sink.add(srgbFromLinear(light));
  }
  report(progress, "observing", 1);
}

}  // namespace ocelli
