#include "oc_core/explore_window/explore_pane_choice.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "oc_core/base/check.h"
#include "oc_core/explore_window/explore_pane.h"

namespace ocelli {
namespace {

const ExplorePaneKind& explorePaneKind(std::string_view name) {
  const auto kinds = explorePanes();
  const auto found = std::ranges::find_if(kinds, [&](const ExplorePaneKind& kind) { return name == kind.name; });
  OC_CHECK(found != kinds.end(), "there is a row for each pane");
  return *found;
}

}  // namespace

ExploreWindowState::ExploreWindowState() : shown(firstExplorePanes()), active(mainExplorePane()) {}

std::string mainExplorePane() {
  return explorePanes().front().name;
}

std::set<std::string, std::less<>> firstExplorePanes() {
  std::set<std::string, std::less<>> names;
  for (const ExplorePaneKind& kind : explorePanes().subspan(1)) {
    if (kind.showsAtFirst) {
      names.insert(kind.name);
    }
  }
  return names;
}

void showExplorePane(ExploreWindowState& state, std::string_view name) {
  const ExplorePaneKind& kind = explorePaneKind(name);
  if (kind.needsRoom && !state.shown.contains(name)) {
    state.hidden = std::exchange(state.shown, {});
  }
  state.shown.insert(kind.name);
  if (kind.takesKeys) {
    state.active = kind.name;
  }
}

void hideExplorePane(ExploreWindowState& state, std::string_view name) {
  const ExplorePaneKind& kind = explorePaneKind(name);
  if (state.shown.erase(kind.name) > 0 && kind.needsRoom) {
    state.shown.merge(std::exchange(state.hidden, {}));
  }
  if (state.active == kind.name) {
    state.active = mainExplorePane();
  }
}

void toggleExplorePane(ExploreWindowState& state, std::string_view name) {
  if (state.shown.contains(name)) {
    hideExplorePane(state, name);
  } else {
    showExplorePane(state, name);
  }
}

void activateNextExplorePane(ExploreWindowState& state) {
  std::vector<std::string> takers;
  for (const ExplorePaneKind& kind : explorePanes()) {
    if (kind.takesKeys && (&kind == &explorePanes().front() || state.shown.contains(kind.name))) {
      takers.emplace_back(kind.name);
    }
  }
  const auto now = std::ranges::find(takers, state.active);
  state.active = now == takers.end() || now + 1 == takers.end() ? takers.front() : *(now + 1);
}

}  // namespace ocelli
