// What holds for every GuiWindow, to be asked of each.
#pragma once

#include <gtest/gtest.h>

#include <set>
#include <utility>

#include "oc_core/window/gui_window.h"

namespace ocelli::test {

/// As it shows on a screen: Dear ImGui knows the sizes of its windows from the frame before.
inline Image<Rgb8> drawn(GuiWindow& window) {
  window.draw();
  window.draw();
  return window.screenshot();
}

/// F11 fills the screen; H and F1 open the help; Escape closes it, and then the window, which must be one that closes
/// without a question.
inline void expectUsualKeys(GuiWindow& window) {
  const auto press = [&](Key key) {
    window.handle(KeyEvent{key, true, {}});
    window.handle(KeyEvent{key, false, {}});
  };
  press(Key::kF11);
  EXPECT_TRUE(window.takeFullscreenWish());
  EXPECT_FALSE(window.takeFullscreenWish());
  const Image<Rgb8> without = drawn(window);
  for (const Key key : {Key::kH, Key::kF1}) {
    press(key);
    EXPECT_NE(drawn(window), without);
    press(key);
    EXPECT_EQ(drawn(window), without);
  }
  press(Key::kH);
  press(Key::kEscape);
  EXPECT_FALSE(window.wantsClose());
  EXPECT_EQ(drawn(window), without);
  press(Key::kEscape);
  EXPECT_TRUE(window.wantsClose());
}

/// Of rows with the members `keys` and `shown`, and where there is one, `hasControl`.
template <class... Lists>
void expectNoKeyDoesTwoThings(const Lists&... lists) {
  std::set<std::pair<Key, bool>> taken;
  const auto take = [&](const auto& list) {
    for (const auto& row : list) {
      bool hasControl = false;
      if constexpr (requires { row.hasControl; }) {
        hasControl = row.hasControl;
      }
      for (const Key key : row.keys) {
        EXPECT_TRUE(taken.insert({key, hasControl}).second) << row.shown;
      }
    }
  };
  (take(lists), ...);
}

}  // namespace ocelli::test
