#include "display_driver/wire/stream_device.h"

#include "display_driver/wire/streaming_device.h"
#include "oc_core/base/error.h"

namespace ocelli {

std::unique_ptr<Device> openStreamDevice(std::unique_ptr<wire::LinkPort> port, const StreamOptions& options) {
  const std::string where = port->description();
  try {
    return std::make_unique<StreamingDevice>(std::move(port), options);
  } catch (const wire::LinkError& error) {
    const bool none = error.status() == wire::LinkStatus::kGone;
    throw WorkError(
        error.what(), where,
        none ? "connect the display and switch it on; `ocelli device list` shows what is found"
             : "see `ocelli device list`; close other programs that use it, or unplug it and plug it in again");
  }
}

}  // namespace ocelli
