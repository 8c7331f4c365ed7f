// The eye of simulated subjects: it turns the picture of a trial into the identity image of the screen, by any
// renderer, and that into a percept (percept.h). Whatever stands behind the eye gets nothing else of the trial.
#pragma once

#include "oc_core/render/identity_image.h"
#include "study/subject/percept.h"
#include "study/task/trial_image.h"

namespace ocelli {

class IdentityEye {
 public:
  /// `screen` is where the pictures are shown.
  explicit IdentityEye(const TrialScreen& screen, StudyDrawer drawer = rasterizeStudy);

  /// What the picture lets one know. The floor is left out where `withFloor` is false, for those who have no use for
  /// it.
  Percept look(const TrialPicture& picture, bool withFloor) const;

 private:
  void addView(const TrialPicture& picture, const Mesh& mesh, int view, bool withFloor, Percept& percept) const;

  TrialScreen screen_;
  StudyDrawer drawer_;
};

}  // namespace ocelli
