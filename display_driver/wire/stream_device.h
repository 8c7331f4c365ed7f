// A display that speaks the wire protocol, at the other end of any link: codes volumes, keeps the link full, follows
// what becomes of each frame, and brings the stream back after whatever went wrong.
//
// Two frames are in the driver at a time: one is being sent, and the newest of the others waits. A frame that was begun
// is sent to its end; where the link is too slow, whole frames are dropped, the newest wins. After an error the stream
// goes on with the next whole frame; where there is none, the last one is sent again, so that a display that was
// unplugged shows it when it comes back.
#pragma once

#include <chrono>
#include <cstddef>
#include <memory>
#include <string>

#include "display_driver/device/device.h"
#include "display_driver/wire/link.h"

namespace ocelli {

struct StreamOptions {
  std::string kind;                        ///< of DeviceInfo
  size_t transferBytes = size_t{1} << 18;  ///< in one piece; frames end in a shorter one
  int transfersInFlight = 8;               ///< with these sizes, 50 ms of USB 2 at most
  std::chrono::milliseconds telemetryInterval{50};
  /// No byte has moved for so long: the link is set up anew.
  std::chrono::milliseconds stuckAfter{1000};
  /// Between attempts to connect: doubled from the first to the last. An arrival ends the wait.
  std::chrono::milliseconds firstBackOff{5};
  std::chrono::milliseconds lastBackOff{80};
};

/// Connects now. Throws WorkError where there is no device that the port finds, or it cannot be used.
std::unique_ptr<Device> openStreamDevice(std::unique_ptr<wire::LinkPort> port, const StreamOptions& options);

}  // namespace ocelli
