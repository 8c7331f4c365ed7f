// One volume that stays.
#pragma once

#include "display_driver/pacing/volume_source.h"

namespace ocelli {

class StillSource final : public VolumeSource {
 public:
  explicit StillSource(Volume volume) : volume_(std::make_shared<const Volume>(std::move(volume))) {}
  SourcedVolume volumeFor(HostTime) override {
    const bool first = !given_;
    given_ = true;
    return {.kind = first ? SourcedVolume::Kind::kNew : SourcedVolume::Kind::kSame, .volume = volume_};
  }

 private:
  std::shared_ptr<const Volume> volume_;
  bool given_ = false;
};

}  // namespace ocelli
