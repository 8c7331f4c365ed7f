// `--renderer` of the commands of `ocelli study` that draw what subjects saw.
#pragma once

#include <map>
#include <string>

#include "study/replay/trial_replay.h"

namespace CLI {
class App;
}

namespace ocelli {

/// Adds `--renderer raster|egl|osmesa`.
void addRendererOption(CLI::App& command, std::string& renderer);

/// What simulated subjects see by, for the thread that calls it. Throws InputError where this program was built without
/// OpenGL and it is asked for, GlError where there is none.
StudyRenderer studyRenderer(const std::string& renderer);

/// What draws the images whose hashes the database may hold, by the names that it has for them: what simulated
/// subjects see by, and the screen of people where the renderer is OpenGL. Any thread may call them.
std::map<std::string, ViewPainter> viewPainters(const std::string& renderer);

/// Whole frames, as the screen shows them; by the CPU plainly.
ViewPainter framePainter(const std::string& renderer);

struct ReplayWindowChoice {
  std::string title;
  double speed = 1;
};
/// Shows a trial in a window. Throws InputError where this program was built without OpenGL.
void showInWindow(const TaskBlock& block, const TrialLog& log, const Controls& controls,
                  const ReplayWindowChoice& choice);

}  // namespace ocelli
