#include "oc_core/feeds_editor_window/face_keys.h"

#include <array>

namespace ocelli {
namespace {

constexpr double kHeightStep = 0.05;  ///< metres

constexpr std::array kPointerLines{
    FacePointerLine{"drag an end", "move it; it snaps to corners and to other faces, with Shift it does not"},
    FacePointerLine{"drag a middle", "move the face"},
    FacePointerLine{"drag elsewhere", "draw the face of the selected feed, where it has none"},
    FacePointerLine{"right button", "move the plan"}, FacePointerLine{"wheel", "zoom"}};

}  // namespace

const std::vector<FaceKeyAction>& faceKeyActions() {
  static const std::vector<FaceKeyAction> kActions{
      {{Key::kTab},
       false,
       "Tab",
       "select the next feed, with Shift the one before",
       [](FaceEditor& e, FaceWindowState&, const Modifiers& m) { e.selectNext(m.shift ? -1 : 1); }},
      {{Key::kP},
       false,
       "P",
       "choose the next parent",
       [](FaceEditor& e, FaceWindowState&, const Modifiers&) { e.changeParent(); }},
      {{Key::kUp},
       false,
       "Up",
       "raise the top, with Shift the bottom",
       [](FaceEditor& e, FaceWindowState&, const Modifiers& m) {
         m.shift ? e.moveBottom(kHeightStep) : e.moveTop(kHeightStep);
       }},
      {{Key::kDown},
       false,
       "Down",
       "lower the top, with Shift the bottom",
       [](FaceEditor& e, FaceWindowState&, const Modifiers& m) {
         m.shift ? e.moveBottom(-kHeightStep) : e.moveTop(-kHeightStep);
       }},
      {{Key::kDelete, Key::kBackspace},
       false,
       "Delete",
       "remove the face: its feed is no frustum any more",
       [](FaceEditor& e, FaceWindowState&, const Modifiers&) { e.remove(); }},
      {{Key::kZ},
       true,
       "Ctrl+Z",
       "undo, with Shift redo",
       [](FaceEditor& e, FaceWindowState&, const Modifiers& m) { m.shift ? e.redo() : e.undo(); }},
      {{Key::kY}, true, "Ctrl+Y", "redo", [](FaceEditor& e, FaceWindowState&, const Modifiers&) { e.redo(); }},
      {{Key::kS},
       true,
       "Ctrl+S",
       "save the setup",
       [](FaceEditor&, FaceWindowState& s, const Modifiers&) { s.wantsSave = true; }},
      {{Key::kA},
       false,
       "A",
       "show all of the place",
       [](FaceEditor&, FaceWindowState& s, const Modifiers&) { s.wantsAll = true; }},
      {{Key::kF11},
       false,
       "F11",
       "fill the screen, or not",
       [](FaceEditor&, FaceWindowState& s, const Modifiers&) { s.wantsFullscreen = true; }},
      {{Key::kH, Key::kF1},
       false,
       "H, F1",
       "show or hide this help",
       [](FaceEditor&, FaceWindowState& s, const Modifiers&) { s.hasHelp = !s.hasHelp; }},
      {{Key::kEscape},
       false,
       "Escape",
       "let go of a drag, close the help, then the window",
       [](FaceEditor& e, FaceWindowState& s, const Modifiers&) {
         if (e.isDragging()) {
           e.cancel();
         } else {
           s.closeHelpOrWindow();
         }
       }}};
  return kActions;
}

std::span<const FacePointerLine> facePointerLines() {
  return kPointerLines;
}

}  // namespace ocelli
