#include "oc_core/window/gui_style.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "oc_core/image/color.h"

namespace ocelli {
namespace {

/// WCAG 2.1: relative luminance, and the contrast of two.
double luminance(const ImVec4& color) {
  return 0.2126 * linearFromSrgb(color.x) + 0.7152 * linearFromSrgb(color.y) + 0.0722 * linearFromSrgb(color.z);
}

double contrast(const ImVec4& a, const ImVec4& b) {
  const auto [dark, light] = std::minmax({luminance(a), luminance(b)});
  return (light + 0.05) / (dark + 0.05);
}

ImVec4 over(const ImVec4& color, const ImVec4& below) {
  const auto mixed = [&](float a, float b) { return a * color.w + b * (1 - color.w); };
  return {mixed(color.x, below.x), mixed(color.y, below.y), mixed(color.z, below.z), 1};
}

ImVec4 opaque(GuiColor color) {
  const auto [red, green, blue] = color.floats();
  return {red, green, blue, 1};
}

class GuiStyleTest : public testing::Test {
 protected:
  GuiStyleTest() : context_(ImGui::CreateContext()) {}
  ~GuiStyleTest() override { ImGui::DestroyContext(context_); }

 private:
  ImGuiContext* context_;
};

TEST(GuiColorTest, contrastOfBlackAndWhiteIs21) {
  EXPECT_NEAR(contrast({0, 0, 0, 1}, {1, 1, 1, 1}), 21, 1e-4);  // as WCAG says; float luminance
}

TEST(GuiColorTest, packsAsDearImGuiDoes) {
  EXPECT_EQ((GuiColor{1, 2, 3}.packed(4)), IM_COL32(1, 2, 3, 4));
  EXPECT_EQ((GuiColor{255, 0, 51}.floats()), (std::array<float, 3>{1, 0, 0.2F}));
}

TEST_F(GuiStyleTest, textIsLegibleOnEveryBackground) {
  applyGuiStyle(1);
  const ImGuiStyle& style = ImGui::GetStyle();
  const ImVec4 panel = style.Colors[ImGuiCol_WindowBg];
  ASSERT_EQ(panel.w, 1);
  for (const ImGuiCol background : {ImGuiCol_WindowBg,
                                    ImGuiCol_ChildBg,
                                    ImGuiCol_PopupBg,
                                    ImGuiCol_FrameBg,
                                    ImGuiCol_FrameBgHovered,
                                    ImGuiCol_FrameBgActive,
                                    ImGuiCol_TitleBg,
                                    ImGuiCol_TitleBgActive,
                                    ImGuiCol_TitleBgCollapsed,
                                    ImGuiCol_MenuBarBg,
                                    ImGuiCol_Button,
                                    ImGuiCol_ButtonHovered,
                                    ImGuiCol_ButtonActive,
                                    ImGuiCol_Header,
                                    ImGuiCol_HeaderHovered,
                                    ImGuiCol_HeaderActive,
                                    ImGuiCol_Tab,
                                    ImGuiCol_TabHovered,
                                    ImGuiCol_TabActive,
                                    ImGuiCol_TabUnfocused,
                                    ImGuiCol_TabUnfocusedActive,
                                    ImGuiCol_TableHeaderBg,
                                    ImGuiCol_TableRowBgAlt,
                                    ImGuiCol_TextSelectedBg}) {
    EXPECT_GE(contrast(style.Colors[ImGuiCol_Text], over(style.Colors[background], panel)), 4.5)
        << ImGui::GetStyleColorName(background);
  }
  for (const ImGuiCol background : {ImGuiCol_WindowBg, ImGuiCol_PopupBg, ImGuiCol_FrameBg}) {
    EXPECT_GE(contrast(style.Colors[ImGuiCol_TextDisabled], over(style.Colors[background], panel)), 4.5)
        << ImGui::GetStyleColorName(background);
  }
}

// WCAG asks 3 for what is drawn and is no text.
TEST_F(GuiStyleTest, marksAndSeriesAreSeen) {
  applyGuiStyle(1);
  const ImGuiStyle& style = ImGui::GetStyle();
  for (const ImGuiCol background : {ImGuiCol_FrameBg, ImGuiCol_FrameBgHovered, ImGuiCol_FrameBgActive}) {
    for (const ImGuiCol mark : {ImGuiCol_CheckMark, ImGuiCol_SliderGrab, ImGuiCol_NavHighlight}) {
      EXPECT_GE(contrast(style.Colors[mark], style.Colors[background]), 3) << ImGui::GetStyleColorName(mark);
    }
  }
  for (const GuiColor series : kGuiSeries) {
    EXPECT_GE(contrast(opaque(series), style.Colors[ImGuiCol_WindowBg]), 3);
  }
}

TEST_F(GuiStyleTest, lengthsFollowTheScale) {
  applyGuiStyle(1);
  const ImGuiStyle once = ImGui::GetStyle();
  applyGuiStyle(2);
  applyGuiStyle(2);  // twice is not four times
  const ImGuiStyle twice = ImGui::GetStyle();
  EXPECT_EQ(once.FrameRounding, 4);
  EXPECT_EQ(twice.FrameRounding, 8);
  EXPECT_EQ(twice.WindowPadding.x, 2 * once.WindowPadding.x);
  EXPECT_EQ(twice.ItemSpacing.y, 2 * once.ItemSpacing.y);
}

}  // namespace
}  // namespace ocelli
