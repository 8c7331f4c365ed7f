// A path played as a stream of video: each view is drawn and encoded when it has reached the server, and sent when all
// before it has been.
#pragma once

#include <span>

#include "oc_core/remote_measure/playback.h"
#include "oc_core/remote_measure/virtual_link.h"

namespace ocelli {

/// `frameBytes` is one number for each frame of the path. `serverSeconds` passes between a view that comes and its
/// frame that goes; the server is as fast as frames come, whatever that takes.
Playback playStream(const RemotePath& path, const LinkSpeed& speed, std::span<const size_t> frameBytes,
                    double serverSeconds);

/// What an encoder may take of a link, bytes a second: the rest is for the headers of so many messages, and 5 % for
/// what the control of its rate misses by. At least a tenth of the link.
double streamBytesPerSecond(const LinkSpeed& speed, double framesPerSecond);

}  // namespace ocelli
