// The points of a proxy that an occlusion camera at an I-node of a sea has samples of (section 3.5.4.4.3): six square
// faces of a cube around the eye, as the text tiles its panoramas, each a reference image of the proxy of one kind.
#pragma once

#include <string>

#include "oc_core/sea/hidden_gathering.h"
#include "oc_core/sea/sea_settings.h"

namespace ocelli {

/// `kind` is the name of a kind of reference images (`ocelli camera list`), as "ddoc" or "cell"; those that are made
/// for a view cell take one that holds the images that hang on the I-node. `side`: pixels of a face. Throws InputError,
/// naming `--hidden`, for names of none, and kinds without images.
HiddenPoints hiddenPointsOf(const std::string& kind, int side);

/// Faces of so many pixels have samples about as close together as images of this projection.
int faceSideFor(const SeaProjection& projection);

/// Of what settings say; empty where they say none.
HiddenPoints hiddenPointsOf(const SeaSettings& settings);

}  // namespace ocelli
