// Which panes of the window show and which one has the keyboard, as the rows of explorePanes() say. Names are those of
// the rows.
#pragma once

#include <set>
#include <string>
#include <string_view>

#include "oc_core/explore_window/explore_window_state.h"

namespace ocelli {

/// The large one, which always shows.
std::string mainExplorePane();
/// Those that show when a window opens, without the large one.
std::set<std::string, std::less<>> firstExplorePanes();

/// Shows it. One that takes keys gets them; one that needs the room hides the others meanwhile.
void showExplorePane(ExploreWindowState& state, std::string_view name);
/// Hides it. What it hid shows again, and the large one gets the keys that it had.
void hideExplorePane(ExploreWindowState& state, std::string_view name);
void toggleExplorePane(ExploreWindowState& state, std::string_view name);
/// Gives the keys to the next of those that show and take any.
void activateNextExplorePane(ExploreWindowState& state);

}  // namespace ocelli
