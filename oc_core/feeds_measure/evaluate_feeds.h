// What a composed image gets wrong: simulated feeds beside the graph camera's own rendering of the scene, with the same
// frusta. Which walker a pixel of the composed image shows is known exactly: from what the camera saw when the frame
// was taken, and from the marks by which subjects were erased or shown.
#pragma once

#include <array>
#include <filesystem>
#include <vector>

#include "oc_core/feeds_live/feeds_run.h"
#include "oc_core/feeds_measure/error_pictures.h"
#include "oc_core/feeds_measure/feed_seams.h"
#include "oc_core/feeds_measure/stitcher_figures.h"
#include "oc_core/feeds_measure/walker_fates.h"

namespace ocelli {

/// One frame of the composed image.
struct FrameJudgement {
  double seconds = 0;
  std::vector<WalkerFate> fates;  ///< of each walker
  FeedSeams seams;
};

struct FeedsEvaluation {
  size_t frames = 0;
  /// Of each walker: frames by fate.
  std::vector<std::array<size_t, kWalkerFates>> walkers;
  /// Walkers and frames that would be right or fade, if it were known of each pixel of a feed whom it shows and where
  /// that one stands, and nobody were shown as he was: the others are hidden, for the most part, from the camera that
  /// should show them.
  size_t possible = 0;
  double psnrDecibels = 0;  ///< of all frames together, sRGB
  std::vector<FrameJudgement> timeline;
  FeedSeams seams;                     ///< mean of all frames
  std::vector<ErrorPicture> pictures;  ///< in the folder of the options
  StitcherFigures stitcher;            ///< of the frames that the options say; none without it
  FeedsRunFigures run;

  size_t count(WalkerFate fate) const;
  /// The share of all walkers and frames that are right or fade.
  double rightShare() const;
  /// The share that would be, by what these cameras see at that time.
  double possibleShare() const;
};

struct FeedsEvaluationOptions {
  double seconds = 0;              ///< 0: all
  std::filesystem::path setup;     ///< with other near faces or poses than that of the folder, which is meant if empty
  std::filesystem::path pictures;  ///< a folder for pictures of errors (error_pictures.h); empty: none
  FeedBackgroundOptions backgrounds;
  bool showsHidden = true;  ///< as FeedsRunOptions has it
  /// Puts each so manieth frame into OpenCV's stitcher, too, where hasStitcher(); 0: none.
  size_t stitchEvery = 0;
};

/// `folder` is one that simulateFeeds() wrote. Throws InputError where it is not.
FeedsEvaluation evaluateFeeds(const std::filesystem::path& folder, const FeedsEvaluationOptions& options,
                              const Progress& progress = {});

}  // namespace ocelli
