// What hears of the frames that an emulated display gets and shows.
#pragma once

#include <cstdint>
#include <vector>

#include "display_driver/firmware/rotor.h"
#include "display_sim/frames/volume.h"

namespace ocelli {

/// One turn of the screen, or half of one, from slice 0 on.
struct ShownRefresh {
  uint64_t refresh = 0;
  DeviceMicroseconds begin = 0;
  DeviceMicroseconds length = 0;
  double phaseErrorDegrees = 0;
  struct Part {
    int fromSlice = 0;
    uint32_t frame = 0;  ///< 0: dark
    bool coarse = false;
  };
  std::vector<Part> parts;  ///< one, or more where frames changed in between: then it was torn
};

class RefreshSink {
 public:
  virtual ~RefreshSink() = default;
  /// `volume` is what the screen showed, slice by slice.
  virtual void refreshEnded(const ShownRefresh& refresh, const Volume& volume) = 0;
};

class ArrivalSink {
 public:
  virtual ~ArrivalSink() = default;
  /// Of an acknowledged frame.
  virtual void frameArrived(uint32_t session, uint32_t frame, const Volume& volume) = 0;
};

}  // namespace ocelli
