// Pieces that several screens of a study share.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/screen/study_canvas.h"

namespace ocelli {

/// A key as it looks on a keyboard, by its name in the language of the canvas; its left border at `left`, in the middle
/// of a line around `middle`. Returns its right border.
double drawKeyCap(StudyCanvas& canvas, double left, double middle, const std::string& name, GuiColor background);
double keyCapWidth(const StudyCanvas& canvas, const std::string& name);

struct ButtonLook {
  std::string label;
  std::string key;  ///< that does the same; may be empty
  bool primary = true;
  bool focused = false;
  bool enabled = true;
};
double buttonWidth(const StudyCanvas& canvas, const ButtonLook& look);
/// Whether it was clicked.
bool drawButton(StudyCanvas& canvas, const std::string& name, const PixelRect& place, const ButtonLook& look);

/// A tick or a cross in a disc.
void drawVerdict(StudyCanvas& canvas, const glm::dvec2& center, double radius, bool good);
/// A tick of so many pixels from side to side.
void drawTick(StudyCanvas& canvas, const glm::dvec2& center, double size, GuiColor color, double thickness);
/// Two bars.
void drawPauseSign(StudyCanvas& canvas, const glm::dvec2& center, double size, GuiColor color);

/// Around what the keys act on.
void drawFocusRing(StudyCanvas& canvas, const PixelRect& place, double rounding);

/// The strip at the bottom of every screen but trials: the key that ends the session, and room for buttons. Returns the
/// strip.
PixelRect drawFooter(StudyCanvas& canvas);
/// How much of it that key takes, from the left.
double unwellWidth(const StudyCanvas& canvas);
/// What a page offers: "Enter: begin", or several with spaces between them. Where what stands before the colon is no
/// key, all of it is the label.
struct PageChoice {
  std::optional<Key> key{};
  std::string label;
};
std::vector<PageChoice> pageChoices(const std::string& action);

/// What ends a session; shown everywhere.
inline constexpr const char* kUnwellKey = "F10";

}  // namespace ocelli
