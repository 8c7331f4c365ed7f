#include "oc_core/volume/transfer_presets.h"

#include <algorithm>
#include <cstdint>

#include "oc_core/base/check.h"
#include "oc_core/base/error.h"
#include "oc_core/image/color.h"

namespace ocelli {
namespace {

constexpr VolumeShading kLit{.isOn = true};

// Hounsfield units: air -1000, lung -900 to -500, fat -120 to -60, water 0, soft tissue 20 to 80, blood with contrast
// agent 150 to 500, spongy bone from 200, compact bone 700 to 2000, metal above 2500.

TransferDescription ctBone() {
  return {
      .points = {transferPoint(180, 0xb08d66, 0), transferPoint(280, 0xc9ab84, 0.12), transferPoint(600, 0xe6d3b3, 0.5),
                 transferPoint(1200, 0xf7eddc, 0.85), transferPoint(3000, 0xffffff, 0.95)},
      .shading = kLit};
}

TransferDescription ctSoftTissue() {
  return {.points = {transferPoint(-150, 0xc9a24d, 0), transferPoint(-90, 0xd9b65f, 0.015),
                     transferPoint(-40, 0xb5614e, 0.005), transferPoint(20, 0xa34a44, 0.04),
                     transferPoint(80, 0xc0665a, 0.1), transferPoint(150, 0xd98a76, 0.12),
                     transferPoint(300, 0xeecfae, 0.3), transferPoint(1000, 0xfdf6e8, 0.7)},
          .shading = kLit};
}

TransferDescription ctSkinAndBone() {
  return {.points = {transferPoint(-600, 0xc78a6b, 0), transferPoint(-400, 0xd79b7c, 0.025),
                     transferPoint(-200, 0xe0ab8d, 0.025), transferPoint(-120, 0xe0ab8d, 0.002),
                     transferPoint(180, 0xb08d66, 0.002), transferPoint(300, 0xc9ab84, 0.15),
                     transferPoint(700, 0xf2e4cb, 0.7), transferPoint(3000, 0xffffff, 0.95)},
          .shading = kLit};
}

TransferDescription ctLung() {
  return {.points = {transferPoint(-980, 0x1f4f7a, 0), transferPoint(-900, 0x2b83b8, 0.012),
                     transferPoint(-750, 0x6db3dc, 0.03), transferPoint(-550, 0xb9dcf0, 0.02),
                     transferPoint(-400, 0xe9c9b1, 0.005), transferPoint(-250, 0xe9c9b1, 0),
                     transferPoint(250, 0xf2e4cb, 0), transferPoint(800, 0xf7eddc, 0.08)},
          .shading = kLit};
}

TransferDescription mrDefault() {
  return {.scale = "percentiles",
          .points = {transferPoint(0.12, 0x1c2b3a, 0), transferPoint(0.3, 0x4b5d6b, 0.02),
                     transferPoint(0.6, 0xa08f86, 0.1), transferPoint(0.85, 0xdccab6, 0.25),
                     transferPoint(1.2, 0xfff8ee, 0.5)},
          .shading = kLit};
}

TransferDescription mrBrain() {
  return {.scale = "percentiles",
          .points = {transferPoint(0.3, 0x6e4a52, 0), transferPoint(0.45, 0x93646a, 0.06),
                     transferPoint(0.62, 0xc09a94, 0.2), transferPoint(0.78, 0xead9c8, 0.35),
                     transferPoint(0.95, 0xfff6e8, 0.3), transferPoint(1.1, 0xfff6e8, 0.05)},
          .shading = kLit};
}

TransferDescription ramp() {
  return {.scale = "range", .points = {transferPoint(0, 0x000000, 0), transferPoint(1, 0xffffff, 0.1)}};
}

/// Nine samples of matplotlib's "inferno", whose lightness grows evenly.
TransferDescription hot() {
  return {.scale = "range",
          .points = {transferPoint(0, 0x000004, 0), transferPoint(0.125, 0x210c4a, 0.005),
                     transferPoint(0.25, 0x57106e, 0.01), transferPoint(0.375, 0x8a226a, 0.02),
                     transferPoint(0.5, 0xbc3754, 0.035), transferPoint(0.625, 0xe45a31, 0.05),
                     transferPoint(0.75, 0xf98e09, 0.07), transferPoint(0.875, 0xf9cb35, 0.1),
                     transferPoint(1, 0xfcffa4, 0.15)}};
}

/// Nine samples of "cividis" (J. Nuñez and others, "Optimizing colormaps with consideration for color vision
/// deficiency", 2018).
TransferDescription cividis() {
  return {.scale = "range",
          .points = {transferPoint(0, 0x00224e, 0), transferPoint(0.125, 0x123570, 0.005),
                     transferPoint(0.25, 0x3b496c, 0.01), transferPoint(0.375, 0x575d6d, 0.02),
                     transferPoint(0.5, 0x707173, 0.035), transferPoint(0.625, 0x8a8678, 0.05),
                     transferPoint(0.75, 0xa59c74, 0.07), transferPoint(0.875, 0xc3b369, 0.1),
                     transferPoint(1, 0xfee838, 0.15)}};
}

const TransferPreset& presetCalled(const std::string& name) {
  const auto found = std::ranges::find(transferPresets(), name, &TransferPreset::name);
  OC_CHECK(found != transferPresets().end(), "a preset that the toolkit asks for");
  return *found;
}

/// Whether values look like Hounsfield units: the air around a body is -1000, and scanners fill corners with as little
/// as -3024; bone is above 300.
bool hasHounsfieldRange(const ScalarVolume& volume) {
  const ValueRange range = valueRange(volume);
  return range.least >= -4096 && range.least <= -900 && range.greatest >= 300;
}

}  // namespace

TransferPoint transferPoint(double value, uint32_t color, double opacity) {
  const auto channel = [&](unsigned shift) {
    return static_cast<double>(linearFromSrgbByte(static_cast<uint8_t>(color >> shift)));
  };
  return {value, {channel(16), channel(8), channel(0)}, opacity};
}

const std::vector<TransferPreset>& transferPresets() {
  static const std::vector<TransferPreset> presets{
      {"ct-bone", "CT: bones and metal alone", ctBone()},
      {"ct-soft-tissue", "CT: muscles and organs in red, fat in yellow, bones in white", ctSoftTissue()},
      {"ct-skin-and-bone", "CT: the skin as a thin veil over the bones", ctSkinAndBone()},
      {"ct-lung", "CT: the air of lungs and airways in blue, bones faintly", ctLung()},
      {"mr-default", "MRI: brighter tissue is lighter and denser", mrDefault()},
      {"mr-brain", "MRI, weighted by T1: grey matter in rose, white matter in cream, fat faintly", mrBrain()},
      {"ramp", "anything: grey, from black and clear at the least value to white at the greatest", ramp()},
      {"hot", "anything: from black and clear over red to yellow (inferno)", hot()},
      {"cividis", "anything: from blue and clear to yellow, alike for people with any colour vision", cividis()}};
  return presets;
}

const TransferPreset& presetFor(const ScalarVolume& volume) {
  const VolumeFacts& facts = volume.facts();
  if (facts.modality == "CT" || facts.valueUnit == "HU") {
    return presetCalled("ct-bone");
  }
  if (facts.modality == "MR") {
    return presetCalled("mr-default");
  }
  if (!volume.grid().isAnatomical) {
    return presetCalled("ramp");
  }
  return presetCalled(hasHounsfieldRange(volume) ? "ct-bone" : "mr-default");
}

TransferDescription transferByName(const std::string& nameOrFile) {
  if (nameOrFile.ends_with(".json")) {
    return readTransferFile(nameOrFile);
  }
  std::string names;
  for (const TransferPreset& preset : transferPresets()) {
    if (preset.name == nameOrFile) {
      return preset.description;
    }
    names += (names.empty() ? "" : ", ") + preset.name;
  }
  throw InputError("there is no transfer function of this name", nameOrFile,
                   "use one of " + names + ", or a file that ends in .json");
}

}  // namespace ocelli
