// Picture devices by name: "quilt:portrait,monitor=1".
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "display_driver/picture_device/picture_device.h"
#include "oc_core/base/registry.h"

namespace ocelli {

struct PictureDeviceKind {
  std::string name;
  std::string rest;  ///< what follows the name and a colon, for people
  std::string help;  ///< one line
  std::function<std::unique_ptr<PictureDevice>(const std::string& rest)> open;

  std::string usage() const { return name + ":" + rest; }
};

Rows<PictureDeviceKind> pictureDeviceKinds();
/// Throws InputError where the name is empty, is taken, or holds a colon, and where nothing opens it.
void registerPictureDevice(PictureDeviceKind kind);

/// Whether NAME:REST, or NAME, is one of these.
bool isPictureDevice(const std::string& text);
/// Throws InputError for other names and for what the kind says of the rest, GlError or WorkError where it cannot be
/// opened.
std::unique_ptr<PictureDevice> openPictureDevice(const std::string& text);

}  // namespace ocelli
