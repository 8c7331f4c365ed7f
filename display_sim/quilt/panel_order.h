// What the panel of a light-field display shows: a lens sheet lies on it at an angle, so each red, green and blue dot
// (subpixel) is seen from another direction. Which view a dot belongs to follows from the display's calibration:
//
//   view = 1 - fract((x + i / (3 W) + y H / (W slope)) pitch W / DPI cos(atan(1 / slope)) - center)
//
// as a share of all views, with x, y from 0 to 1 (y upwards), i = 0, 1, 2 for red, green and blue, and a panel of W x H
// pixels. Source: the open library of the maker, Looking-Glass/looking-glass-webxr on GitHub, whose LookingGlassConfig
// works out `pitch`, `tilt` and `subp` of its shader in this way.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "display_sim/quilt/quilt_display.h"
#include "oc_core/image/png_file.h"

namespace ocelli {

struct PanelCalibration {
  double pitch = 0;  ///< lenses for each inch
  double slope = 0;  ///< of the lenses: rise over run
  double center = 0;
  double dotsPerInch = 0;
  int width = 0;  ///< of the panel, pixels
  int height = 0;
  std::optional<double> coneDegrees{};  ///< `viewCone`
  /// Fields of the file that ask for what is not done here (flipped panels, views in the other order), with their
  /// values.
  std::vector<std::string> unused{};
};

/// The file that a display has on it: fields pitch, slope, center, DPI, screenW, screenH and viewCone, each a number or
/// an object with a "value". Others are the display's own. Throws InputError.
PanelCalibration calibrationFromJsonText(const std::string& text, const std::string& where);
PanelCalibration readCalibration(const std::filesystem::path& path);

/// The display with the cone of its calibration, or with `coneDegrees` where that is given: it goes before the
/// calibration's. Without either the display is as it was. Throws InputError as validate() does.
QuiltDisplay withCone(QuiltDisplay display, const std::optional<PanelCalibration>& calibration,
                      std::optional<double> coneDegrees);

/// In [0, 1]. `x` and `y` as above, `channel` 0, 1, 2.
double viewShareOf(const PanelCalibration& panel, double x, double y, int channel);

/// The image to show on the panel, pixel for pixel, sRGB: each dot from the tile of its view, interpolated bilinearly.
/// `quilt` is as large as `display` says.
Image<Rgb8> panelPicture(const Image<Rgb8>& quilt, const QuiltDisplay& display, const PanelCalibration& panel);

}  // namespace ocelli
