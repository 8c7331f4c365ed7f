// What a run was made with, for the database: computer, graphics, screen, and how times are taken.
#pragma once

#include <string>

#include "oc_core/gl/gl_context.h"
#include "oc_core/window/monitors.h"
#include "study/protocol/protocol.h"
#include "study/screen/calibration.h"

namespace ocelli {

struct RunEnvironment {
  std::string programVersion;
  GlInfo graphics;
  Monitor monitor;
  int monitorNumber = 0;
  bool fullScreen = true;
  int windowWidth = 0;  ///< pixels
  int windowHeight = 0;
  ScreenGeometry screen{};          ///< as the protocol states it
  ScreenCalibration calibration{};  ///< empty where the protocol wants none
  double pacedHertz = 0;  ///< frames that do not wait for the screen are held back to this rate; 0 where they wait
};

/// Names and versions that the system tells are added here.
std::string jsonText(const RunEnvironment& environment);

}  // namespace ocelli
