#include "display_driver/selftest/pattern_figures.h"

#include <fmt/format.h>

#include "display_driver/selftest/pattern_canvas.h"
#include "display_driver/selftest/pattern_volumes.h"

namespace ocelli {
namespace {

double millimetres(const DisplayProfile& profile, double radii) {
  return 1000 * profile.radiusMetres * radii;
}

double degreesPerSlice(const DisplayProfile& profile) {
  return 180.0 / profile.slicesPerHalfTurn;
}

double microsecondsPerSlice(const DisplayProfile& profile) {
  return 1e6 * 60 / profile.rotationsPerMinute / (2.0 * profile.slicesPerHalfTurn);
}

double columnMillimetres(const DisplayProfile& profile) {
  return millimetres(profile, 2.0 / profile.width);
}

double rowMillimetres(const DisplayProfile& profile) {
  return millimetres(profile, 2 * profile.halfHeightRadii / profile.height);
}

}  // namespace

std::vector<std::string> noFigures(const DisplayProfile&) {
  return {};
}

std::vector<std::string> darkFigures(const DisplayProfile& profile) {
  return {
      fmt::format("A ring's column is its distance from the axis divided by {:.3g} mm; its row, from the top, is its "
                  "distance from the top divided by {:.3g} mm.",
                  columnMillimetres(profile), rowMillimetres(profile))};
}

std::vector<std::string> axisFigures(const DisplayProfile& profile) {
  const PatternGrid grid(profile);
  std::string diameters;
  for (const double radius : {0.25, 0.5, 0.75, 1.0}) {
    diameters += fmt::format("{}{:.4g}", diameters.empty() ? "" : ", ",
                             millimetres(profile, 2 * grid.radiusOf(grid.ringAt(radius))));
  }
  return {fmt::format("Diameters of the rings on the equator: {} mm.", diameters),
          fmt::format(
              "A column is {:.3g} mm wide: two circles of a ring that are {:.3g} mm apart stand for an offset of one "
              "column.",
              columnMillimetres(profile), 2 * columnMillimetres(profile))};
}

std::vector<std::string> phaseFigures(const DisplayProfile& profile) {
  return {
      fmt::format("A slice is {:.3g} degrees wide, {:.3g} mm at the rim, and lasts {:.3g} microseconds at {:g} rpm.",
                  degreesPerSlice(profile), millimetres(profile, degreesPerSlice(profile) * 3.14159265 / 180),
                  microsecondsPerSlice(profile), profile.rotationsPerMinute),
      "The scale reaches ten slices to either side; the ticks in between are two slices apart."};
}

std::vector<std::string> wedgesFigures(const DisplayProfile& profile) {
  std::string widths;
  for (const int width : wedgeWidths(profile)) {
    widths += fmt::format("{}{}", widths.empty() ? "" : ", ", width);
  }
  return {fmt::format("Widths of the wedges from the outermost ring inwards: {} slices, of {} around the display.",
                      widths, 2 * profile.slicesPerHalfTurn)};
}

std::vector<std::string> stairsFigures(const DisplayProfile& profile) {
  const int steps = 2 * profile.slicesPerHalfTurn;
  const int stepRows = (profile.height + steps - 1) / steps;
  const double rise = rowMillimetres(profile) * (profile.height - stepRows) / (steps - 1);
  std::string text =
      fmt::format("{} steps. One that is h mm above the lowest is step h / {:.3g}, and step i is slice i", steps, rise);
  if (profile.secondHalfTurn == SecondHalfTurn::kMirrored) {
    text += fmt::format(", or the left half of slice i - {} where that is not below 0", profile.slicesPerHalfTurn);
  }
  return {text + "."};
}

std::vector<std::string> boxFigures(const DisplayProfile& profile) {
  const BoxSides sides = boxSides(profile);
  return {fmt::format("Sides: {:.4g} mm across and {:.4g} mm up, each less a voxel at the most.",
                      millimetres(profile, 2 * sides.across), millimetres(profile, 2 * sides.up))};
}

std::vector<std::string> sphereFigures(const DisplayProfile& profile) {
  return {fmt::format("Diameter: {:.4g} mm.", millimetres(profile, 2 * sphereRadius(profile)))};
}

std::vector<std::string> focusFigures(const DisplayProfile& profile) {
  return {fmt::format("Single lines: {:.3g} line pairs a mm across, {:.3g} up.", 1 / (2 * columnMillimetres(profile)),
                      1 / (2 * rowMillimetres(profile)))};
}

std::vector<std::string> coloursFigures(const DisplayProfile& profile) {
  std::string levels;
  for (const int level : colourSteps(profile)) {
    levels += fmt::format("{}{}", levels.empty() ? "" : ", ", level);
  }
  const std::string timing =
      profile.channelTiming == ChannelTiming::kTogether
          ? "Red, green and blue of this display are on together: single slices have no coloured edges."
          : fmt::format(
                "Red, green and blue of this display are on in turns: seen from above, single slices are red, green "
                "and blue side by side, clockwise, {:.3g} degrees each.",
                degreesPerSlice(profile) / 3);
  return {fmt::format("Levels of the steps, from the top of a band: {} of {}.", levels,
                      (1 << profile.colorBitsPerChannel) - 1),
          timing};
}

std::vector<std::string> brightnessFigures(const DisplayProfile& profile) {
  const PatternGrid grid(profile);
  const std::vector<BrightnessRing> rings = brightnessRings(profile);
  const double outermost = grid.radiusOf(rings.back().ring);
  std::string upper;
  for (const BrightnessRing& ring : rings) {
    const double radius = grid.radiusOf(ring.ring);
    if (radius == 0) {
      continue;
    }
    upper += fmt::format("{}{:.3g} at {:.3g} mm", upper.empty() ? "" : ", ", outermost / radius,
                         millimetres(profile, radius));
  }
  return {"Brightness of the upper rings, the outermost being 1: " + upper + "."};
}

std::vector<std::string> whiteFigures(const DisplayProfile& profile) {
  return {fmt::format("{} slices of {} x {} voxels, all channels at level {}.", profile.storedSlices(), profile.width,
                      profile.height, (1 << profile.colorBitsPerChannel) - 1)};
}

}  // namespace ocelli
