// Runs a graph camera over its feeds: at each time of the output the newest frame of each feed until then.
//
// Recorded feeds are run as fast as they can be. Where one may be live (video_source.h), outputs are made when it is
// time for them; those that come too late are left out, so that no delay adds up.
#pragma once

#include <functional>

#include "oc_core/base/progress.h"
#include "oc_core/feeds_live/feed_composer.h"
#include "oc_core/feeds_live/feed_labels.h"

namespace ocelli {

struct FeedsRunOptions {
  double framesPerSecond = 30;  ///< of the output
  double seconds = 0;           ///< 0: until the last feed ends, which live ones never do
  /// Asked between outputs; the run ends well where it says so. May be empty.
  std::function<bool()> isStopped = {};
  /// Told when a feed is lost for the first time, and why. May be empty.
  std::function<void(size_t feed, const std::string& message)> onLost = {};
  /// Looks at the first frame of each feed, by index, and at the first after it was lost: what it returns stands in the
  /// feed's label from then on. May be empty; where it throws, the run ends so.
  std::function<std::string(size_t feed, const Image<Rgb8>& frame)> remarkOn = {};
  ErasedLook erased = ErasedLook::kBackground;
  std::function<ErasedLook()> erasedNow = {};  ///< asked for each image, where given, instead of `erased`
  bool showsHidden = true;  ///< those hidden by somebody who is erased, as they were (subject_memory.h)
  bool hasLabels = true;
  FeedStreamOptions streams;
  FeedBackgroundOptions backgrounds;
};

struct FeedRunFigures {
  std::string name;
  FeedState state = FeedState::kLive;  ///< at the end
  bool wasFrozen = false;              ///< at any time
  bool wasLate = false;
  bool wasLost = false;
  bool wasCovered = false;
  std::string message;
  size_t reconnections = 0;
  size_t framesRead = 0;
  size_t framesSkipped = 0;   ///< read, but never shown
  size_t outputsWithout = 0;  ///< output frames for which it had no new frame
  double maxAgeSeconds = 0;   ///< of the frame that an output shows
  double meanAgeSeconds = 0;  ///< over the outputs that show one
};

struct FeedsRunFigures {
  bool isLive = false;  ///< outputs were made when it was time for them
  size_t frames = 0;
  double wallSeconds = 0;
  double framesPerSecond = 0;   ///< how fast it ran
  double meanFrameSeconds = 0;  ///< from the frames of the feeds to the composed image
  double slowestFrameSeconds = 0;
  std::vector<FeedRunFigures> feeds;
};

/// What the run hands on for each output frame.
struct ComposedFrame {
  double seconds = 0;  ///< in the time of the place
  const Image<Rgb8>& image;
  const FeedComposer& composer;
  const std::vector<double>& feedSeconds;  ///< when the frame of each feed was taken; NaN where there is none
  const std::vector<FeedLabel>& labels;    ///< of each frustum
};

/// Whether a source of the setup may be live: outputs are then made when it is time for them.
bool mayBeLive(const FeedSetup& setup);

/// Recorded feeds may pause together for so long. Where the next frame comes later the run ends, and the message of
/// that feed says so: such timestamps are of a clock whose offset is unknown.
inline constexpr double kMaxFeedGapSeconds = 600;

/// Feeds may be lost. Throws InputError where none gives a frame. A run that is stopped while it waits for the first
/// one has made no image.
FeedsRunFigures runFeeds(const FeedSetup& setup, const FeedsRunOptions& options,
                         const std::function<void(const ComposedFrame&)>& sink, const Progress& progress = {});

}  // namespace ocelli
