// Where the volumes come from that are presented (pacer.h).
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "display_driver/device/device.h"
#include "display_sim/frames/volume.h"

namespace ocelli {

struct SourcedVolume {
  enum class Kind {
    kNew,
    kSame,  ///< as the last one: there is nothing to present
    kEnd,   ///< there will be no more
  };
  Kind kind = Kind::kEnd;
  std::shared_ptr<const Volume> volume{};  ///< of kNew
  /// Slices in which it may differ from the last new one; nullopt: all.
  std::optional<std::vector<int>> changed{};
};

class VolumeSource {
 public:
  virtual ~VolumeSource() = default;
  /// The volume that is right for the time at which it will be seen: as that time is foreseen now, and later with each
  /// call. May take long; takes about as long each time, best.
  virtual SourcedVolume volumeFor(HostTime seen) = 0;
};

}  // namespace ocelli
