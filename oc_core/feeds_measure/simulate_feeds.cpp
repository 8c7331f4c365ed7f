#include "oc_core/feeds_measure/simulate_feeds.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>

#include "oc_core/base/error.h"
#include "oc_core/base/output_file.h"
#include "oc_core/base/output_folder.h"
#include "oc_core/base/parallel.h"
#include "oc_core/base/random_numbers.h"
#include "oc_core/feeds_measure/feed_rigs.h"
#include "oc_core/feeds_measure/feed_truth.h"
#include "oc_core/feeds_measure/simulated_feed.h"
#include "oc_core/feeds_video/video_writer.h"
#include "oc_core/image/color.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli {
namespace {

constexpr size_t kLightSteps = 8192;
constexpr size_t kNoiseSamples = 1 << 16;
constexpr float kMaxLight = 1.5f;
constexpr double kFeedRateFactor = 17;  ///< of x264: hardly any loss
constexpr int kMaskStep = 40;
constexpr int kMinSide = 32;  ///< pixels

/// Encoded values of linear light up to kMaxLight, before rounding.
std::vector<float> encodedLight() {
  std::vector<float> table;
  for (size_t i = 0; i < kLightSteps; ++i) {
    table.push_back(255 * srgbFromLinear(kMaxLight * static_cast<float>(i) / (kLightSteps - 1)));
  }
  return table;
}

/// The sensor of one camera: from light to bytes.
class FeedSensor {
 public:
  FeedSensor(double noiseLevels, uint64_t seed, uint64_t feed) : random_(seed, 1000 + feed), light_(encodedLight()) {
    RandomNumbers numbers(seed, 2000 + feed);
    for (size_t i = 0; i < kNoiseSamples; ++i) {
      noise_.push_back(static_cast<float>(noiseLevels * numbers.normal()));
    }
  }

  Image<Rgb8> expose(const Image<glm::vec3>& colors, double exposure) {
    Image<Rgb8> image(colors.width(), colors.height());
    const float scale = static_cast<float>(exposure) * (kLightSteps - 1) / kMaxLight;
    for (int y = 0; y < image.height(); ++y) {
      size_t at = random_.bits() % kNoiseSamples;
      for (int x = 0; x < image.width(); ++x) {
        const glm::vec3& color = colors(x, y);
        for (int c = 0; c < 3; ++c) {
          const float step = std::clamp(color[c] * scale, 0.0f, static_cast<float>(kLightSteps - 1));
          const float level = light_[static_cast<size_t>(step)] + noise_[at++ % kNoiseSamples];
          image(x, y)[c] = static_cast<uint8_t>(std::clamp(level + 0.5f, 0.0f, 255.0f));
        }
      }
    }
    return image;
  }

