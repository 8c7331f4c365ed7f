#include "display_sim/volume_solidity/volume_ways.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "display_sim/volume_solidity/volume_truth.h"
#include "oc_core/base/error.h"

namespace ocelli {
namespace {

void keepAll(ShownVolumeOptions&, const VolumeWaySettings&) {}

void lightGradients(ShownVolumeOptions& options, const VolumeWaySettings& settings) {
  options.sampling.fullLightGradient = settings.fullLightGradient;
}

void cutAway(ShownVolumeOptions& options, const VolumeWaySettings& settings) {
  options.eyes = {settings.referenceEye};
  options.cutaway = settings.cutaway;
}

void showSeen(ShownVolumeOptions& options, const VolumeWaySettings& settings) {
  options.eyes = {settings.referenceEye};
  options.seenOpacity = settings.seenOpacity;
}

void showSeenFromCell(ShownVolumeOptions& options, const VolumeWaySettings& settings) {
  options.eyes = settings.cellEyes;
  options.seenOpacity = settings.seenOpacity;
}

void showSeenGradients(ShownVolumeOptions& options, const VolumeWaySettings& settings) {
  showSeen(options, settings);
  lightGradients(options, settings);
}

void cutAwayAndShowSeen(ShownVolumeOptions& options, const VolumeWaySettings& settings) {
  cutAway(options, settings);
  options.seenOpacity = settings.seenOpacity;
}

std::vector<VolumeWay> builtinVolumeWays() {
  return {
      {"visible", "each eye sees what is not hidden from it alone: what no display for several eyes shows", keepAll,
       SolidityMeter::Shown::kVisibleOnly},
      {"everything", "all light of the volume", keepAll},
      {"gradient", "light by the gradient: boundaries", lightGradients},
      {"cutaway", "without what lies on the viewer's side of a plane", cutAway},
      {"seen", "what the reference eye would see", showSeen},
      {"seen-cell", "what the reference eye or one at a corner of the view cell would see", showSeenFromCell},
      {"seen-gradient", "what the reference eye would see, lit by the gradient", showSeenGradients},
      {"cutaway-seen", "what the reference eye would see of the volume cut away", cutAwayAndShowSeen},
  };
}

Registry<VolumeWay>& volumeWayRegistry() {
  static Registry<VolumeWay> registry("way to show a volume", builtinVolumeWays());
  return registry;
}

}  // namespace

Rows<VolumeWay> volumeWays() {
  return volumeWayRegistry().rows();
}

void registerVolumeWay(VolumeWay way) {
  if (way.name.empty() || way.name.find(',') != std::string::npos) {
    throw InputError("a way to show a volume cannot have this name", "\"" + way.name + "\"",
                     "give it a name without a comma");
  }
  if (!way.set) {
    throw InputError("this way has no function that sets what is shown", way.name, "set `set` of its row");
  }
  volumeWayRegistry().add(std::move(way));
}

const VolumeWay& volumeWayByName(const std::string& name, const std::string& option) {
  const Rows<VolumeWay> ways = volumeWays();
  const auto way = std::ranges::find(ways, name, &VolumeWay::name);
  if (way == ways.end()) {
    std::string names;
    for (const VolumeWay& each : ways) {
      names += (names.empty() ? "" : ", ") + each.name;
    }
    throw InputError("there is no way \"" + name + "\" to show a volume", option, "one of " + names);
  }
  return *way;
}

std::vector<SolidityFigures> measureVolumeWays(
    const VolumeWaysToMeasure& wanted, const SolidityOptions& options, const Progress& progress,
    const std::function<SolidityMeter::Visitor(const std::string& way)>& visitor) {
  struct Measured {
    VolumeRenderer renderer;
    std::unique_ptr<SolidReference> truth;
    std::unique_ptr<SolidityMeter> meter;
    bool isCut;
  };
  // Ways that show the same volume share what its opaque images cost.
  std::vector<std::unique_ptr<Measured>> meters;
  std::vector<SolidityFigures> figures;
  VolumeSlicer slicer(options.profile);
  for (const std::string& name : wanted.ways) {
    const VolumeWay& way = volumeWayByName(name, "ways");
    ShownVolumeOptions shownOptions = wanted.shown;
    way.set(shownOptions, wanted.settings);
    const ShownVolume shown(wanted.scene, options.profile, shownOptions, progress);
    const bool isCut = shownOptions.cutaway.has_value();
    auto measured =
        std::ranges::find_if(meters, [&](const std::unique_ptr<Measured>& each) { return each->isCut == isCut; });
    if (measured == meters.end()) {
      auto made = std::make_unique<Measured>(Measured{
          VolumeRenderer(shown.seenScene(), {.depthOpacity = wanted.settings.seenOpacity}), nullptr, nullptr, isCut});
      made->truth = solidVolume(made->renderer);
      made->meter = std::make_unique<SolidityMeter>(*made->truth, options);
      measured = meters.insert(meters.end(), std::move(made));
    }
    const Volume& volume = slicer.slice(shown.samples(), shown.light());
    figures.push_back((*measured)->meter->measure(name, volume, 0, way.shown, progress,
                                                  visitor ? visitor(name) : SolidityMeter::Visitor{}));
  }
  return figures;
}

}  // namespace ocelli
