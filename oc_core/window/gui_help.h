// The panel in the middle of a window that says what keys and the pointer do.
#pragma once

#include <glm/vec2.hpp>

namespace ocelli {

/// Open from its construction to its destruction, within a frame of Dear ImGui. What follows the rows may be drawn into
/// it, too.
class GuiHelp {
 public:
  /// `window` in screen coordinates, `scale` the length of 1 at 96 dots an inch, in which widths are: of the panel, and
  /// of the names of keys.
  GuiHelp(const glm::ivec2& window, float scale, float width, float keysWidth, const char* title);
  ~GuiHelp();
  GuiHelp(const GuiHelp&) = delete;
  GuiHelp& operator=(const GuiHelp&) = delete;

  /// Rows with the members `shown` and `meaning`, of one list or more.
  template <class... Lists>
  void rows(const Lists&... lists) {
    beginRows();
    const auto each = [](const auto& list) {
      for (const auto& row : list) {
        addRow(row.shown, row.meaning);
      }
    };
    (each(lists), ...);
    endRows();
  }

 private:
  void beginRows() const;
  static void addRow(const char* shown, const char* meaning);
  static void endRows();

  float keysWidth_;
};

}  // namespace ocelli
