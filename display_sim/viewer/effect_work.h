// The pictures of the effect pane, on a thread of their own: loading the scene with its roles, building what stands for
// it, and drawing. What is newest counts: work that a newer wish has made useless is left where it reports its
// progress, and between two pictures.
//
// While the eye moves, pictures are as small as it takes to draw one in kPreviewSeconds. Once it has stood still for
// kStillSeconds they become larger, each time twice as wide, until they are whole; then the other picture is drawn, and
// both are compared. What would take longer than kMaxPictureSeconds is left out, unless someone waits for it: a picture
// that is being drawn cannot be broken off.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "display_sim/viewer/effect_difference.h"
#include "display_sim/viewer/effect_model.h"
#include "display_sim/viewer/newest_wish.h"
#include "oc_core/base/progress.h"

namespace ocelli {

/// One of the two pictures.
struct EffectImage {
  Image<Rgb8> image;        ///< empty: not drawn
  double milliseconds = 0;  ///< that it took
};

/// What has been drawn of one view.
struct EffectPicture {
  EffectWanted wanted;
  bool isWhole = false;       ///< as large as wanted
  double secondsLeftOut = 0;  ///< about what the whole one, or the other one, would take, where it is left out
  EffectImage byWay;
  EffectImage traced;
  std::optional<EffectDifference> difference;  ///< where both are whole, or both were asked for

  /// What the pane shows; null where that has not been drawn.
  const Image<Rgb8>* shown(EffectShown::Content content) const;
};

struct EffectStatus {
  bool busy = false;
  std::string stage;  ///< of what is being made; empty while pictures are drawn
  double fraction = 0;
  std::string error;                             ///< why there is no picture; empty where there may be one
  uint64_t sceneRevision = 0;                    ///< of the scene that the following are of
  std::string effect;                            ///< empty: not known
  std::optional<View> home;                      ///< the view of that effect
  std::shared_ptr<const EffectPicture> picture;  ///< the newest; null: none
};

/// How wide the first picture of a view is, as a share of a whole one, which takes about so many seconds; 0: not known.
/// A half, a quarter or an eighth, where the whole one takes too long; an eighth where nothing is known.
double previewScale(double secondsOfWhole);

class EffectWork {
 public:
  static constexpr double kPreviewSeconds = 0.06;
  static constexpr double kStillSeconds = 0.15;
  static constexpr double kMaxPictureSeconds = 3;

  /// Its end waits for the picture, or the part of a way's building that does not report its progress, that is under
  /// way.
  EffectWork() : wishes_([this](const EffectWanted& wanted) { make(wanted); }) {}

  /// What failed is not tried again until something of it changes.
  void want(const EffectWanted& wanted) { wishes_.want(wanted); }
  EffectStatus status() const { return wishes_.status(); }
  /// Until nothing is left to do, without small pictures and without waiting for the eye.
  void waitUntilIdle();

 private:
  void make(const EffectWanted& wanted);
  void makeAll(const EffectWanted& wanted);
  void drawAll(const EffectWanted& wanted);
  /// Draws what is missing of the contents that are asked for, in this size.
  void draw(EffectPicture& picture, const glm::ivec2& size, bool byWay, bool traced);
  Progress progressOf(const EffectWanted& wanted);
  /// How wide the first picture is, as a share of a whole one.
  double firstScale(const EffectWanted& wanted, bool byWay, bool traced) const;
  /// What pictures of this size take; 0 where that is not known.
  double secondsOf(const glm::ivec2& size, bool byWay, bool traced) const;
  /// Whether they are left out, as they take too long.
  bool isLeftOut(double seconds) const { return seconds > kMaxPictureSeconds && !wishes_.someoneWaits(); }
  void clearStage();
  void publish(const EffectPicture& picture);

  // Of the thread alone.
  EffectModel model_;
  EffectPicture last_;                    ///< the last one that was whole
  EffectWanted tried_;                    ///< what was made last, or failed
  std::optional<EffectWanted> notBuilt_;  ///< what failed
  double secondsPerPixelByWay_ = 0;       ///< 0: not known
  double secondsPerPixelTraced_ = 0;
  NewestWish<EffectWanted, EffectStatus> wishes_;
};

}  // namespace ocelli
