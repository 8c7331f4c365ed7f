// An epipolar occlusion camera and its reference image, constructed at once: for those who need to know where the rays
// of empty pixels go, too.
#pragma once

#include "oc_core/ocri/eoc_builder.h"

namespace ocelli {

struct EocConstruction {
  EpipolarCamera camera;
  ReferenceImage image;
};

/// As buildEocImage(reference, segment, ...), whose image this is.
EocConstruction constructEoc(const PinholeCamera& reference, const ViewSegment& segment, const Mesh& mesh,
                             const EocOptions& options = {}, const SceneRenderer* renderer = nullptr);

}  // namespace ocelli
