#include "cli/observer_choice.h"

#include <CLI/CLI.hpp>

#include "cli/values.h"
#include "oc_core/base/error.h"

namespace ocelli {
namespace {

void addView(CLI::App& command, ObserverChoice& choice) {
  command
      .add_option("--eye", choice.eye,
                  "Where the eye is, in display radii; by default in front, at the display's viewing distance")
      ->type_name("X,Y,Z");
  command.add_option("--size", choice.size, "Of the image, in pixels")->type_name("WIDTHxHEIGHT");
  command.add_option("--fov", choice.fovVerticalDegrees, "Vertical field of view; 0 just holds the unit sphere")
      ->type_name("DEGREES");
  command.add_option("--aperture", choice.apertureMetres, "Width of the pupil or lens; 0: everything is sharp")
      ->type_name("METRES");
  command
      .add_option("--focus", choice.focusMetres,
                  "What distance from the eye is sharp, along its view direction; 0: the display's middle")
      ->type_name("METRES");
}

void addExposure(CLI::App& command, ObserverChoice& choice) {
  command.add_option("--exposure", choice.exposure, "Seconds; by default one refresh of the display")
      ->type_name("SECONDS");
  CLI::Option* sector =
      command
          .add_option("--missing-sector", choice.missingSectorDegrees,
                      "Screen angle where an exposure ends, and where a shorter one than a refresh misses a sector")
          ->type_name("DEGREES");
  command.add_option("--start", choice.start, "Screen angle where the exposure starts, instead")
      ->type_name("DEGREES")
      ->excludes(sector);
}

void addDisplay(CLI::App& command, ObserverChoice& choice) {
  command
      .add_option("--emission", choice.emission,
                  "screen: voxels are patches of a diffuse screen; even: they emit evenly into all directions")
      ->check(CLI::IsMember({"screen", "even"}))
      ->type_name("screen|even");
  command.add_option("--transmission", choice.transmission, "Light of the screen's back relative to that of its front")
      ->type_name("RATIO");
  command.add_option("--wobble", choice.wobbleMetres, "How far the axis swings to either side")->type_name("METRES");
  command.add_option("--wobble-direction", choice.wobbleDirection, "Where to it swings")->type_name("X,Y,Z");
  command.add_option("--wobble-frequency", choice.wobbleFrequency, "Swings in a turn of the screen")
      ->type_name("NUMBER");
  command.add_option("--wobble-phase", choice.wobblePhaseDegrees, "Of the swing, where the screen's angle is 0")
      ->type_name("DEGREES");
  command.add_option("--dead-zone", choice.deadZoneMetres, "Nothing is lit within this distance from the axis")
      ->type_name("METRES");
  command
      .add_option("--ambient", choice.ambient,
                  "Light of the room that the screen scatters, relative to that of a white screen")
      ->type_name("RATIO");
}

void addTone(CLI::App& command, ObserverChoice& choice) {
  command.add_option("--gain", choice.gain, "Factor on the light; 0 chooses one for the image")->type_name("FACTOR");
  command.add_option("--tone", choice.tone, "What becomes of light above white")
      ->check(CLI::IsMember({"clip", "reinhard", "filmic"}))
      ->type_name("clip|reinhard|filmic");
  command.add_option("--gamma", choice.gamma, "Exponent 1/GAMMA on the light")->type_name("GAMMA");
}

glm::vec3 defaultEye(const DisplayProfile& profile) {
  return {0, 0, static_cast<float>(profile.viewingDistanceRadii())};
}

ToneCurve toneCurve(const std::string& name) {
  return name == "reinhard" ? ToneCurve::kReinhard : name == "filmic" ? ToneCurve::kFilmic : ToneCurve::kClip;
}

}  // namespace

void addObserverOptions(CLI::App& command, ObserverChoice& choice) {
  addView(command, choice);
  addExposure(command, choice);
  addDisplay(command, choice);
  addTone(command, choice);
}

void checkDefaultEye(const DisplayProfile& profile) {
  if (isInDisplay(defaultEye(profile), profile)) {
    throw InputError("the eye is inside of the display", "viewing_distance_metres of profile " + profile.name,
                     "give --eye, or a viewing distance above radius_metres in the profile");
  }
}

ObserverOptions observerOptions(const ObserverChoice& choice, const DisplayProfile& profile) {
  const double metre = 1 / profile.radiusMetres;
  ObserverOptions options;
  options.eye = choice.eye.empty() ? defaultEye(profile) : pointFromText(choice.eye, "--eye");
  const ImageSize size = imageSizeFromText(choice.size, "--size");
  options.width = size.width;
  options.height = size.height;
  options.fovVerticalDegrees = choice.fovVerticalDegrees;
  if (choice.focusMetres != 0 && choice.apertureMetres == 0) {
    throw InputError("without a lens everything is sharp", "--focus", "leave it out, or add --aperture 0.004");
  }
  options.lens = {choice.apertureMetres * metre, choice.focusMetres * metre};
  if (!choice.exposure.empty()) {
    options.exposureSeconds = ratioFromText(choice.exposure, "--exposure");
  }
  options.missingSectorStartDegrees = choice.missingSectorDegrees;
  if (!choice.start.empty()) {
    options.startDegrees = ratioFromText(choice.start, "--start");
  }
  options.emission = {choice.emission == "screen" ? EmissionModel::kScreen : EmissionModel::kEven, choice.transmission};
  options.wobble = {choice.wobbleMetres * metre, pointFromText(choice.wobbleDirection, "--wobble-direction"),
                    choice.wobbleFrequency, choice.wobblePhaseDegrees};
  options.deadZoneRadii = choice.deadZoneMetres * metre;
  options.ambient = choice.ambient;
  options.tone = {choice.gain, toneCurve(choice.tone), choice.gamma};
  return options;
}

}  // namespace ocelli