 private:
  RandomNumbers random_;
  std::vector<float> light_;
  std::vector<float> noise_;
};

double between(RandomNumbers& random, double least, double most) {
  return least + (most - least) * random.uniform();
}

void bendLens(FeedLens& lens, double share, RandomNumbers& random) {
  lens.k1 = share * between(random, -0.18, -0.05);
  lens.k2 = share * between(random, 0, 0.04);
  lens.p1 = share * between(random, -5e-4, 5e-4);
  lens.p2 = share * between(random, -5e-4, 5e-4);
  lens.center += share * glm::dvec2(between(random, -4, 4), between(random, -4, 4));
}

/// What is random of each feed; sets its lens and its clock.
SimulationTruth truthOf(const FeedSimulationOptions& options, FeedSetup& setup) {
  SimulationTruth truth{options.scene,
                        options.seed,
                        options.walkers,
                        options.seconds,
                        options.framesPerSecond,
                        options.exposureSwing,
                        options.noiseLevels,
                        options.rollingSeconds,
                        {}};
  const auto frames = static_cast<size_t>(std::llround(options.seconds * options.framesPerSecond));
  for (size_t i = 0; i < setup.feeds.size(); ++i) {
    RandomNumbers random(options.seed, i);
    Feed& feed = setup.feeds[i];
    bendLens(feed.lens, options.distortion, random);
    FeedTruth of;
    of.name = feed.name;
    of.clockOffsetSeconds = between(random, 0, options.maxClockOffset);
    of.phase = random.uniform();
    of.exposurePeriod = between(random, 6, 14);
    of.exposurePhase = between(random, 0, 6.28);
    if (feed.name == options.frozenFeed) {
      of.frozenFromSeconds = options.frozenSeconds;
    }
    for (size_t k = 1; k < frames; ++k) {
      if (random.uniform() < options.droppedShare) {
        of.dropped.push_back(k);
      }
    }
    feed.clockOffsetSeconds = of.clockOffsetSeconds;
    truth.feeds.push_back(of);
  }
  return truth;
}

void writeMask(const std::filesystem::path& path, const WalkerMask& mask) {
  Image<Rgb8> image(mask.width(), mask.height());
  for (size_t i = 0; i < mask.size(); ++i) {
    image[i] = Rgb8(static_cast<uint8_t>(std::min(255, kMaskStep * mask[i])));
  }
  writePng(path, image);
}

struct FeedJob {
  const FeedSimulationOptions& options;
  const SimulationTruth& truth;
  const Walkers& walkers;
  const Mesh& place;
  const std::filesystem::path& folder;
};

void writeFeed(const FeedJob& job, const Feed& feed, size_t index, const std::function<void()>& countFrame) {
  const FeedTruth& truth = job.truth.feeds[index];
  const double rate = job.options.framesPerSecond;
  const SimulatedFeed camera(feed, job.place);
  FeedSensor sensor(job.options.noiseLevels, job.options.seed, index);
  FeedSensor quiet(0, 0, 0);
  writePng(job.folder / feed.background,
           quiet.expose(camera.background(), truth.exposureAt(0, job.options.exposureSwing)));
  VideoWriter video(job.folder / feed.source, feed.width, feed.height, {rate, kFeedRateFactor, false});
  const auto frames = static_cast<size_t>(std::llround(job.options.seconds * rate));
  Image<Rgb8> frozen;
  for (size_t k = 0; k < frames; ++k) {
    countFrame();
    if (std::binary_search(truth.dropped.begin(), truth.dropped.end(), k)) {
      continue;
    }
    const double taken = truth.takenAt(k, rate);
    const bool isFrozen = truth.shownAt(taken) < taken;
    if (!isFrozen || frozen.empty()) {
      const double shown = truth.shownAt(taken);
      const SimulatedFrame frame = camera.frame(job.walkers, shown, job.options.rollingSeconds);
      frozen = sensor.expose(frame.colors, truth.exposureAt(shown, job.options.exposureSwing));
      if (job.options.maskEvery > 0 && k % job.options.maskEvery == 0) {
        writeMask(job.folder / "masks" / fmt::format("{}-{:06}.png", feed.name, k), frame.walkers);
      }
    }
    video.add(frozen, taken + truth.clockOffsetSeconds);
    if (!isFrozen) {
      frozen = {};
    }
  }
  video.finish();
}

int checkedSide(int pixels) {
  if (pixels < kMinSide || pixels > kMaxFeedPixels || pixels % 2 != 0) {
    throw InputError(fmt::format("feeds of {} pixels a side cannot be simulated", pixels), "--size",
                     fmt::format("choose even numbers from {} to {}, as 1280x720", kMinSide, kMaxFeedPixels));
  }
  return pixels;
}

void writeTextTo(const std::filesystem::path& path, const std::string& text) {
  OutputFile file(path);
  file.write(text);
  file.commit();
}

}  // namespace

FeedSimulationFigures simulateFeeds(const FeedSimulationOptions& options, const std::filesystem::path& folder,
                                    const Progress& progress) {
  const FeedRig& rig = feedRigOf(options.scene);
  FeedSetup setup = rig.setup();
  if (options.width > 0 && options.height > 0) {
    setup = resizedSetup(setup, checkedSide(options.width), checkedSide(options.height));
  }
  if (!options.frozenFeed.empty() && setup.feedIndex(options.frozenFeed) < 0) {
    throw InputError("the rig has no feed \"" + options.frozenFeed + "\"", "--freeze", "name one of its feeds");
  }
  const SimulationTruth truth = truthOf(options, setup);
  makeFolder(folder);
  if (options.maskEvery > 0) {
    makeFolder(folder / "masks");
  }
  SceneOptions sceneOptions;
  sceneOptions.fit = false;
  sceneOptions.shading = Shading::kNone;
  const Mesh place = loadScene(options.scene, sceneOptions, progress);
  const Walkers walkers = truth.makeWalkers();
  const auto frames = static_cast<size_t>(std::llround(options.seconds * options.framesPerSecond));
  const size_t all = frames * setup.feeds.size();
  std::atomic<size_t> done{0};
  const FeedJob job{options, truth, walkers, place, folder};
  parallelFor(setup.feeds.size(), 1, [&](size_t begin, size_t end) {
    runAlone([&] {
      for (size_t i = begin; i < end; ++i) {
        writeFeed(job, setup.feeds[i], i, [&] {
          report(progress, "simulating feeds", static_cast<double>(++done) / static_cast<double>(all));
        });
      }
    });
  });
  writeTextTo(folder / "setup.json", jsonText(setup));
  writeTextTo(folder / "truth.json", jsonText(truth, setup));
  FeedSimulationFigures figures{all, 0};
  for (const FeedTruth& feed : truth.feeds) {
    figures.dropped += feed.dropped.size();
  }
  return figures;
}

}  // namespace ocelli
