// The options of commands that take several viewers around a display.
#pragma once

#include <string>
#include <vector>

#include "oc_core/camera/view.h"

namespace CLI {
class App;
}

namespace ocelli {

struct ViewersChoice {
  int count = 0;                   ///< 0: as many as there are views, one at least
  std::vector<std::string> views;  ///< files
};

inline constexpr int kMaxViewers = 12;

/// Adds --viewers N, and --view FILE.json, which may be given several times.
void addViewersOptions(CLI::App& command, ViewersChoice& choice);
/// A view for each viewer: those of the files, or one turned about the axis; the default view where none is given.
/// Throws InputError.
std::vector<View> viewsOf(const ViewersChoice& choice);
/// The same for a camera: that of a ray map is one viewer's (cameraView()).
std::vector<View> viewsFor(const std::string& camera, const ViewersChoice& choice);

}  // namespace ocelli
