#include "oc_core/window/glfw_input.h"

#include <gtest/gtest.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <set>

namespace ocelli {
namespace {

TEST(GlfwInputTest, runsOfKeysKeepTheirOrder) {
  EXPECT_EQ(keyFromGlfw(GLFW_KEY_A), Key::kA);
  EXPECT_EQ(keyFromGlfw(GLFW_KEY_Q), Key::kQ);
  EXPECT_EQ(keyFromGlfw(GLFW_KEY_Z), Key::kZ);
  EXPECT_EQ(keyFromGlfw(GLFW_KEY_0), Key::k0);
  EXPECT_EQ(keyFromGlfw(GLFW_KEY_9), Key::k9);
  EXPECT_EQ(keyFromGlfw(GLFW_KEY_F1), Key::kF1);
  EXPECT_EQ(keyFromGlfw(GLFW_KEY_F12), Key::kF12);
}

TEST(GlfwInputTest, otherKeysGoByName) {
  EXPECT_EQ(keyFromGlfw(GLFW_KEY_PAGE_UP), Key::kPageUp);
  EXPECT_EQ(keyFromGlfw(GLFW_KEY_ESCAPE), Key::kEscape);
  EXPECT_EQ(keyFromGlfw(GLFW_KEY_SPACE), Key::kSpace);
  EXPECT_EQ(keyFromGlfw(GLFW_KEY_KP_ENTER), Key::kEnter);
}

TEST(GlfwInputTest, everyKeyCanBePressed) {
  std::set<Key> found;
  for (int key = 0; key <= GLFW_KEY_LAST; ++key) {
    if (const auto ours = keyFromGlfw(key)) {
      found.insert(*ours);
    }
  }
  EXPECT_EQ(found.size(), kKeyCount);
}

TEST(GlfwInputTest, keysThatNobodyUsesAreNone) {
  EXPECT_EQ(keyFromGlfw(GLFW_KEY_UNKNOWN), std::nullopt);
  EXPECT_EQ(keyFromGlfw(GLFW_KEY_LEFT_SHIFT), std::nullopt);
  EXPECT_EQ(keyFromGlfw(GLFW_KEY_F13), std::nullopt);
}

TEST(GlfwInputTest, buttonsAndModifiers) {
  EXPECT_EQ(pointerButtonFromGlfw(GLFW_MOUSE_BUTTON_LEFT), PointerButton::kLeft);
  EXPECT_EQ(pointerButtonFromGlfw(GLFW_MOUSE_BUTTON_RIGHT), PointerButton::kRight);
  EXPECT_EQ(pointerButtonFromGlfw(GLFW_MOUSE_BUTTON_MIDDLE), PointerButton::kMiddle);
  EXPECT_EQ(pointerButtonFromGlfw(GLFW_MOUSE_BUTTON_4), std::nullopt);
  const Modifiers held = modifiersFromGlfw(GLFW_MOD_SHIFT | GLFW_MOD_ALT | GLFW_MOD_CAPS_LOCK);
  EXPECT_TRUE(held.shift);
  EXPECT_FALSE(held.control);
  EXPECT_TRUE(held.alt);
  EXPECT_TRUE(modifiersFromGlfw(GLFW_MOD_CONTROL).control);
}

}  // namespace
}  // namespace ocelli
