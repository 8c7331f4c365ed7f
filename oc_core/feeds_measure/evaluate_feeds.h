// What a composed image gets wrong: simulated feeds beside the graph camera's own rendering of the scene, with the same
// frusta. Which walker a pixel of the composed image shows is known exactly: from what the camera saw when the frame
// was taken, and from the marks by which subjects were erased or shown.
#pragma once

#include <filesystem>
#include <vector>

#include "oc_core/feeds_live/feeds_run.h"

namespace ocelli {

/// What became of one walker in one frame.
enum class WalkerFate {
  kRight,      ///< seen where the graph camera sees it, and nowhere else; or rightly not seen
  kBetween,    ///< crosses a near face, so that it fades, and is seen
  kDoubled,    ///< seen where it should be, and elsewhere too
  kMisplaced,  ///< seen elsewhere alone
  kMissing,    ///< not seen, though the camera of its frustum sees it
  kHidden,     ///< not seen, as that camera sees hardly anything of it: somebody stands before it
  kGhost,      ///< seen, though the graph camera does not see it
};
inline constexpr size_t kWalkerFates = 7;
const char* nameOf(WalkerFate fate);

struct FeedsEvaluation {
  size_t frames = 0;
  /// Of each walker: frames by fate.
  std::vector<std::array<size_t, kWalkerFates>> walkers;
  double psnrDecibels = 0;  ///< of all frames together, sRGB
  FeedsRunFigures run;

  size_t count(WalkerFate fate) const;
  /// The share of all walkers and frames that are right or fade.
  double rightShare() const;
};

struct FeedsEvaluationOptions {
  double seconds = 0;              ///< 0: all
  std::filesystem::path pictures;  ///< a folder for pictures of errors, composed beside rendered; empty: none
  FeedBackgroundOptions backgrounds;
};

/// `folder` is one that simulateFeeds() wrote. Throws InputError where it is not.
FeedsEvaluation evaluateFeeds(const std::filesystem::path& folder, const FeedsEvaluationOptions& options,
                              const Progress& progress = {});

}  // namespace ocelli
