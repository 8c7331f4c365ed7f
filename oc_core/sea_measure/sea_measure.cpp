#include "oc_core/sea_measure/sea_measure.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <numeric>

#include "oc_core/base/error.h"
#include "oc_core/base/parallel.h"
#include "oc_core/base/random.h"
#include "oc_core/evaluation/flip.h"
#include "oc_core/evaluation/image_quality.h"
#include "oc_core/image/image_error.h"
#include "oc_core/sea_measure/remembered_source.h"

namespace ocelli {
namespace {

double secondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::vector<uint32_t> evenlyChosen(uint32_t count, size_t wanted) {
  const size_t number = std::clamp<size_t>(wanted, 1, count);
  std::vector<uint32_t> chosen;
  for (size_t i = 0; i < number; ++i) {
    chosen.push_back(static_cast<uint32_t>((2 * i + 1) * count / (2 * number)));
  }
  return chosen;
}

std::vector<uint32_t> randomlyChosen(uint32_t count, size_t wanted) {
  std::vector<uint32_t> all(count);
  std::iota(all.begin(), all.end(), 0u);
  Random random(26);
  random.shuffle(all);
  all.resize(std::clamp<size_t>(wanted, 1, count));
  return all;
}

}  // namespace

SeaErrors compareImages(const SeaSource& source, std::span<const uint32_t> sample,
                        const std::function<Image<Rgb8>(size_t index)>& image, bool withSsim,
                        const Progress& progress) {
  struct Each {
    double flip = 0;
    double ssim = 0;
    double squared = 0;
  };
  std::vector<Each> each(sample.size());
  parallelFor(sample.size(), 1, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      runAlone([&] {
        const Image<Rgb8> truth = source.image(sample[i]);
        const Image<Rgb8> found = image(i);
        each[i] = {flip(truth, found), withSsim ? ssim(truth, found) : 0, meanSquaredError(truth, found)};
      });
    }
    report(progress, "comparing", static_cast<double>(end) / static_cast<double>(sample.size()));
  });
  SeaErrors errors;
  errors.images = sample.size();
  double squared = 0;
  const auto number = static_cast<double>(sample.size());
  for (const Each& one : each) {
    errors.flip += one.flip / number;
    errors.mostFlip = std::max(errors.mostFlip, one.flip);
    errors.ssim += one.ssim / number;
    errors.leastSsim = std::min(errors.leastSsim, one.ssim);
    squared += one.squared / number;
  }
  errors.psnrDecibels = psnrDecibels(squared);
  return errors;
}

SeaMeasureResult measureSea(const SeaFile& sea, const SeaSource& images, const SeaMeasureOptions& options,
                            const Progress& progress) {
  const RememberedSource source(images);
  if (source.poses().size() != sea.count() || !(source.projection() == sea.settings().projection)) {
    throw InputError(fmt::format("this sea has {} images of {}x{}; its source has {} of {}x{}", sea.count(),
                                 sea.settings().projection.width, sea.settings().projection.height,
                                 source.poses().size(), source.projection().width, source.projection().height),
                     source.description(), "give the images or the scene that it was made of");
  }
  for (const std::string& peer : options.peers) {
    requireSeaPeer(peer);
  }
  const std::vector<uint32_t> sample = evenlyChosen(sea.count(), options.images);
  SeaMeasureResult result;
  result.errors = compareImages(
      source, sample, [&](size_t i) { return sea.image(sample[i]); }, true, progress);
  result.bytesPerImage = static_cast<double>(sea.fileBytes()) / sea.count();
  const SeaProjection& projection = sea.settings().projection;
  result.ratio = 3.0 * projection.width * projection.height / result.bytesPerImage;
  const std::vector<uint32_t> timed = randomlyChosen(sea.count(), options.timed);
  sea.release();
  auto start = std::chrono::steady_clock::now();
  parallelFor(timed.size(), 1, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      sea.image(timed[i]);
    }
  });
  result.imagesPerSecond = static_cast<double>(timed.size()) / secondsSince(start);
  sea.release();
  start = std::chrono::steady_clock::now();
  for (const uint32_t image : timed) {
    sea.image(image);
  }
  result.secondsPerImage = secondsSince(start) / static_cast<double>(timed.size());
  for (const std::string& name : options.peers) {
    const SeaPeer& peer = requireSeaPeer(name);
    SeaPeerResult found =
        peer.measure({source, sample, std::min<size_t>(options.run, sea.count()), result.errors.flip, progress});
    found.name = name;
    result.peers.push_back(std::move(found));
  }
  return result;
}

}  // namespace ocelli
