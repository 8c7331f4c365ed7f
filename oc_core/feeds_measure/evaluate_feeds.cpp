#include "oc_core/feeds_measure/evaluate_feeds.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

#include "oc_core/base/error.h"
#include "oc_core/base/output_folder.h"
#include "oc_core/base/parallel.h"
#include "oc_core/feeds_measure/feed_truth.h"
#include "oc_core/feeds_measure/rendered_graph.h"
#include "oc_core/feeds_measure/simulated_feed.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli {
namespace {

constexpr double kFadeRim = 0.02;  ///< shares nearer to 0 or 1 are these

/// The feed pixel of a place.
glm::ivec2 pixelOf(const FeedPlace& place) {
  constexpr int kHalf = 1 << (FeedPlace::kFractionBits - 1);
  return {(place.x + kHalf) >> FeedPlace::kFractionBits, (place.y + kHalf) >> FeedPlace::kFractionBits};
}

/// The walker, plus 1, that a place of a feed shows.
uint8_t walkerAt(const WalkerMask& mask, const FeedPlace& place) {
  const glm::ivec2 pixel = pixelOf(place);
  return mask(pixel.x, pixel.y);
}

/// Where the pixels of one composed image show walkers.
struct ShownWalkers {
  WalkerAreas composed;  ///< as the image is
  WalkerAreas possible;  ///< as it would be if all that the cameras see were erased and shown by the true places
  WalkerAreas seen;      ///< by the cameras of the frusta, erased or not
};

/// How much each frustum shows of each walker where it truly stands.
using TrueShares = std::vector<std::vector<double>>;

/// A walker that a pixel shows for the most part, and by which frustum; the nearer frusta come later.
struct PixelWalker {
  uint8_t walker = 0;  ///< its number plus 1; 0: none
  size_t frustum = 0;

