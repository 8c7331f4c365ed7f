// A light-field display that is attached as a monitor: a window over the whole of it. With the calibration of the
// display the window shows what its panel is to show, dot by dot; without, the quilt, which the display's own software
// may take from there.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "display_driver/picture_device/picture_device.h"
#include "display_sim/quilt/panel_order.h"

namespace ocelli {

struct QuiltWindowOptions {
  QuiltDisplay display;
  std::optional<int> monitor{};  ///< of listMonitors(); nothing: a window on the desktop, for a look
  std::optional<PanelCalibration> calibration{};
};

/// "NAME|FILE.json[,monitor=N][,calibration=FILE.json][,cone=DEGREES]".
std::string quiltWindowUsage();
/// From such a text. Throws InputError for a display, a key or a value that is wrong.
QuiltWindowOptions quiltWindowOptionsFromText(const std::string& text);

/// On the main thread. Throws InputError where there is no such monitor, GlError where no window can be opened.
std::unique_ptr<PictureDevice> openQuiltWindow(QuiltWindowOptions options);

}  // namespace ocelli
