#include "bench/volume_peer.h"

namespace ocelli {

std::vector<VolumePeer> volumePeers() {
  return {};
}

}  // namespace ocelli
