// A scene as an occlusion camera sees it from where the viewer's eye is, sliced anew whenever the eye has moved, and
// once more with all pixels where it rests, or the feed has ended, after images that were smaller, as time ran short.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "display_driver/pacing/eye_feed.h"
#include "display_driver/pacing/image_scale.h"
#include "display_driver/pacing/stage_times.h"
#include "display_driver/pacing/two_stage_line.h"
#include "display_driver/pacing/volume_source.h"
#include "display_sim/slicing/slicer.h"
#include "oc_core/ocri/reference_image.h"

namespace ocelli {

struct EyesOptions {
  int width = 720;
  int height = 480;
  SliceOptions slicing;
  /// When time runs short, images have this share of the pixels each way at least, in (0, 1]; 1: always all of them.
  double minImageScale = 0.25;
  /// Refreshes that making a volume may take, 1 or 2. With 1 all of it is made in one: what is seen is young. With 2
  /// the image of one is built while another is sliced: images are larger, and a refresh older.
  int refreshesToMake = 1;

  enum class SceneState {
    kSame,
    kMoved,
    kEnded,  ///< its motion is over
  };
  /// Of a scene that moves in time: moves it to where it is when it will be seen, before the images of it are made;
  /// empty where it stands still. Called by one thread at a time, the one that makes the images.
  std::function<SceneState(HostTime seen)> moveScene = {};
};

class EyesSource final : public VolumeSource {
 public:
  struct Made {
    Made(ReferenceImages madeImages, bool imagesBeganCold = false)
        : images(std::move(madeImages)), beganCold(imagesBeganCold) {}

    ReferenceImages images;
    bool beganCold = false;  ///< took longer than most do, as it could not begin from the last one
  };
  /// Reference images for a view of a scene whose positions are in display radii. Throws InputError for views from
  /// which it cannot be seen. Called by one thread at a time.
  using ImagesFor = std::function<Made(const PinholeCamera& reference)>;

  /// The feed outlives the source.
  EyesSource(ImagesFor imagesFor, const DisplayProfile& profile, const EyesOptions& options, EyeFeed& feed);
  ~EyesSource() override;

  /// Ends where the feed has ended and its last place has been shown, or the motion of the scene is over. Eyes from
  /// which the scene cannot be seen (inside of it, or of the display) are left out, and the last volume stays.
  SourcedVolume volumeFor(HostTime seen) override;
  /// The first stage builds the image, the second slices its mesh.
  VolumeLine* line() override;

  // Of a source that makes nothing at the moment.

  /// Whether anybody ever said where the eye is.
  bool eyeCame() const { return eye_.has_value(); }
  uint64_t eyesLeftOut() const { return leftOut_; }
  /// Why, for the first one; for people.
  const std::string& firstLeftOut() const { return firstLeftOut_; }

  struct Stage {
    const char* name = "";
    StageTimes times;
  };
  /// Of the last frames: building the reference image, its mesh, slicing; last, moving the scene where it moves.
  const std::vector<Stage>& stages() const { return stages_; }

 private:
  TwoStageLine::SecondStage begin(HostTime seen);
  SourcedVolume leaveOut(const std::string& why);
  /// What an image took, and with how many of the pixels asked for each way.
  struct ImageCost {
    double scale = 1;  ///< as ImageScale gave it, to be told apart from others
    double seconds = 0;
    bool isException = false;  ///< says nothing of the next ones
  };
  SourcedVolume sliced(const ReferenceImages& images, const ImageCost& cost);

  ImagesFor imagesFor_;
  EyesOptions options_;
  EyeFeed& feed_;
  Slicer slicer_;
  std::optional<glm::vec3> eye_;
  std::vector<Stage> stages_;
  bool lastBeganCold_ = false;
  double lastScale_ = 1;
  int resting_ = 0;  ///< refreshes for which the eye has not moved
  uint64_t leftOut_ = 0;
  std::string firstLeftOut_;
  std::mutex scaleMutex_;
  ImageScale scale_;
  std::unique_ptr<TwoStageLine> line_;  ///< last: its threads use what is above
};

}  // namespace ocelli
