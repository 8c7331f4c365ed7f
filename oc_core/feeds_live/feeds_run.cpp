#include "oc_core/feeds_live/feeds_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <thread>

#include "oc_core/base/error.h"
#include "oc_core/base/steady_time.h"

namespace ocelli {
namespace {

double secondsSince(int64_t nanoseconds) {
  return 1e-9 * static_cast<double>(steadyNanoseconds() - nanoseconds);
}

/// Times of frames that fall together to within the rounding of containers, which have milliseconds.
constexpr double kStampRounding = 1e-3;
constexpr std::chrono::milliseconds kLivePoll{20};

double nowSeconds() {
  return secondsSince(0);
}

class FeedsRun {
 public:
  FeedsRun(const FeedSetup& setup, const FeedsRunOptions& options)
      : options_(options),
        graph_(setup),
        composer_(graph_, options.backgrounds),
        feedSeconds_(setup.feeds.size(), std::numeric_limits<double>::quiet_NaN()),
        remarks_(setup.feeds.size()),
        remarkedConnections_(setup.feeds.size(), 0),
        ages_(setup.feeds.size(), 0),
        shown_(setup.feeds.size(), 0) {
    options_.streams.isLiveRun = figures_.isLive = mayBeLive(setup);
    composer_.setShowsHidden(options_.showsHidden);
    for (const Feed& feed : setup.feeds) {
      streams_.push_back(std::make_unique<FeedStream>(feed, options_.streams));
      figures_.feeds.push_back({});
      figures_.feeds.back().name = feed.name;
    }
  }

  FeedsRunFigures run(const std::function<void(const ComposedFrame&)>& sink, const Progress& progress) {
    const double start = options_.streams.isLiveRun ? liveStartSeconds() : startSeconds();
    const int64_t began = steadyNanoseconds();
    for (size_t k = 0; options_.seconds <= 0 || static_cast<double>(k) < options_.seconds * options_.framesPerSecond;
         ++k) {
      k = options_.streams.isLiveRun ? waitForOutput(start, k) : k;
      if (options_.isStopped && options_.isStopped()) {
        break;
      }
      const double seconds = start + static_cast<double>(k) / options_.framesPerSecond;
      if (!takeFrames(seconds) || isBeforeGap(seconds)) {
        break;
      }
      noteAges(seconds);
      const int64_t frameBegan = steadyNanoseconds();
      for (size_t i = 0; i < streams_.size(); ++i) {
        composer_.setStale(i, isStale(i, seconds));
      }
      composer_.take(frames_);
      composer_.compose(seconds, options_.erasedNow ? options_.erasedNow() : options_.erased, image_);
      const std::vector<FeedLabel> shown = labels(seconds);
      for (size_t i = 0; i < shown.size(); ++i) {
        FeedRunFigures& figures = figures_.feeds[graph_.feedIndexOf(i)];
        figures.wasCovered = figures.wasCovered || shown[i].state == FeedState::kCovered;
      }
      if (options_.hasLabels) {
        drawFeedLabels(graph_, shown, image_);
      }
      const double took = secondsSince(frameBegan);
      composing_ += took;
      figures_.slowestFrameSeconds = std::max(figures_.slowestFrameSeconds, took);
      ++figures_.frames;
      sink({seconds, image_, composer_, feedSeconds_, shown});
      report(progress,
             fmt::format("feeds at {:.1f} s, {:.1f} frames a second", seconds - start,
                         static_cast<double>(figures_.frames) / secondsSince(began)),
             shareDone(start, seconds));
    }
    figures_.wallSeconds = secondsSince(began);
    finishFigures();
    return std::move(figures_);
  }

 private:
  /// Of the run, at that time; nothing (NaN) where no end is known.
  double shareDone(double start, double seconds) const {
    double end = start + options_.seconds;
    if (options_.seconds <= 0) {
      for (const auto& stream : streams_) {
        end = std::max(end, stream->endSeconds().value_or(start));
      }
    }
    return end > start ? (seconds - start) / (end - start) : std::numeric_limits<double>::quiet_NaN();
  }

