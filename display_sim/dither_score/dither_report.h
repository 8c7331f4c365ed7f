// Dithers compared: their scores on fields and on a surface, and how evenly surfaces are lit; as text, JSON and
// images.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "display_sim/dither_score/dither_fields.h"
#include "display_sim/dither_score/dither_score.h"
#include "display_sim/dither_score/light_evenness.h"
#include "display_sim/frames/display_profile.h"
#include "oc_core/base/progress.h"

namespace ocelli {

struct DitherReportOptions {
  DisplayProfile profile;  ///< its bits a channel are those of the fields
  std::vector<NamedDither> dithers;
  std::vector<double> evenLightRadii{0, 0.5, 1};
};

struct FieldScore {
  std::string field;
  DitherScore score;
};

/// Of white surfaces.
struct EvennessRow {
  double evenLightRadius = 0;
  EvennessScore within;  ///< that radius; the display's where it is 0
  EvennessScore all;
  std::vector<LightSample> samples;
};

struct DitherRow {
  NamedDither dither;
  std::vector<FieldScore> fields;
  double surfaceError = 0;
  std::vector<EvennessRow> evenness;
};

struct DitherReport {
  DitherReportOptions options;
  std::vector<DitherRow> rows;
};

DitherReport compareDithers(const DitherReportOptions& options, const Progress& progress = {});

/// Mean over blocks with at least 32 voxels of a shaded ball's surface of |light shown - light wanted| for each voxel.
double surfaceBlockError(const DisplayProfile& profile, ColorReduction colors);

std::string textOf(const DitherReport& report);
std::string jsonOf(const DitherReport& report);
/// Writes ramp.png, grey-sphere.png, colour-wheel.png (ditherImage()) and evenness.png (evennessImage(), of the
/// first dither) into a folder, which is made where it is missing. Throws WorkError.
void writeImages(const DitherReport& report, const std::filesystem::path& folder);

}  // namespace ocelli
