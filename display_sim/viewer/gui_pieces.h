// Small pieces that panels are made of.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "display_sim/viewer/viewer_layout.h"
#include "oc_core/window/gui_style.h"

namespace ocelli {

/// A window that fills a rectangle, without a title and not to be moved. End it with ImGui::End().
void beginFixedWindow(const char* name, const WindowRect& rect, GuiColor background, int moreFlags = 0);

/// A choice among `count` names; true where another was chosen.
bool comboOfNames(const char* label, int& index, int count, const std::function<std::string_view(int)>& nameAt);

template <class Enum>
bool comboOf(const char* label, Enum& value, int count) {
  int index = static_cast<int>(value);
  const bool changed = comboOfNames(label, index, count, [](int i) { return nameOf(static_cast<Enum>(i)); });
  value = static_cast<Enum>(index);
  return changed;
}

/// A field for text; true where Enter was pressed in it.
bool inputText(const char* label, std::string& text);

/// sRGB values from 0 to 1 of a linear colour.
glm::vec3 encodedColor(const glm::dvec3& linear);

/// Text that wraps, dim.
void noteText(const std::string& text);
/// A heading of a section, with room above.
void sectionTitle(const char* text);

}  // namespace ocelli
