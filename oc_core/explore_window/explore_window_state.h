// What the window of `ocelli explore` remembers besides what explores: what shows, and what the user is at.
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <set>
#include <string>

namespace ocelli {

struct ExploreWindowState {
  std::set<std::string, std::less<>> shown{"plan"};  ///< names of explorePanes()
  std::string active = "view";                       ///< the pane that has the keyboard before the window has
  bool borders = true;                               ///< tinted borders around what bends
  bool help = false;
  bool form = false;           ///< the options of the constructor
  size_t formRow = 0;          ///< that the arrows change
  bool captured = false;       ///< the mouse looks around
  glm::vec2 turnedDegrees{0};  ///< by the pointer, to the right and up, since the last frame
  double hintSeconds = 0;      ///< that the hint of the first run has been there
  float planZoom = 1;          ///< how much larger than the whole scene
  bool recording = false;

  std::string message;  ///< what has just happened
  bool messageIsError = false;
  double messageSeconds = 0;  ///< left to show it; errors stay until Escape
};

}  // namespace ocelli
