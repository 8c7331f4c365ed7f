// The eye of simulated subjects: it turns the layout of a trial into the identity image of the screen, by any
// renderer, and that into a percept (percept.h). Whatever stands behind the eye gets nothing else of the trial.
#pragma once

#include "oc_core/render/identity_image.h"
#include "study/agent/percept.h"
#include "study/task/trial_image.h"

namespace ocelli {

class VisibilitySensor {
 public:
  /// `screen` is where the layouts are shown.
  explicit VisibilitySensor(const TrialScreen& screen, StudyRenderer renderer = rasterizeStudy);

  /// What the layout lets one know. The floor is left out where `withFloor` is false, for those who have no use for
  /// it.
  Percept look(const TrialLayout& layout, bool withFloor) const;

 private:
  void addView(const TrialLayout& layout, const Mesh& mesh, int view, bool withFloor, Percept& percept) const;

  TrialScreen screen_;
  StudyRenderer renderer_;
};

}  // namespace ocelli
