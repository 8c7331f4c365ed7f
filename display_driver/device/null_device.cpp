#include "display_driver/device/null_device.h"

#include "display_driver/device/ideal_device.h"

namespace ocelli {

std::unique_ptr<Device> openNullDevice(const DisplayProfile& profile) {
  const DeviceInfo info{.kind = "null", .name = "nothing", .serial = "", .link = "none"};
  return std::make_unique<IdealDevice>(info, profile, nullptr);
}

}  // namespace ocelli
