// What the window of `ocelli explore` needs of whatever walks, picks and draws: the interface, and what a frame of it
// is. The window never calls it itself: a thread of its own does (explore_window_work.h), so that slow frames hold up
// no keys.
//
// Image points are pixels of the image named with them, origin at its top left, y down. Points of plans are those of
// plan_side.h, seen from the top: x to the right, z down, in the units of the scene.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/constructor/multiperspective_camera.h"
#include "oc_core/image/png_file.h"

namespace ocelli {

class ExploreScene;

/// What the user wants to do as long as it is held, from -1 to 1 each, and how far the eye has been turned at once.
struct WindowMotion {
  float ahead = 0;
  float right = 0;
  float up = 0;         ///< where one can fly
  float turnRight = 0;  ///< as long as it is held
  float lookUp = 0;
  bool fast = false;
  glm::vec2 turnedDegrees{0};  ///< at once, as by a mouse: to the right and up
  bool operator==(const WindowMotion&) const = default;
};

/// The images that are asked for, pixels; nothing where a pane is closed.
struct WindowShape {
  glm::ivec2 view{1280, 720};
  std::optional<glm::ivec2> pinhole{};
  bool ground = false;  ///< the picture that lies under the plan
  bool operator==(const WindowShape&) const = default;
};

/// A row of the constructors that can be chosen.
struct WindowChoice {
  std::string name;     ///< "portal"
  std::string meaning;  ///< "looks around an object that is clicked"
};

/// An option of the constructor that is chosen, for a form.
struct WindowField {
  std::string name;  ///< as in JSON
  std::string label;
  std::string meaning;
  std::string unit;  ///< "m", "degrees", "frames"; empty for a number alone
  double lower = 0;
  double upper = 1;
  double step = 0.1;
  double value = 0;
  std::vector<std::string> names{};  ///< of an option that is one of these: `value` is the index
  bool operator==(const WindowField&) const = default;
};

/// A piece of an image that one frustum, or one bend, has made, and in which of its colours it is shown.
struct WindowTint {
  std::vector<glm::vec2> outline;  ///< of the image
  int color = 0;                   ///< of exploreSeriesColor(); 0 is that of rays that do not bend
};

/// What the plan shows, but for the ground.
struct WindowPlan {
  struct Frustum {
    std::vector<glm::vec2> outline;  ///< convex
    glm::vec2 viewpoint{0};
    int color = 0;
  };
  struct Cell {
    std::vector<glm::vec2> outline;
    bool isTunnel = false;
  };
  using Opening = std::array<glm::vec2, 2>;
  glm::vec2 walker{0};
  glm::vec2 heading{0, -1};  ///< unit
  std::vector<Frustum> frusta;
  std::vector<glm::vec2> picked;  ///< the outline of what is picked; empty for nothing
  // What stays for long; null where there is none.
  std::shared_ptr<const std::vector<Cell>> cells;  ///< of the walk map
  std::shared_ptr<const std::vector<Opening>> openings;
  std::shared_ptr<const std::vector<glm::vec2>> path;
};

/// A picture of the scene from above. It comes once, and again where the scene has changed.
struct WindowGround {
  Image<Rgb8> image;
  glm::vec2 lower{0};  ///< of the plan, at the corner of the first pixel
  glm::vec2 upper{0};
};

/// How serious a state is.
enum class WindowNoteKind : uint8_t { kPlain, kAttention };
struct WindowNote {
  std::string text;  ///< a sentence: "The target is hidden, and no bend shows it."
  WindowNoteKind kind = WindowNoteKind::kPlain;
};

/// One frame.
struct WindowPicture {
  /// What is explored, which stays as long as this; its constant functions may be called. Null where that is no scene.
  std::shared_ptr<const ExploreScene> scene;
  std::optional<PinholeCamera> pinholeCamera;  ///< of the walker, as large as the view
  Image<Rgb8> view;
  std::optional<Image<Rgb8>> pinhole;
  std::vector<WindowTint> tints;
  WindowPlan plan;
  std::shared_ptr<const WindowGround> ground;
  std::vector<WindowChoice> choices;
  size_t chosen = 0;
  std::vector<WindowField> fields;
  std::vector<WindowNote> notes;
  std::string picked;       ///< "portal 3", "statue"; empty for nothing
  std::string place;        ///< "12.1, 3.4 m, heading 214 degrees"
  std::string lengthUnit;   ///< "m"; empty where the scene does not say
  double milliseconds = 0;  ///< that drawing took
  bool isMoving = false;    ///< whether the next frame differs though nobody does anything
  /// What is being done beside it that takes long, such as the search for where one can walk; empty for nothing.
  std::string stage;
  double fraction = 0;
};

/// What explores. One thread calls it. Errors that leave it as it was are InputError; others end the session.
class ExploreWindowModel {
 public:
  virtual ~ExploreWindowModel() = default;

  virtual void advance(double seconds, const WindowMotion& motion) = 0;
  virtual WindowPicture draw(const WindowShape& shape) = 0;

  virtual void choose(size_t choice) = 0;
  virtual void setField(const std::string& name, double value) = 0;
  /// By `steps`, within its range; one of names goes round.
  virtual void changeField(const std::string& name, double steps) = 0;
  /// What the pixel of the view shows. Returns what there is to say: what to click instead, where it is of no use.
  virtual std::string pick(const glm::dvec2& viewPixel) = 0;
  /// The next thing that can be picked for this constructor, from near to far: 1, or -1 for the one before.
  virtual std::string pickNext(int step) = 0;
  /// Shows a camera as it is, drawn by hand or from a file; `name` is for people.
  virtual void showDrawn(const MultiperspectiveCamera& camera, const std::string& name) = 0;
  /// The same of a file, or of a camera by its name, as --camera of other commands takes it.
  virtual void openCamera(const std::string& nameOrFile) = 0;
  /// Flies through walls, or walks again.
  virtual void toggleFlying() = 0;
  virtual void goToStart() = 0;
  /// Where a point of the plan is.
  virtual void goTo(const glm::vec2& planPoint) = 0;
  /// The camera as the file that `--camera` takes.
  virtual std::string cameraFile() const = 0;
  /// What the view shows and that file does not hold, to be added to a sentence; empty for nothing.
  virtual std::string cameraFileLacks() const { return {}; }
};

}  // namespace ocelli
