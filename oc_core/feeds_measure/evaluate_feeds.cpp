#include "oc_core/feeds_measure/evaluate_feeds.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "oc_core/base/error.h"
#include "oc_core/base/output_folder.h"
#include "oc_core/base/parallel.h"
#include "oc_core/feeds_measure/feed_truth.h"
#include "oc_core/feeds_measure/simulated_feed.h"
#include "oc_core/image/color.h"
#include "oc_core/multiperspective/multiperspective_image.h"
#include "oc_core/render/rasterize_graph.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli {
namespace {

constexpr double kMinSeen = 60;       ///< output pixels: less of a walker is not looked for
constexpr double kMinShare = 0.35;    ///< of the pixels that should show a walker
constexpr double kDoubleShare = 0.2;  ///< of these, elsewhere
constexpr double kFadeRim = 0.02;     ///< shares nearer to 0 or 1 are these
constexpr size_t kMaxPictures = 3;    ///< of each kind of error

using Areas = std::vector<std::vector<double>>;  ///< by walker and frustum, output pixels

/// The graph camera's own image: the place once, walkers for each frame.
class RenderedGraph {
 public:
  RenderedGraph(const FeedGraph& graph, const Mesh& place) : graph_(graph), camera_(graph.camera()) {
    place_ = rasterize(camera_, place);
    colors_ = colorImage(place_, place, skyColor());
  }

  Image<Rgb8> draw(const Mesh& walkers, const std::vector<uint8_t>& walkerOfTriangle, Areas& areas) const {
    Image<glm::vec3> colors = colors_;
    if (!walkers.empty()) {
      const FragmentImage seen = rasterize(camera_, walkers);
      for (size_t i = 0; i < seen.size(); ++i) {
        const Fragment& fragment = seen[i];
        if (!fragment.covered() || (place_[i].covered() && place_[i].t <= fragment.t)) {
          continue;
        }
        colors[i] = colorOf(fragment, walkers);
        const auto width = static_cast<size_t>(seen.width());
        const glm::dvec2 pixel(static_cast<double>(i % width) + 0.5, static_cast<double>(i / width) + 0.5);
        ++areas[walkerOfTriangle[fragment.triangle]][frustumAt(pixel, glm::dvec3(positionOf(fragment, walkers)))];
      }
    }
    return srgbFromLinear(colors);
  }

 private:
  /// Of the frusta that the ray of a pixel passes, the one in which a point of it lies.
  size_t frustumAt(const glm::dvec2& pixel, const glm::dvec3& point) const {
    size_t last = GraphCamera::kRoot;
    for (const size_t i : graph_.chainAt(pixel)) {
      if (i != GraphCamera::kRoot && camera_.frusta()[i].plane.height(point) < 0) {
        break;
      }
      last = i;
    }
    return last;
  }

