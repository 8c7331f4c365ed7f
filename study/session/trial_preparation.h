// What the views of trials show that takes longer to make than a frame lasts, made before the session: the images of an
// eye that moves before a display.
#pragma once

#include "oc_core/base/progress.h"
#include "study/protocol/schedule.h"

namespace ocelli {

/// Of all trials of a schedule, of all practice that may come, and of the pages that show an example. Returns how many
/// layouts it made images of, the same ones again included; 0 where no view takes long. `progress` goes from 0 to 1
/// over all of them. Throws InputError where images take more memory than is kept.
int prepareTrials(const Protocol& protocol, const SessionSchedule& schedule, const TrialScreen& screen,
                  const Progress& progress = {});

}  // namespace ocelli
