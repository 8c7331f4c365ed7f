// What the window of `ocelli explore` remembers besides what explores: what shows, and what the user is at.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <set>
#include <string>

namespace ocelli {

/// How much larger than the whole scene a plan can be.
inline constexpr float kMaxPlanZoom = 32;

struct ExploreWindowState {
  /// Shows what a window shows at first: explorePanes() says what.
  ExploreWindowState();

  std::set<std::string, std::less<>> shown;   ///< names of explorePanes(), beside the large one
  std::set<std::string, std::less<>> hidden;  ///< by a pane that needs their room
  std::string active;                         ///< the pane that has the keyboard before the window has
  bool borders = true;                        ///< tinted borders around what bends
  bool help = false;
  bool form = false;           ///< the options of the constructor
  size_t formRow = 0;          ///< that the arrows change
  bool captured = false;       ///< the mouse looks around
  glm::vec2 turnedDegrees{0};  ///< by the pointer, to the right and up, since the last frame
  double hintSeconds = 0;      ///< that the hint of the first run has been there
  float planZoom = 1;          ///< how much larger than the whole scene, to kMaxPlanZoom
  bool recording = false;
  enum class DrawAnew : uint8_t { kGraph, kCurved };
  std::optional<DrawAnew> drawAnew;         ///< a camera to be drawn by hand is begun, from where the walker is
  std::optional<std::string> cameraToSave;  ///< the text of a file that the window is to save

  std::string message;  ///< what has just happened
  bool messageIsError = false;
  double messageSeconds = 0;  ///< left to show it; errors stay until Escape
};

}  // namespace ocelli
