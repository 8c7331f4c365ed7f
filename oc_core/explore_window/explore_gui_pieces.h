// Small pieces that the panes and overlays of `ocelli explore` are made of.
#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <string>
#include <string_view>

#include "oc_core/explore_window/explore_layout.h"
#include "oc_core/window/gui_style.h"

struct ImDrawList;

namespace ocelli {

/// A window of Dear ImGui that fills a rectangle; without a background where `opacity` is 0. End it with ImGui::End().
void beginExploreArea(const char* name, const ExplorePaneRect& rect, GuiColor background, uint8_t opacity,
                      bool takesPointer);

/// A closed outline: a line, and a soft band within it. Screen coordinates.
void drawExploreOutline(ImDrawList& list, std::span<const glm::vec2> points, GuiColor color, float scale);
/// A number or a word on a small plate of that colour, its middle at `at`.
void drawExploreBadge(ImDrawList& list, const glm::vec2& at, const std::string& text, GuiColor color, float scale);

/// `text` cut so that it is at most so wide, with "…" where it was.
std::string fittedExploreText(std::string_view text, float width);

}  // namespace ocelli