  const FeedGraph& graph_;
  GraphCamera camera_;
  FragmentImage place_;
  Image<glm::vec3> colors_;
};

/// The walker, plus 1, that a place of a feed shows.
uint8_t walkerAt(const WalkerMask& mask, const FeedPlace& place) {
  constexpr int kHalf = 1 << (FeedPlace::kFractionBits - 1);
  return mask((place.x + kHalf) >> FeedPlace::kFractionBits, (place.y + kHalf) >> FeedPlace::kFractionBits);
}

FeedMark markOf(const Image<FeedMark>& marks, const FeedPlace& place) {
  constexpr int kHalf = 1 << (FeedPlace::kFractionBits - 1);
  const int x = ((place.x + kHalf) >> FeedPlace::kFractionBits) / FeedBlobs::kMaskScale;
  const int y = ((place.y + kHalf) >> FeedPlace::kFractionBits) / FeedBlobs::kMaskScale;
  return marks.contains(x, y) ? marks(x, y) : FeedMark{};
}

/// Which walker each pixel of the composed image shows for the most part, and by which frustum; and which the cameras
/// of its frusta see there.
void countShown(const FeedComposer& composer, const std::vector<WalkerMask>& masks, Areas& areas, Areas& seen) {
  const FeedMap& map = composer.map();
  const auto pixels = static_cast<size_t>(map.width()) * static_cast<size_t>(map.height());
  for (size_t i = 0; i < pixels; ++i) {
    uint8_t walker = 0;
    size_t frustum = 0;
    bool isLast = true;
    for (const FeedPlace& place : map.placesAt(i)) {
      const WalkerMask& mask = masks[place.frustum];
      if (place.isInFeed() && !mask.empty()) {
        const FeedMark mark = markOf(composer.marks(place.frustum), place);
        if (isLast ? mark.erased < 128 : mark.shown >= 128) {
          walker = walkerAt(mask, place);
          frustum = place.frustum;
        }
        if (const uint8_t there = walkerAt(mask, place); there > 0) {
          ++seen[there - 1u][place.frustum];
        }
      }
      isLast = false;
    }
    if (walker > 0) {
      ++areas[walker - 1u][frustum];
    }
  }
}

bool isFading(const FeedGraph& graph, const glm::dvec3& place) {
  for (size_t i = 0; i < graph.frusta(); ++i) {
    const double share = shareShown(graph, i, place);
    if (share > kFadeRim && share < 1 - kFadeRim) {
      return true;
    }
  }
  return false;
}

WalkerFate fateOf(const std::vector<double>& wanted, const std::vector<double>& shown, const std::vector<double>& seen,
                  bool fades) {
  const double allWanted = std::accumulate(wanted.begin(), wanted.end(), 0.0);
  const double allShown = std::accumulate(shown.begin(), shown.end(), 0.0);
  if (allWanted < kMinSeen) {
    // What is hardly seen may be hardly shown.
    return allShown >= 2 * kMinSeen + allWanted ? WalkerFate::kGhost : WalkerFate::kRight;
  }
  if (fades) {
    return allShown >= kMinShare * allWanted ? WalkerFate::kBetween : WalkerFate::kMissing;
  }
  const auto home = static_cast<size_t>(std::max_element(wanted.begin(), wanted.end()) - wanted.begin());
  double elsewhere = 0;
  for (size_t i = 0; i < wanted.size(); ++i) {
    if (i != home) {
      elsewhere += std::max(0.0, shown[i] - wanted[i]);
    }
  }
  const bool isElsewhere = elsewhere >= std::max(kMinSeen, kDoubleShare * wanted[home]);
  if (shown[home] >= kMinShare * wanted[home]) {
    return isElsewhere ? WalkerFate::kDoubled : WalkerFate::kRight;
  }
  if (isElsewhere) {
    return WalkerFate::kMisplaced;
  }
  return seen[home] < kMinShare * wanted[home] ? WalkerFate::kHidden : WalkerFate::kMissing;
}

double squaredError(const Image<Rgb8>& a, const Image<Rgb8>& b) {
  double sum = 0;
  for (size_t i = 0; i < a.size(); ++i) {
    for (int c = 0; c < 3; ++c) {
      const double difference = static_cast<double>(a[i][c]) - static_cast<double>(b[i][c]);
      sum += difference * difference;
    }
  }
  return sum / (3 * static_cast<double>(a.size()));
}

Image<Rgb8> besideEachOther(const Image<Rgb8>& a, const Image<Rgb8>& b) {
  Image<Rgb8> both(a.width() + b.width(), a.height());
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) {
      both(x, y) = a(x, y);
      both(a.width() + x, y) = b(x, y);
    }
  }
  return both;
}

class FeedsJudge {
 public:
  FeedsJudge(const SimulationTruth& truth, const FeedSetup& setup, const Mesh& place,
             const FeedsEvaluationOptions& options)
      : truth_(truth), graph_(setup), rendered_(graph_, place), walkers_(truth.makeWalkers()), options_(options) {
    for (size_t i = 0; i < graph_.frusta(); ++i) {
      cameras_.emplace_back(graph_.feedOf(i), place);
    }
    result_.walkers.assign(walkers_.count(), {});
  }

