// A look at a volume or a recording as an animated PNG: its light, seen from a little above, while the view turns.
#pragma once

#include <filesystem>

#include "display_sim/frames/svol_reader.h"
#include "display_sim/frames/volume.h"
#include "oc_core/base/progress.h"
#include "oc_core/image/image.h"
#include "oc_core/image/png_file.h"

namespace ocelli {

struct PreviewOptions {
  int pixels = 360;  ///< the image's sides, in [16, 2048]
};

/// One volume: a turn around it in five seconds. A recording: it plays at its own speed, in up to 120 images evenly
/// taken from it, and the view sways. Throws InputError and WorkError.
void exportPreview(const std::filesystem::path& path, SvolReader& reader, const PreviewOptions& options = {},
                   const Progress& progress = {});

struct PreviewView {
  double turnRadians = 0;  ///< around the axis, from z towards x
  double reachRadii = 1;   ///< from the middle of the image to its border
};

/// Linear light of a volume in parallel projection: a voxel gives its light, times the space that it takes, to the
/// pixels around it. What is far gives less than what is near.
Image<glm::vec3> projectedLight(const Volume& volume, const PreviewView& view, int pixels);
/// The least reach that holds all lit voxels in every turn of the view; 0 for a dark volume.
double previewReach(const Volume& volume);

}  // namespace ocelli
