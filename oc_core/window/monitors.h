// The screens that are attached, as GLFW tells of them.
#pragma once

#include <string>
#include <vector>

namespace ocelli {

struct Monitor {
  std::string name;
  int width = 0;  ///< of the mode that it is in, in pixels
  int height = 0;
  int refreshHertz = 0;  ///< rounded by the system; 0 where it does not say, as virtual screens do not
  int left = 0;          ///< of all screens together
  int top = 0;
  int widthMillimeters = 0;  ///< as the screen says; 0 where it does not
  int heightMillimeters = 0;
};

/// In the order of the system, the primary one first. On the main thread. Throws GlError where there is no display.
std::vector<Monitor> listMonitors();

/// Starts GLFW, which is left running: ending it would unload the graphics driver, which does not survive that. On the
/// main thread. Throws GlError where there is no display.
void initializeGlfw();
/// "3.3.8 X11 GLX EGL ...".
std::string windowSystemVersion();
/// What GLFW says of its last error, in parentheses, after a space; empty for none.
std::string lastGlfwError();

}  // namespace ocelli
