// Which image serves what a client looks at best (section 5.2.1.2): that of a general pinhole with the client's eye and
// direction, wider than its screen so that the view may turn, with more samples in the middle, where a zoom is
// expected, and where the client's lenses are.
#pragma once

#include "oc_core/camera/gpc_layout.h"
#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/remote/remote_request.h"
#include "oc_core/remote/remote_settings.h"

namespace ocelli {

struct RemotePlan {
  PinholeCamera reference;
  GpcLayout layout;  ///< valid; without regions where all samples lie alike

  bool operator==(const RemotePlan&) const = default;
};

/// Throws InputError where the request or the settings are not valid. The image is smaller than asked for where it
/// would have more than kMaxCodedPixels, and less wide where it would look farther to the side than 80 degrees.
RemotePlan planRemoteImage(const RemoteRequest& request, const RemoteSettings& settings);

}  // namespace ocelli
