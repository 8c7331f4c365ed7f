#include "oc_core/depth_views/views_scene.h"

namespace ocelli {

Representation ViewsScene::represent(const CameraChoice& choice, const PinholeCamera& reference,
                                     const Progress& progress, RepresentationTimes* times) const {
  return buildRepresentation(choice, reference, surface_, progress, times);
}

}  // namespace ocelli