  void take(bool isShown, uint8_t there, size_t by) {
    if (isShown) {
      walker = there;
      frustum = by;
    }
  }
  void addTo(WalkerAreas& areas, int x, int y) const {
    if (walker > 0) {
      areas[walker - 1u].add(frustum, x, y);
    }
  }
};

/// Which walker, plus 1, a feed showed at an earlier time.
using WalkerThen = std::function<uint8_t(const PortraitPixel& pixel)>;

void countShown(const FeedComposer& composer, const std::vector<WalkerMask>& masks, const TrueShares& shares,
                const TrueShares& entered, const WalkerThen& walkerThen, ShownWalkers& result) {
  const FeedMap& map = composer.map();
  const auto width = static_cast<size_t>(map.width());
  for (size_t i = 0; i < width * static_cast<size_t>(map.height()); ++i) {
    const auto x = static_cast<int>(i % width);
    const auto y = static_cast<int>(i / width);
    PixelWalker composed;
    PixelWalker possible;
    bool isLast = true;
    for (const FeedPlace& place : map.placesAt(i)) {
      const WalkerMask& mask = masks[place.frustum];
      if (place.isInFeed() && !mask.empty()) {
        const FeedMark mark = composer.marks(place.frustum).at(place);
        const uint8_t there = walkerAt(mask, place);
        composed.take(isLast ? mark.erased < 128 : mark.shown >= 128, there, place.frustum);
        if (isLast && mark.erased >= 128) {
          if (const auto then = composer.hidden(place.frustum).at(pixelOf(place))) {
            composed.take(true, walkerThen(*then), place.frustum);
          }
        }
        if (there > 0) {
          possible.take((isLast ? entered : shares)[there - 1u][place.frustum] >= 0.5, there, place.frustum);
          result.seen[there - 1u].add(place.frustum, x, y);
        }
      }
      isLast = false;
    }
    composed.addTo(result.composed, x, y);
    possible.addTo(result.possible, x, y);
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

class FeedsJudge {
 public:
  /// `taken` has the cameras as they truly are, `setup` what is run.
  FeedsJudge(const SimulationTruth& truth, const FeedSetup& taken, const FeedSetup& setup, const Mesh& place,
             const FeedsEvaluationOptions& options)
      : truth_(truth),
        graph_(setup),
        rendered_(graph_, place),
        walkers_(truth.makeWalkers()),
        seams_(FeedMap(graph_)),
        hasPictures_(!options.pictures.empty()),
        pictures_(options.pictures),
        stitchEvery_(hasStitcher() ? options.stitchEvery : 0) {
    for (const Feed& feed : taken.feeds) {
      cameras_.emplace_back(feed, place);
    }
    result_.walkers.assign(walkers_.count(), {});
  }

  void look(const ComposedFrame& frame) {
    WalkerAreas wanted = emptyAreas(walkers_.count(), graph_.frusta());
    ShownWalkers shown{wanted, wanted, wanted};
    const Image<Rgb8> reference = rendered_.draw(walkers_, frame.seconds, wanted);
    const std::vector<WalkerMask> masks = masksOf(frame);
    feedSeconds_[frame.seconds] = frame.feedSeconds;
    std::map<std::pair<size_t, double>, WalkerMask> earlier;
    const auto walkerThen = [&](const PortraitPixel& pixel) {
      WalkerMask& mask = earlier[{pixel.feed, pixel.seconds}];
      if (mask.empty()) {
        mask = maskOf(pixel.feed, feedSeconds_.at(pixel.seconds));
      }
      return mask(pixel.pixel.x, pixel.pixel.y);
    };
    countShown(frame.composer, masks, trueShares(frame.seconds, shareShown), trueShares(frame.seconds, shareEntered),
               walkerThen, shown);
    squares_ += squaredError(frame.image, reference);
    if (stitchEvery_ > 0 && result_.frames % stitchEvery_ == 0) {
      stitch(frame, masks);
    }
    ++result_.frames;
    FrameJudgement judgement{frame.seconds, {}, seams_.measure(frame.image, reference)};
    for (size_t w = 0; w < walkers_.count(); ++w) {
      const glm::dvec2 p = walkers_.at(w, frame.seconds).place;
      const bool fades = isFading(graph_, {p.x, 0, p.y});
      const WalkerFate fate = fateOf(wanted[w], shown.composed[w], shown.seen[w], fades);
      const WalkerFate possible = fateOf(wanted[w], shown.possible[w], shown.seen[w], fades);
      result_.possible += possible == WalkerFate::kRight || possible == WalkerFate::kBetween ? 1 : 0;
      ++result_.walkers[w][static_cast<size_t>(fate)];
      judgement.fates.push_back(fate);
      if (hasPictures_ && pictures_.wants(fate, frame.seconds)) {
        pictures_.add(fate, w, frame.seconds, markedPair(frame.image, shown.composed[w], reference, wanted[w]));
      }
    }
    result_.timeline.push_back(std::move(judgement));
  }

  FeedsEvaluation finish(FeedsRunFigures run) {
    const double mean = squares_ / static_cast<double>(std::max<size_t>(result_.frames, 1));
    result_.psnrDecibels = 10 * std::log10(255 * 255 / std::max(mean, 1e-9));
    std::vector<FeedSeams> seams;
    for (const FrameJudgement& frame : result_.timeline) {
      seams.push_back(frame.seams);
    }
    result_.seams = meanSeams(seams);
    result_.pictures = pictures_.list();
    result_.run = std::move(run);
    return std::move(result_);
  }

 private:
  TrueShares trueShares(double seconds, double (*shareOf)(const FeedGraph&, size_t, const glm::dvec3&)) const {
    TrueShares shares(walkers_.count());
    for (size_t w = 0; w < walkers_.count(); ++w) {
      const glm::dvec2 p = walkers_.at(w, seconds).place;
      for (size_t i = 0; i < graph_.frusta(); ++i) {
        shares[w].push_back(shareOf(graph_, i, {p.x, 0, p.y}));
      }
    }
    return shares;
  }

  /// Nothing where the feed has no frame yet.
  WalkerMask maskOf(size_t feed, const std::vector<double>& feedSeconds) const {
    if (!std::isfinite(feedSeconds[feed])) {
      return {};
    }
    return cameras_[feed].mask(walkers_, truth_.feeds[feed].shownAt(feedSeconds[feed]), truth_.rollingSeconds);
  }

  std::vector<WalkerMask> masksOf(const ComposedFrame& frame) const {
    std::vector<WalkerMask> masks(graph_.frusta());
    parallelFor(masks.size(), 1, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) {
        masks[i] = maskOf(graph_.feedIndexOf(i), frame.feedSeconds);
      }
    });
    return masks;
  }

  void stitch(const ComposedFrame& frame, const std::vector<WalkerMask>& masks) {
    std::vector<Image<Rgb8>> frames;
    for (size_t i = 0; i < graph_.frusta(); ++i) {
      if (masks[i].empty()) {
        return;  // a feed has not come yet
      }
      frames.push_back(frame.composer.frame(graph_.feedIndexOf(i)));
    }
    addStitchedFrame(frames, masks, walkers_.count(), result_.stitcher);
  }

  const SimulationTruth& truth_;
  FeedGraph graph_;
  RenderedGraph rendered_;
  Walkers walkers_;
  std::vector<SimulatedFeed> cameras_;  ///< of each feed
  SeamMeter seams_;
  bool hasPictures_;
  ErrorPictures pictures_;
  size_t stitchEvery_;
  double squares_ = 0;
  std::map<double, std::vector<double>> feedSeconds_;  ///< of all frames, by their times
  FeedsEvaluation result_;
};

}  // namespace

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

