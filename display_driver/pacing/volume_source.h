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
  /// Pixels of what it was made of, each way, for each that were asked for: below 1 where time ran short.
  float imageScale = 1;
};

/// Makes volumes beside the caller, more than one at a time. Called from one thread.
class VolumeLine {
 public:
  virtual ~VolumeLine() = default;
  /// Whether another one may begin now.
  virtual bool ready() const = 0;
  /// Begins to make what volumeFor() makes. Only where ready() holds.
  virtual void begin(HostTime seen) = 0;
  /// The next of those that were begun, in their order; nothing while it is not finished. Throws what its making threw.
  virtual std::optional<SourcedVolume> finished() = 0;
};

class VolumeSource {
 public:
  virtual ~VolumeSource() = default;
  /// The volume that is right for the time at which it will be seen: as that time is foreseen now, and later with each
  /// call. May take long; takes about as long each time, best.
  virtual SourcedVolume volumeFor(HostTime seen) = 0;
  /// How to make them beside the caller; nullptr where volumeFor() is the only way. A caller keeps to one of the two.
  virtual VolumeLine* line() { return nullptr; }
};

}  // namespace ocelli
