// What the pointer and keys do in two plans of an editor, one from above and one from a side, without a window. The
// owner of a window passes its events on, and draws plans(), the tool and entry(). editorKeys() lists all keys:
// everything goes without a pointer, too.
#pragma once

#include <array>
#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "oc_core/base/input_event.h"
#include "oc_core/frustum_editor/frustum_editor.h"

namespace ocelli {

class EditorInput;

/// A row: what a press does.
struct EditorKey {
  const char* keys;  ///< how help names it; empty for one that belongs to the row before
  const char* says;
  Key key = Key::kEscape;
  bool control = false;
  void (*act)(EditorInput& input, int argument) = nullptr;
  int argument = 0;
};

std::span<const EditorKey> editorKeys();

/// What is being typed: a number of the selected handle, or a name.
struct EditorEntry {
  std::string label;  ///< "heading", "name"
  std::string text;
};

class EditorInput {
 public:
  struct Plan {
    PlanWindow window;
    glm::dvec2 corner{0};     ///< of its pane, in the coordinates of pointers
    glm::dvec2 crosshair{0};  ///< on the paper: where Enter presses
  };

  /// The editor must live as long. `save` is called for Ctrl + S.
  EditorInput(FrustumEditor& editor, const Box& world, std::function<void()> save);

  /// The area that both plans share, the one from above in its upper part. The first call shows all of the scene.
  void layOut(const glm::dvec2& corner, const glm::ivec2& size);
  /// From above, and from the side.
  const std::array<Plan, 2>& plans() const { return plans_; }
  /// The one that keys act in.
  size_t active() const { return active_; }
  const std::optional<EditorEntry>& entry() const { return entry_; }
  /// Which of the selected handle's numbers is typed next.
  std::string chosenNumber() const;
  FrustumEditor& editor() { return *editor_; }
  const FrustumEditor& editor() const { return *editor_; }

  /// Pointer, buttons and wheel. Whether it was used.
  bool handle(const InputEvent& event, const glm::dvec2& pointer);
  bool handle(const KeyEvent& event);

  // What keys do.
  void moveBy(const glm::dvec2& steps);
  void pressOrRelease();
  void escape();
  void chooseNextNumber();
  void beginRename();
  void switchPlan();
  void turnSidePlan();
  void zoomBy(double factor);
  void save() { save_(); }

 private:
  Plan& plan() { return plans_[active_]; }
  PlanPointer pointerAt(size_t plan, const glm::dvec2& pointer) const;
  std::optional<size_t> planAt(const glm::dvec2& pointer) const;
  bool type(const KeyEvent& event);
  void finishEntry();

  FrustumEditor* editor_;
  Box world_;
  std::function<void()> save_;
  std::array<Plan, 2> plans_;
  bool laidOut_ = false;
  size_t active_ = 0;
  size_t number_ = 0;
  bool isRenaming_ = false;
  std::optional<EditorEntry> entry_;
  std::optional<size_t> pressed_;  ///< the plan that a button is pressed in
  bool pans_ = false;              ///< by that button
  bool shift_ = false;
  glm::dvec2 last_{0};  ///< where the pointer was
};

}  // namespace ocelli
