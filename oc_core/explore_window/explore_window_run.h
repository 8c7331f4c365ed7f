// `ocelli explore` in a window of the screen.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "oc_core/explore_window/explore_recorder.h"
#include "oc_core/explore_window/explorer_window_model.h"

namespace ocelli {

struct ExploreWindowRunOptions {
  std::string title;  ///< "Ocelli: builtin:town"
  ExplorerWindowOptions model;
  std::filesystem::path folder = ".";  ///< for what is saved; it is made
  OpenExploreVideo record{};
  std::optional<std::filesystem::path> video{};  ///< records from the first image on
  std::function<void(const std::filesystem::path& path)> wrote{};
  std::function<bool()> goesOn{};  ///< asked again and again: false closes the window; empty: the user does
};

/// Until the user closes it. Throws WorkError where the folder cannot be made, GlError where there
/// is no display, and what the scene could not be read for.
void runExploreWindow(const ExploreWindowRunOptions& options);

}  // namespace ocelli
