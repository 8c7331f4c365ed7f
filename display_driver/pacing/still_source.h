// One volume that stays.
#pragma once

#include "display_driver/pacing/volume_source.h"

namespace ocelli {

class StillSource final : public VolumeSource {
 public:
  explicit StillSource(Volume volume) : volume_(std::move(volume)) {}
  SourcedVolume volumeFor(HostTime) override {
    const bool first = !given_;
    given_ = true;
    return {.kind = first ? SourcedVolume::Kind::kNew : SourcedVolume::Kind::kSame, .volume = &volume_};
  }

 private:
  Volume volume_;
  bool given_ = false;
};

}  // namespace ocelli
