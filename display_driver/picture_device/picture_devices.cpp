#include "display_driver/picture_device/picture_devices.h"

#include <algorithm>

#include "display_driver/picture_device/quilt_device.h"
#include "oc_core/base/error.h"

namespace ocelli {
namespace {

std::vector<PictureDeviceKind> builtinPictureDevices() {
  return {
      {"quilt", quiltWindowUsage(), "a light-field display: its picture over the whole of a monitor",
       [](const std::string& rest) { return openQuiltWindow(quiltWindowOptionsFromText(rest)); }},
  };
}

Registry<PictureDeviceKind>& pictureDeviceRegistry() {
  static Registry<PictureDeviceKind> registry("picture device", builtinPictureDevices());
  return registry;
}

std::string kindOf(const std::string& text) {
  return text.substr(0, text.find(':'));
}

}  // namespace

Rows<PictureDeviceKind> pictureDeviceKinds() {
  return pictureDeviceRegistry().rows();
}

void registerPictureDevice(PictureDeviceKind kind) {
  if (kind.name.empty() || kind.name.find(':') != std::string::npos) {
    throw InputError("a device cannot have this name", "\"" + kind.name + "\"", "give it a name without a colon");
  }
  if (!kind.open) {
    throw InputError("this device has no function that opens it", kind.name, "set `open` of its row");
  }
  pictureDeviceRegistry().add(std::move(kind));
}

bool isPictureDevice(const std::string& text) {
  return std::ranges::any_of(pictureDeviceKinds(),
                             [&](const PictureDeviceKind& kind) { return kind.name == kindOf(text); });
}

std::unique_ptr<PictureDevice> openPictureDevice(const std::string& text) {
  for (const PictureDeviceKind& kind : pictureDeviceKinds()) {
    if (kind.name == kindOf(text)) {
      return kind.open(text.size() > kind.name.size() ? text.substr(kind.name.size() + 1) : "");
    }
  }
  throw InputError("there is no such picture device", text, "see with ocelli device list");
}

}  // namespace ocelli
