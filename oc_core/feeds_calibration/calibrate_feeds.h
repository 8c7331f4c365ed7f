// The work of `ocelli feeds calibrate`: from videos and images to lenses and poses in a setup.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "oc_core/base/progress.h"
#include "oc_core/feeds/feed_setup.h"
#include "oc_core/feeds/known_places.h"
#include "oc_core/feeds_calibration/lens_calibration.h"
#include "oc_core/feeds_calibration/pose_solver.h"
#include "oc_core/feeds_calibration/tag_detection.h"

namespace ocelli {

/// A lens from a video of the board, or a folder of images of it, all of one size. Throws InputError as
/// calibrateLens() does, and for images of different sizes.
LensCalibration calibrateLensFrom(const std::string& source, const CalibrationBoard& board,
                                  const Progress& progress = {});

/// The lens as the setup has it: what `"lens"` of a feed holds.
std::string jsonText(const FeedLens& lens);

struct PoseCalibrationOptions {
  bool hasNoLens = false;      ///< a focal length is found with the pose, from corners that are not in one plane
  size_t images = 10;          ///< of each feed, whose corners are averaged
  double maxWaitSeconds = 10;  ///< for an image
};

struct FeedCalibration {
  std::string feed;
  size_t tags = 0;     ///< known ones that it sees
  size_t unknown = 0;  ///< that it sees and the table lacks
  size_t points = 0;
  double rmsPixels = 0;
  double maxPixels = 0;
  std::string worst;    ///< the point of maxPixels: "tag 3" or "corner 2"
  std::string warning;  ///< what is doubtful, and what to do; or nothing
  std::string failure;  ///< why it has no pose: an error message; or nothing
};

/// Sets the pose of every feed of the setup whose points are known, and the places of the setup; `where` names the
/// table. A tag that no feed sees is a warning of the result. A feed has failed, and keeps its pose, where it has too
/// few points, cannot be read, has images of another size than the setup says, or sees tags of the table from behind.
/// Throws InputError where a corner names a feed that does not exist.
struct PoseCalibration {
  std::vector<FeedCalibration> feeds;
  std::vector<std::string> warnings;
};
PoseCalibration calibratePoses(FeedSetup& setup, const KnownPlaces& places, const std::string& where,
                               const PoseCalibrationOptions& options, const Progress& progress = {});

/// Whether a camera is where the setup has it.
struct PoseCheck {
  std::string feed;
  size_t tags = 0;             ///< known ones that it sees; 0: nothing can be said
  bool shouldSeeTags = false;  ///< it saw some when its pose was found
  double medianPixels = 0;     ///< between corners that are seen, and where the setup has them
  bool hasMoved = false;
  std::string message;  ///< "camera 2 (left) has moved: 14 pixels", and what to do; empty where all is well
};

/// Corners are found to within half a pixel; vibrations and noise stay below this.
inline constexpr double kMovedPixels = 3;

/// Of a feed, by index.
PoseCheck checkPose(const FeedSetup& setup, size_t feed, const Image<Rgb8>& image, const KnownPlaces& places,
                    double movedPixels = kMovedPixels);
/// The same for the first image of every feed.
std::vector<PoseCheck> checkPoses(const FeedSetup& setup, const KnownPlaces& places, double movedPixels,
                                  const PoseCalibrationOptions& options);

}  // namespace ocelli
