#include "oc_core/window/gui_style.h"

#include <imgui.h>

namespace ocelli {
namespace {

ImVec4 color(GuiColor color, float alpha = 1) {
  const auto [red, green, blue] = color.floats();
  return {red, green, blue, alpha};
}

void applyColors(ImGuiStyle& style) {
  const ImVec4 none(0, 0, 0, 0);
  auto* const colors = static_cast<ImVec4*>(style.Colors);
  colors[ImGuiCol_Text] = color(kGuiText);
  colors[ImGuiCol_TextDisabled] = color(kGuiTextDim);
  colors[ImGuiCol_TextSelectedBg] = color(kGuiAccentDeep);
  colors[ImGuiCol_WindowBg] = color(kGuiPanel);
  colors[ImGuiCol_ChildBg] = none;
  colors[ImGuiCol_PopupBg] = color(kGuiPanel);
  colors[ImGuiCol_MenuBarBg] = color(kGuiBackground);
  colors[ImGuiCol_Border] = color(kGuiBorder);
  colors[ImGuiCol_BorderShadow] = none;
  for (const ImGuiCol title : {ImGuiCol_TitleBg, ImGuiCol_TitleBgCollapsed}) {
    colors[title] = color(kGuiBackground);
  }
  colors[ImGuiCol_TitleBgActive] = color(kGuiField);
  colors[ImGuiCol_FrameBg] = color(kGuiField);
  colors[ImGuiCol_FrameBgHovered] = color(kGuiFieldHovered);
  colors[ImGuiCol_FrameBgActive] = color(kGuiFieldActive);
  colors[ImGuiCol_Button] = color(kGuiFieldHovered);
  colors[ImGuiCol_ButtonHovered] = color(kGuiFieldActive);
  for (const ImGuiCol chosen : {ImGuiCol_ButtonActive, ImGuiCol_Header, ImGuiCol_HeaderActive, ImGuiCol_TabActive,
                                ImGuiCol_TabUnfocusedActive}) {
    colors[chosen] = color(kGuiAccentDeep);
  }
  for (const ImGuiCol hovered : {ImGuiCol_HeaderHovered, ImGuiCol_TabHovered}) {
    colors[hovered] = color(kGuiFieldActive);
  }
  for (const ImGuiCol tab : {ImGuiCol_Tab, ImGuiCol_TabUnfocused}) {
    colors[tab] = color(kGuiField);
  }
  colors[ImGuiCol_ScrollbarBg] = none;
  colors[ImGuiCol_ScrollbarGrab] = color(kGuiBorder);
  for (const ImGuiCol held : {ImGuiCol_ScrollbarGrabHovered, ImGuiCol_ScrollbarGrabActive}) {
    colors[held] = color(kGuiTextDim);
  }
  for (const ImGuiCol accent :
       {ImGuiCol_CheckMark, ImGuiCol_SliderGrab, ImGuiCol_SliderGrabActive, ImGuiCol_SeparatorHovered,
        ImGuiCol_SeparatorActive, ImGuiCol_ResizeGripHovered, ImGuiCol_ResizeGripActive, ImGuiCol_PlotLines,
        ImGuiCol_PlotHistogram, ImGuiCol_DragDropTarget, ImGuiCol_NavHighlight, ImGuiCol_NavWindowingHighlight}) {
    colors[accent] = color(kGuiAccent);
  }
  for (const ImGuiCol plot : {ImGuiCol_PlotLinesHovered, ImGuiCol_PlotHistogramHovered}) {
    colors[plot] = color(kOkabeItoOrange);
  }
  for (const ImGuiCol line :
       {ImGuiCol_Separator, ImGuiCol_ResizeGrip, ImGuiCol_TableBorderStrong, ImGuiCol_TableBorderLight}) {
    colors[line] = color(kGuiBorder);
  }
  colors[ImGuiCol_TableHeaderBg] = color(kGuiField);
  colors[ImGuiCol_TableRowBg] = none;
  colors[ImGuiCol_TableRowBgAlt] = color(kGuiField, 0.4F);
  for (const ImGuiCol dim : {ImGuiCol_NavWindowingDimBg, ImGuiCol_ModalWindowDimBg}) {
    colors[dim] = color(kGuiBackground, 0.6F);
  }
}

}  // namespace

void applyGuiStyle(double scale) {
  ImGuiStyle style;
  applyColors(style);
  style.WindowPadding = {12, 12};
  style.FramePadding = {8, 4};
  style.CellPadding = {6, 3};
  style.ItemSpacing = {8, 6};
  style.ItemInnerSpacing = {6, 4};
  style.IndentSpacing = 20;
  style.ScrollbarSize = 12;
  style.GrabMinSize = 12;
  for (float* rounding : {&style.WindowRounding, &style.ChildRounding, &style.FrameRounding, &style.PopupRounding,
                          &style.ScrollbarRounding, &style.GrabRounding, &style.TabRounding}) {
    *rounding = 4;
  }
  style.WindowBorderSize = 1;
  style.PopupBorderSize = 1;
  style.WindowTitleAlign = {0, 0.5F};
  style.WindowMenuButtonPosition = ImGuiDir_None;
  style.ScaleAllSizes(static_cast<float>(scale));
  ImGui::GetStyle() = style;
}

}  // namespace ocelli
