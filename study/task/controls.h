// How a subject moves: keys, speeds, and what the mouse does. From the protocol, field "controls".
#pragma once

#include "oc_core/base/input_event.h"

namespace ocelli {

class JsonFields;

struct Controls {
  // Keys by their place on a US keyboard. Those of the arrows always work as well as these.
  Key forward = Key::kW;
  Key backward = Key::kS;
  Key left = Key::kA;  ///< a step to the side
  Key right = Key::kD;
  Key turnLeft = Key::kQ;  ///< also the left arrow
  Key turnRight = Key::kE;
  Key select = Key::kSpace;  ///< what is under the pointer, as a click of the left button does

  double walkMetersPerSecond = 3;
  double turnDegreesPerSecond = 90;
  double mouseDegreesPerPixel = 0.15;   ///< while the right button is held; pixels of the screen
  double pointerPixelsPerSecond = 600;  ///< of the pointer, moved by Shift and the arrows
  double eyeHeightMeters = 1.6;
  double bodyRadiusMeters = 0.4;  ///< how near to walls one comes
};

/// Throws InputError naming the field.
Controls readControls(JsonFields& fields);

}  // namespace ocelli