  /// When all feeds have a frame that begin at about the same time.
  double startSeconds() {
    std::vector<double> firsts;
    for (const auto& stream : streams_) {
      if (const auto first = stream->firstSeconds()) {
        firsts.push_back(*first);
      }
    }
    double start = -std::numeric_limits<double>::infinity();
    for (const double first : firsts) {
      if (first <= *std::min_element(firsts.begin(), firsts.end()) + options_.streams.maxWaitSeconds) {
        start = std::max(start, first);
      }
    }
    if (!std::isfinite(start)) {
      failWithoutFrames();
    }
    return start + kStampRounding;
  }

  /// When the first feed has a frame, or the run is stopped.
  double liveStartSeconds() {
    const double began = nowSeconds();
    for (;;) {
      bool isAnyTrying = false;
      for (const auto& stream : streams_) {
        if (stream->framesRead() > 0 || (options_.isStopped && options_.isStopped())) {
          return nowSeconds();
        }
        isAnyTrying = isAnyTrying || stream->state() != FeedState::kLost;
      }
      const double waited = nowSeconds() - began;
      if ((!isAnyTrying && waited > options_.streams.maxWaitSeconds) || waited > options_.streams.maxSilenceSeconds) {
        failWithoutFrames();
      }
      std::this_thread::sleep_for(kLivePoll);
    }
  }

  [[noreturn]] void failWithoutFrames() const {
    const std::string where = "feed \"" + graph_.feedOf(0).name + "\"";
    const std::string message = streams_[graph_.feedIndexOf(0)]->message();
    const std::string advice = "\n  try: ";
    const size_t at = message.find(advice);
    if (at == std::string::npos && options_.streams.isLiveRun) {
      throw InputError(fmt::format("no feed has sent a frame in {:g} s", options_.streams.maxSilenceSeconds), where,
                       "start what sends it first, or soon after this");
    }
    if (at == std::string::npos) {
      throw InputError("no feed gives a frame", where, "check the sources of the setup with `ffprobe`");
    }
    throw InputError("no feed gives a frame: " + message.substr(0, at), where, message.substr(at + advice.size()));
  }

  /// Waits until it is time for output k; returns it, or a later one where its time is over.
  size_t waitForOutput(double start, size_t k) const {
    const double now = nowSeconds();
    const double due = start + static_cast<double>(k) / options_.framesPerSecond;
    if (now < due) {
      std::this_thread::sleep_for(std::chrono::duration<double>(due - now));
      return k;
    }
    return std::max(k, static_cast<size_t>((now - start) * options_.framesPerSecond));
  }

  /// False where all feeds have ended and nothing is new.
  bool takeFrames(double seconds) {
    bool isAnyGoingOn = false;
    frames_.assign(streams_.size(), {});
    for (size_t i = 0; i < streams_.size(); ++i) {
      FeedRunFigures& figures = figures_.feeds[i];
      if (auto frame = streams_[i]->take(seconds)) {
        if (const size_t connections = streams_[i]->reconnections() + 1;
            options_.remarkOn && remarkedConnections_[i] < connections) {
          remarkedConnections_[i] = connections;
          remarks_[i] = options_.remarkOn(i, frame->image);
        }
        feedSeconds_[i] = frame->seconds;
        frames_[i] = std::move(frame->image);
        isAnyGoingOn = true;
      } else {
        ++figures.outputsWithout;
      }
      const FeedState state = streams_[i]->state();
      figures.wasFrozen = figures.wasFrozen || state == FeedState::kFrozen;
      figures.wasLate = figures.wasLate || state == FeedState::kLate;
      if (state == FeedState::kLost && !figures.wasLost && options_.onLost) {
        options_.onLost(i, streams_[i]->message());
      }
      figures.wasLost = figures.wasLost || state == FeedState::kLost;
      isAnyGoingOn = isAnyGoingOn || streams_[i]->isGoingOn();
    }
    return isAnyGoingOn;
  }

  void noteAges(double seconds) {
    for (size_t i = 0; i < streams_.size(); ++i) {
      if (std::isfinite(feedSeconds_[i])) {
        const double age = seconds - feedSeconds_[i];
        ages_[i] += age;
        ++shown_[i];
        figures_.feeds[i].maxAgeSeconds = std::max(figures_.feeds[i].maxAgeSeconds, age);
      }
    }
  }

