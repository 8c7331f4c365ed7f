// A display that shows flat pictures, such as the quilts of light-field displays: the counterpart of Device
// (display_driver/device/device.h), which shows volumes.
//
// Recipe for a new picture device:
//   1. display_driver/picture_device/NAME_device.h and .cpp: a class that implements PictureDevice, and a function that
//      opens it.
//   2. display_driver/picture_device/picture_devices.cpp: one line with its name, what follows the name, what it is,
//      and the function.
// From outside of the tree: registerPictureDevice() with the same line.
// `ocelli present --device NAME` and `ocelli device list` find it there.
#pragma once

#include <string>

#include "display_sim/quilt/quilt_display.h"
#include "oc_core/image/png_file.h"

namespace ocelli {

/// Called by one thread: the main one, for devices that have a window.
class PictureDevice {
 public:
  virtual ~PictureDevice() = default;

  /// What it shows, and from how far apart: pictures are quilts of this display.
  virtual const QuiltDisplay& display() const = 0;
  /// For people: "a window on monitor 1, 1536x2048".
  virtual std::string description() const = 0;
  /// Shows a quilt until the next one: sRGB, as large as display() says. Throws WorkError, or GlError, where that
  /// fails.
  virtual void show(const Image<Rgb8>& quilt) = 0;
  /// Handles input for `seconds`, or less. False once a person has closed the device.
  virtual bool wait(double seconds) = 0;
};

}  // namespace ocelli
