// The window of `ocelli explore`: its options, and how it is opened or played a script.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "cli/command.h"
#include "oc_core/explore/explore_offscreen.h"

namespace ocelli {

struct ExploreWindowChoice {
  bool window = false;  ///< with a script
  double scale = 1;
  std::string gl = "auto";
  std::string video;
};

/// What the window shares with sessions without one.
struct ExploreWindowWhat {
  std::string source;
  std::function<std::shared_ptr<ExploreScene>(const Progress& progress)> read;
  ExploreOffscreenOptions options;  ///< explorer, start, camera, folder, record, wrote, measureTimes
};

/// Adds --window, --scale, --gl and --record.
void addExploreWindowOptions(CLI::App& command, ExploreWindowChoice& choice);

/// Throws InputError for options that mean nothing together: `plays` a script, `measures` what only sessions without a
/// window do.
void checkExploreWindow(const ExploreWindowChoice& choice, bool plays, bool measures);

/// Until the user closes it. Throws InputError where this program was built without OpenGL, here and below.
void exploreInWindow(const ExploreWindowChoice& choice, const ExploreWindowWhat& what);
/// Prints times where they are measured.
void playScriptInWindow(const ExploreWindowChoice& choice, const ExploreWindowWhat& what, const ExploreScript& script,
                        const CommandContext& context);

}  // namespace ocelli
