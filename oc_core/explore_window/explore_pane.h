// A pane of the window of `ocelli explore`: what fills one of its rectangles.
//
// Recipe for a new pane, three files:
//   1. oc_core/explore_window/NAME_pane.h: `std::unique_ptr<ExplorePane> makeNamePane();`
//   2. oc_core/explore_window/NAME_pane.cpp: a class that draws with Dear ImGui inside of the window that is open, and
//      takes events; its state is its own.
//   3. oc_core/explore_window/explore_panes.cpp: a row.
//
// A pane shows where ExploreWindowState::shown has its name (explore_pane_choice.h); a key that toggles it is a row of
// explore_keys.cpp.
#pragma once

#include <glm/vec2.hpp>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "oc_core/base/input_event.h"
#include "oc_core/explore_window/explore_layout.h"
#include "oc_core/explore_window/explore_window_model.h"
#include "oc_core/explore_window/explore_window_state.h"
#include "oc_core/explore_window/explore_window_work.h"
#include "oc_core/gl/gl_object.h"

namespace ocelli {

class ImageTexture;

/// What a pane has to do with in a frame.
struct ExplorePaneFrame {
  ExplorePaneRect rect;                    ///< screen coordinates of the window
  float scale = 1;                         ///< lengths in screen coordinates of a length of 1 at 96 dots an inch
  float pixelsPerUnit = 1;                 ///< framebuffer pixels for each screen coordinate
  const WindowPicture* picture = nullptr;  ///< the newest; null until the first is there
  bool isFresh = false;                    ///< whether that picture is another one than in the frame before
  ExploreWindowState& state;
  ExploreWindowWork& work;

  /// Of `rect`, at least 1.
  glm::ivec2 pixels() const;
  /// Into the pane, as large as it can be. Hold a GlScope.
  void copy(const ImageTexture& image, GlContext& context, const GlObject& framebuffer) const;
};

/// A line of the help while a pane has the keyboard.
struct ExplorePaneHelp {
  std::string keys;
  std::string meaning;
};

class ExplorePane {
 public:
  virtual ~ExplorePane() = default;

  /// Pixels that it wants of the model. Only the view and the pinhole ask for any.
  virtual void ask(const ExplorePaneFrame& frame, WindowShape& shape) const;
  /// Before panels are drawn: into the framebuffer that is bound, with OpenGL. Hold a GlScope.
  virtual void paint(const ExplorePaneFrame& frame, GlContext& context, const GlObject& framebuffer);
  /// With Dear ImGui: a window without background is open over `rect`.
  virtual void draw(const ExplorePaneFrame& frame) = 0;
  /// An event of the pointer in it, or after a button was pressed in it. Whether it has used it.
  virtual bool handlePointer(const ExplorePaneFrame& frame, const InputEvent& event, const glm::vec2& pointer);
  /// A key, while this pane has the keyboard (state.active). Whether it has used it: else it is one of the window's.
  virtual bool handleKey(const ExplorePaneFrame& frame, const KeyEvent& event);
  /// Buttons that were pressed count as let go: the window has no focus any more.
  virtual void loseFocus() {}
  /// What handleKey() does; empty for nothing.
  virtual std::vector<ExplorePaneHelp> help() const { return {}; }
};

/// One row of explorePanes().
struct ExplorePaneKind {
  const char* name;   ///< of ExploreWindowState::shown, and of scripts: "view"
  const char* title;  ///< over it: "Plan"
  const char* keys;   ///< beside that, how the help names the key that toggles it: "M"
  float widthShare;   ///< of the window: how wide the column is where it stands, at least
  bool showsAtFirst;  ///< when the window opens
  bool needsRoom;     ///< beside the large one it stands alone: the others come back when it goes
  bool takesKeys;     ///< handleKey() uses some
  std::unique_ptr<ExplorePane> (*make)();
};

/// In the order in which they stand: the first is the large one, which always shows; the others are in a column to its
/// right.
std::span<const ExplorePaneKind> explorePanes();

}  // namespace ocelli
