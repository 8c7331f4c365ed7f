// Transfer functions by name: for CT in Hounsfield units, for MRI by percentiles, for everything else by range.
//
// Colours of the same hue grow lighter with density, and what must be told apart differs in lightness too, so that
// people with any colour vision read them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "oc_core/volume/transfer_file.h"

namespace ocelli {

struct TransferPreset {
  std::string name;
  std::string summary;  ///< one sentence
  TransferDescription description;
};

/// A new one is one more row in transfer_presets.cpp.
const std::vector<TransferPreset>& transferPresets();

/// The preset that fits a volume: by its facts (modality, unit), else by whether it is anatomical and its values are
/// those of a CT.
const TransferPreset& presetFor(const ScalarVolume& volume);

/// A point whose colour is 0xRRGGBB, in sRGB.
TransferPoint transferPoint(double value, uint32_t color, double opacity);

/// A preset by its name, or a file by its path, which ends in ".json". Throws InputError that lists the presets.
TransferDescription transferByName(const std::string& nameOrFile);

}  // namespace ocelli