double FeedsEvaluation::possibleShare() const {
  const auto all = static_cast<double>(frames * walkers.size());
  return all > 0 ? static_cast<double>(possible) / all : 1;
}

FeedsEvaluation evaluateFeeds(const std::filesystem::path& folder, const FeedsEvaluationOptions& options,
                              const Progress& progress) {
  std::error_code noFile;
  if (!std::filesystem::exists(folder / "truth.json", noFile)) {
    throw InputError("there is no truth.json in it", folder.string(),
                     "give the folder that `ocelli feeds simulate` has written to the end");
  }
  const SimulationTruth truth = readSimulationTruth(folder / "truth.json");
  const FeedSetup taken = readFeedSetup(folder / "setup.json");
  const FeedSetup setup = options.setup.empty() ? taken : readFeedSetup(options.setup);
  const auto check = [&](const FeedSetup& given, const std::filesystem::path& path, const std::string& advice) {
    if (!std::ranges::equal(truth.feeds, given.feeds, {}, &FeedTruth::name, &Feed::name)) {
      throw InputError("truth.json and the setup have other feeds, or another order of them", path.string(), advice);
    }
  };
  check(taken, folder, "simulate them again");
  check(setup, options.setup, "give a setup that was made from " + (folder / "setup.json").string());
  if (!options.pictures.empty()) {
    makeFolder(options.pictures);
  }
  SceneOptions sceneOptions;
  sceneOptions.fit = false;
  sceneOptions.shading = Shading::kNone;
  const Mesh place = loadScene(truth.scene, sceneOptions, progress);
  FeedsJudge judge(truth, taken, setup, place, options);
  FeedsRunOptions run;
  run.framesPerSecond = truth.framesPerSecond;
  run.seconds = options.seconds;
  run.hasLabels = false;
  run.backgrounds = options.backgrounds;
  run.showsHidden = options.showsHidden;
  FeedsRunFigures figures = runFeeds(
      setup, run, [&](const ComposedFrame& frame) { judge.look(frame); }, progress);
  return judge.finish(std::move(figures));
}

}  // namespace ocelli
