#include "cli/volume_slicing_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "cli/number_check.h"
#include "cli/values.h"
#include "display_sim/volume_slicing/swept_range.h"
#include "display_sim/volume_solidity/masked_volume.h"
#include "oc_core/base/conventions.h"
#include "oc_core/base/error.h"
#include "oc_core/volume/transfer_file.h"
#include "oc_core/volume/transfer_presets.h"
#include "oc_core/volume/volume_series.h"

namespace ocelli {
namespace {

constexpr const char* kMaskOption = "--mask";
constexpr const char* kGainOption = "--light-gain";
constexpr const char* kGradientOption = "--gradient-light";
constexpr const char* kCutawayOption = "--cutaway";
constexpr const char* kSeenOption = "--seen-opacity";
constexpr const char* kViewerOption = "--viewer";

/// Fewer steps between the values that most voxels have show as bands.
constexpr double kFewSteps = 64;

void noteFewSteps(const ShownVolume& shown, const CommandContext& context) {
  const double steps = shown.samples().commonSteps();
  if (steps > 0 && steps < kFewSteps) {
    const ValueRange& range = shown.samples().range();
    context.note(fmt::format(
        "warning: most voxels have values that are {:.0f} of {} steps apart on the display, as the transfer function, "
        "--iso or --mask tells values from {:g} to {:g} apart: give points that lie closer together",
        steps, kSweptMeans - 1, range.least, range.greatest));
  }
}

}  // namespace

void addVolumeSlicingOptions(CLI::App& command, VolumeSlicingChoice& choice) {
  command.get_option("--iso")->description(
      "Of a volume: show the surface at this value alone, a voxel thick, straight from the field");
  command
      .add_option(kMaskOption, choice.mask,
                  "Of a volume: show these values alone, LEAST:GREATEST, or what this second volume, in the same "
                  "coordinates, marks by values of 0.5 or more")
      ->type_name("LEAST:GREATEST|VOLUME");
  command
      .add_option(kGainOption, choice.gain,
                  "Of a volume: multiply its extinction by this: more light of what is thin, none above full light")
      ->check(numberCheck(1e-3, 1e3))
      ->type_name("FACTOR")
      ->capture_default_str();
  command
      .add_option(kGradientOption, choice.fullLightGradient,
                  "Of a volume: full light where its values change by this share of their range over a voxel, and less "
                  "in proportion, so that boundaries show and what is even inside does not. 0: light everywhere")
      ->check(numberCheck(0, 1))
      ->type_name("SHARE")
      ->capture_default_str();
  command
      .add_option(kCutawayOption, choice.cutaway,
                  "Of a volume: leave out what lies farther than this from the centre towards a viewer (--viewer)")
      ->check(numberCheck(-1, 1))
      ->type_name("RADII");
  command
      .add_option(
          kSeenOption, choice.seenOpacity,
          "Of a volume: leave out what a viewer (--viewer) would not see behind this opacity of what lies before "
          "it, as an emissive display hides nothing")
      ->check(numberCheck(0.01, 0.99))
      ->type_name("OPACITY");
  command
      .add_option(kViewerOption, choice.viewers,
                  "The eye for --cutaway and --seen-opacity, in display radii: 0,0,10 by default. May be given several "
                  "times: what one of the eyes sees is shown")
      ->type_name("X,Y,Z")
      ->allow_extra_args(false);
}

void refuseVolumeSlicingOptions(const VolumeSlicingChoice& choice) {
  refuseVolumeOption(!choice.mask.empty(), kMaskOption);
  refuseVolumeOption(choice.gain != 1, kGainOption);
  refuseVolumeOption(choice.fullLightGradient != 0, kGradientOption);
  refuseVolumeOption(choice.cutaway.has_value(), kCutawayOption);
  refuseVolumeOption(choice.seenOpacity.has_value(), kSeenOption);
  refuseVolumeOption(!choice.viewers.empty(), kViewerOption);
}

SliceOptions volumeSliceOptionsOf(const SlicingChoice& slicing) {
  if (slicing.exact) {
    throw InputError("this is a volume, whose voxels are averages in any case", "--exact", "leave it out");
  }
  const SliceOptions options = sliceOptionsOf(slicing);
  if (const char* unfit = unfitForVolumes(options)) {
    throw InputError(
        "this is a volume, whose voxels are averages in any case, and as bright near the axis as elsewhere", unfit,
        "leave it out");
  }
  return options;
}

std::vector<glm::vec3> viewersOf(const VolumeSlicingChoice& choice) {
  if (choice.viewers.empty()) {
    return {glm::vec3(0, 0, kDefaultEyeDistance)};
  }
  std::vector<glm::vec3> eyes;
  for (const std::string& text : choice.viewers) {
    eyes.push_back(pointFromText(text, kViewerOption));
  }
  return eyes;
}

ShownVolumeOptions shownVolumeOptionsOf(const VolumeToShow& choice, const VolumeScene& scene,
                                        const CommandContext& context) {
  const VolumeSlicingChoice& slicing = choice.slicing;
  if (!slicing.viewers.empty() && !slicing.cutaway && !slicing.seenOpacity) {
    throw InputError("a viewer changes nothing by itself", kViewerOption, "add --seen-opacity 0.5 or --cutaway 0");
  }
  ShownVolumeOptions options;
  options.sampling.fullLightGradient = slicing.fullLightGradient;
  options.light.gain = slicing.gain;
  options.surface = choice.scene.options.iso;
  if (!choice.laterTransfer.empty()) {
    options.sampling.toldApart = valuesOfChange(
        appearanceOf(transferByName(choice.laterTransfer), *scene.volume, scene.voxelSpacing()).transfer);
  }
  if (slicing.cutaway || slicing.seenOpacity) {
    options.eyes = viewersOf(slicing);
    options.cutaway = slicing.cutaway;
    options.seenOpacity = slicing.seenOpacity;
  }
  if (slicing.mask.empty()) {
    return options;
  }
  if (isVolumeSource(slicing.mask)) {
    // Nobody sees its colours: any absolute ones will do, which a mask of one value has too.
    VolumeScene mask = loadVolumeScene(
        slicing.mask, {.fit = false, .transfer = "ct-bone", .warn = choice.scene.options.warn}, context.progress());
    options.mask = std::make_shared<const VolumeScene>(placedMask(std::move(mask), scene));
  } else {
    if (slicing.mask.find(':') == std::string::npos) {
      throw InputError("\"" + slicing.mask + "\" is neither a volume nor a range of values", kMaskOption,
                       std::string(kMaskOption) + " 300:2000, or a file of a volume");
    }
    const glm::dvec2 shown = rangeFromText(slicing.mask, kMaskOption);
    if (options.surface) {
      throw InputError("a surface has one value alone", kMaskOption, "leave it out, or give a volume as the mask");
    }
    options.light.shown = ValueRange{shown.x, shown.y};
  }
  return options;
}

ShownVolume loadShownVolume(const VolumeToShow& choice, const DisplayProfile& profile, const CommandContext& context) {
  VolumeScene scene = loadVolume(choice.scene, choice.volume, context);
  const ShownVolumeOptions options = shownVolumeOptionsOf(choice, scene, context);
  if (options.surface) {
    requireSurface(scene, *options.surface, choice.scene.source);
  }
  ShownVolume shown(std::move(scene), profile, options, context.progress());
  noteFewSteps(shown, context);
  return shown;
}

ShownSeries loadShownSeries(const VolumeToShow& choice, const DisplayProfile& profile, const CommandContext& context) {
  ShownSeries shown;
  if (choice.scene.options.motion.seconds) {
    shown.volumes.push_back(std::make_unique<ShownVolume>(loadShownVolume(choice, profile, context)));
    return shown;
  }
  VolumeSeries series = loadVolumeSeries(choice.scene.source, choice.scene.options.series, context.progress());
  VolumeSceneOptions options = volumeSceneOptionsOf(choice.scene, choice.volume);
  ShownVolumeOptions shownOptions;  // of all moments, which have one grid
  size_t bytes = 0;
  for (size_t i = 0; i < series.volumes.size(); ++i) {
    VolumeScene scene = volumeSceneAt(series, i, options, context.progress());
    applyShading(choice.scene, scene);
    if (i == 0) {
      shownOptions = shownVolumeOptionsOf(choice, scene, context);
      // All moments look as the first tells, and what is said of it is said of the series.
      series.appearance = scene.appearance;
      options.transfer.clear();
      options.warn = {};
    }
    if (series.volumes.size() == 1 && shownOptions.surface) {
      requireSurface(scene, *shownOptions.surface, series.source);
    }
    shown.volumes.push_back(std::make_unique<ShownVolume>(std::move(scene), profile, shownOptions, context.progress()));
    bytes += shown.volumes.back()->samples().bytes();
    if (bytes > kMaxSeriesBytes && series.volumes.size() > 1) {
      throw InputError(fmt::format("{} of {} moments of this series fill {} GiB of memory for the display", i + 1,
                                   series.volumes.size(), kMaxSeriesBytes >> 30),
                       choice.scene.source, "--time SECONDS for one moment, or a display with fewer voxels");
    }
  }
  noteFewSteps(*shown.volumes.front(), context);
  if (series.volumes.size() > 1) {
    shown.times = series.times;
  }
  return shown;
}

}  // namespace ocelli