  void look(const ComposedFrame& frame) {
    const Areas none(walkers_.count(), std::vector<double>(graph_.frusta(), 0));
    Areas wanted = none;
    Areas shown = none;
    Areas seen = none;
    std::vector<uint8_t> walkerOfTriangle;
    const Mesh now = walkers_.meshAt(frame.seconds, walkerOfTriangle);
    const Image<Rgb8> reference = rendered_.draw(now, walkerOfTriangle, wanted);
    countShown(frame.composer, masksOf(frame), shown, seen);
    squares_ += squaredError(frame.image, reference);
    ++result_.frames;
    for (size_t w = 0; w < walkers_.count(); ++w) {
      const glm::dvec2 p = walkers_.at(w, frame.seconds).place;
      const WalkerFate fate = fateOf(wanted[w], shown[w], seen[w], isFading(graph_, {p.x, 0, p.y}));
      const size_t before = result_.count(fate);
      ++result_.walkers[w][static_cast<size_t>(fate)];
      if (!options_.pictures.empty() && before < kMaxPictures && fate != WalkerFate::kRight) {
        writePng(options_.pictures / fmt::format("{}-{}-{:.2f}s.png", nameOf(fate), w + 1, frame.seconds),
                 besideEachOther(frame.image, reference));
      }
    }
  }

  FeedsEvaluation finish(FeedsRunFigures run) {
    const double mean = squares_ / static_cast<double>(std::max<size_t>(result_.frames, 1));
    result_.psnrDecibels = 10 * std::log10(255 * 255 / std::max(mean, 1e-9));
    result_.run = std::move(run);
    return std::move(result_);
  }

 private:
  std::vector<WalkerMask> masksOf(const ComposedFrame& frame) const {
    std::vector<WalkerMask> masks(graph_.frusta());
    parallelFor(masks.size(), 1, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) {
        const size_t feed = graph_.feedIndexOf(i);
        if (std::isfinite(frame.feedSeconds[feed])) {
          const double shown = truth_.feeds[feed].shownAt(frame.feedSeconds[feed]);
          masks[i] = cameras_[i].mask(walkers_, shown, truth_.rollingSeconds);
        }
      }
    });
    return masks;
  }

  const SimulationTruth& truth_;
  FeedGraph graph_;
  RenderedGraph rendered_;
  Walkers walkers_;
  std::vector<SimulatedFeed> cameras_;  ///< of each frustum
  const FeedsEvaluationOptions& options_;
  double squares_ = 0;
  FeedsEvaluation result_;
};

}  // namespace

const char* nameOf(WalkerFate fate) {
  switch (fate) {
    case WalkerFate::kRight:
      return "right";
    case WalkerFate::kBetween:
      return "between";
    case WalkerFate::kDoubled:
      return "doubled";
    case WalkerFate::kMisplaced:
      return "misplaced";
    case WalkerFate::kMissing:
      return "missing";
    case WalkerFate::kHidden:
      return "hidden";
    case WalkerFate::kGhost:
      return "ghost";
  }
  return "";
}

size_t FeedsEvaluation::count(WalkerFate fate) const {
  size_t sum = 0;
  for (const auto& fates : walkers) {
    sum += fates[static_cast<size_t>(fate)];
  }
  return sum;
}

double FeedsEvaluation::rightShare() const {
  const auto all = static_cast<double>(frames * walkers.size());
  return all > 0 ? static_cast<double>(count(WalkerFate::kRight) + count(WalkerFate::kBetween)) / all : 1;
}

FeedsEvaluation evaluateFeeds(const std::filesystem::path& folder, const FeedsEvaluationOptions& options,
                              const Progress& progress) {
  const SimulationTruth truth = readSimulationTruth(folder / "truth.json");
  const FeedSetup setup = readFeedSetup(folder / "setup.json");
  if (truth.feeds.size() != setup.feeds.size()) {
    throw InputError("truth.json and setup.json have other feeds", folder.string(), "simulate them again");
  }
  if (!options.pictures.empty()) {
    makeFolder(options.pictures);
  }
  SceneOptions sceneOptions;
  sceneOptions.fit = false;
  sceneOptions.shading = Shading::kNone;
  const Mesh place = loadScene(truth.scene, sceneOptions, progress);
  FeedsJudge judge(truth, setup, place, options);
  FeedsRunOptions run;
  run.framesPerSecond = truth.framesPerSecond;
  run.seconds = options.seconds;
  run.hasLabels = false;
  run.backgrounds = options.backgrounds;
  FeedsRunFigures figures = runFeeds(
      setup, run, [&](const ComposedFrame& frame) { judge.look(frame); }, progress);
  return judge.finish(std::move(figures));
}

}  // namespace ocelli