  /// Whether recorded feeds have nothing for longer than they may; says so in `gaps_`.
  bool isBeforeGap(double seconds) {
    const bool isAnyNew = std::ranges::any_of(frames_, [](const Image<Rgb8>& frame) { return !frame.empty(); });
    if (options_.streams.isLiveRun || isAnyNew) {
      return false;
    }
    std::vector<std::string> gaps(streams_.size());
    for (size_t i = 0; i < streams_.size(); ++i) {
      const std::optional<double> next = streams_[i]->nextSeconds();
      if (streams_[i]->isGoingOn() && (!next || *next <= seconds + kMaxFeedGapSeconds)) {
        return false;
      }
      if (next) {
        gaps[i] = fmt::format(
            "its next frame is {:.6g} s later, and the run ended before it: set \"clock_offset_seconds\", if its clock "
            "is another one",
            *next - seconds);
      }
    }
    gaps_ = gaps;
    return true;
  }

  /// Whether a feed shows what is no more.
  bool isStale(size_t feed, double seconds) const {
    return streams_[feed]->state() == FeedState::kFrozen ||
           seconds - feedSeconds_[feed] >= options_.streams.frozenSeconds;
  }

  std::vector<FeedLabel> labels(double seconds) const {
    std::vector<FeedLabel> labels;
    for (size_t i = 0; i < graph_.frusta(); ++i) {
      const size_t feed = graph_.feedIndexOf(i);
      const bool hasFrame = std::isfinite(feedSeconds_[feed]);
      const double age = hasFrame ? seconds - feedSeconds_[feed] : 0;
      FeedState state = streams_[feed]->state();
      if (state == FeedState::kLive && age >= options_.streams.frozenSeconds) {
        state = FeedState::kLate;  // its next frame has a later time: it left some out
      }
      if (state == FeedState::kEnded && age < options_.streams.frozenSeconds) {
        state = FeedState::kLive;  // what it shows is its last frame, and in time
      }
      if ((state == FeedState::kLive || state == FeedState::kFrozen) && composer_.isCovered(feed)) {
        state = FeedState::kCovered;
      }
      labels.push_back({state, hasFrame, age, remarks_[feed]});
    }
    return labels;
  }

  void finishFigures() {
    const auto frames = static_cast<double>(std::max<size_t>(figures_.frames, 1));
    figures_.framesPerSecond =
        figures_.wallSeconds > 0 ? static_cast<double>(figures_.frames) / figures_.wallSeconds : 0;
    figures_.meanFrameSeconds = composing_ / frames;
    for (size_t i = 0; i < streams_.size(); ++i) {
      FeedRunFigures& figures = figures_.feeds[i];
      figures.state = streams_[i]->state();
      figures.message = gaps_.empty() || gaps_[i].empty() ? streams_[i]->message() : gaps_[i];
      figures.reconnections = streams_[i]->reconnections();
      figures.framesRead = streams_[i]->framesRead();
      figures.framesSkipped = streams_[i]->framesSkipped();
      figures.meanAgeSeconds = shown_[i] > 0 ? ages_[i] / static_cast<double>(shown_[i]) : 0;
    }
  }

  FeedsRunOptions options_;
  FeedGraph graph_;
  FeedComposer composer_;
  std::vector<std::unique_ptr<FeedStream>> streams_;
  std::vector<Image<Rgb8>> frames_;
  std::vector<double> feedSeconds_;
  std::vector<std::string> remarks_;
  std::vector<size_t> remarkedConnections_;
  std::vector<double> ages_;       ///< the sum over outputs that show a frame
  std::vector<size_t> shown_;      ///< how many those are
  std::vector<std::string> gaps_;  ///< of each feed: why the run ended before its next frame
  double composing_ = 0;
  Image<Rgb8> image_;
  FeedsRunFigures figures_;
};

}  // namespace

bool mayBeLive(const FeedSetup& setup) {
  return std::any_of(setup.feeds.begin(), setup.feeds.end(),
                     [](const Feed& feed) { return videoSourceKind(feed.source).mayBeLive; });
}

FeedsRunFigures runFeeds(const FeedSetup& setup, const FeedsRunOptions& options,
                         const std::function<void(const ComposedFrame&)>& sink, const Progress& progress) {
  return FeedsRun(setup, options).run(sink, progress);
}

}  // namespace ocelli
