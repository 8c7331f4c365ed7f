// Builds a sea of images: the hierarchy, and every image coded as its node has it (section 3.5.4.2).
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "oc_core/base/progress.h"
#include "oc_core/sea/hidden_gathering.h"
#include "oc_core/sea/sea_proxy.h"
#include "oc_core/sea/sea_settings.h"
#include "oc_core/sea/sea_source.h"

namespace ocelli {

struct SeaBuildReport {
  size_t images = 0;
  size_t inner = 0;    ///< I-nodes
  size_t resumed = 0;  ///< images that an earlier build had left
  uint64_t fileBytes = 0;
  uint64_t rawBytes = 0;  ///< three bytes a pixel
  double seconds = 0;
};

/// Writes `path`. `settings` are validated, their source and projection are those of `source`. The proxy is stored on a
/// grid of 16 bits, and used as it is stored. `startOver` removes what an earlier build has left; otherwise this goes
/// on with it. The same input gives the same bytes, whatever the number of threads, and whether a build was stopped in
/// between or not. Memory does not grow with the number of images, but for some hundred bytes each. Where settings have
/// hidden samples, `hiddenPoints` chooses them, on any thread; images that hang on I-nodes may then be asked for twice.
SeaBuildReport buildSea(const SeaSource& source, const Mesh& proxy, const SeaSettings& settings,
                        const std::filesystem::path& path, bool startOver = false, const Progress& progress = {},
                        const HiddenPoints& hiddenPoints = {});

/// The images in groups, each of which hangs on images of the groups before it alone: what is built together.
std::vector<std::vector<uint32_t>> buildGroups(const SeaTree& tree);

/// What the quality of a residual is lowered to by its energy, where these are the mean and the standard deviation of
/// all: by the share `adaptive` at mean - deviation and below, not at all at mean + deviation and above.
struct EnergyRange {
  double mean = 0;
  double deviation = 0;
};
double adaptedQuality(double quality, double adaptive, double energy, const EnergyRange& range);

}  // namespace ocelli
