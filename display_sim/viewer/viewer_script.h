// A script that drives the viewer without a display: what a person would do, and images of the window in between.
//
//   {"size": [1280, 800], "scale": 1, "steps": [{"wait": "idle"}, {"key": "M"}, {"save": "frame.png"}, ...]}
//
// viewer_script.schema.json lists every step. Time is the script's own, so the same script gives the same images.
#pragma once

#include <filesystem>
#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "display_sim/viewer/viewer_state.h"
#include "oc_core/base/input_event.h"

namespace ocelli {

/// A scene to load, as SCENE on the command line.
struct OpenStep {
  std::string source;
};
/// A camera's name or file.
struct CameraStep {
  std::string camera;
};
/// A file that is dropped onto the window.
struct DropStep {
  std::string file;
};
/// A key that is pressed and released: "H", "Shift+Tab", "Ctrl+Q".
struct KeyStep {
  Key key = Key::kSpace;
  Modifiers modifiers;
};
/// Text that is typed.
struct TypeStep {
  std::string text;
};
/// The pointer goes somewhere, in pixels of the window.
struct MoveStep {
  glm::dvec2 to{0};
};
/// ... and a button is pressed and released there.
struct ClickStep {
  glm::dvec2 at{0};
  PointerButton button = PointerButton::kLeft;
};
struct DragStep {
  glm::dvec2 from{0};
  glm::dvec2 to{0};
  PointerButton button = PointerButton::kLeft;
};
/// The wheel, upwards where positive.
struct ScrollStep {
  glm::dvec2 at{0};
  double up = 1;
};
/// The window gets another size, in pixels, and density.
struct ResizeStep {
  int width = 0;
  int height = 0;
  double scale = 1;
};
/// Until nothing is being made any more.
struct WaitStep {};
/// Time passes.
struct SecondsStep {
  double seconds = 0;
};
/// An effect, which opens its pane, and what stands for the scene in it: empty for the camera.
struct EffectStep {
  std::string name;
  std::string way;
};
/// What the effect pane shows.
struct ShowStep {
  EffectShown::Content content = EffectShown::Content::kByWay;
};
/// An image of the window, with the pictures of the effect, of the lenses and of the volume as they are once they are
/// whole; a PNG file.
struct SaveStep {
  std::string file;
};

/// The picture that the effect pane shows, by itself; a PNG file.
struct SaveEffectStep {
  std::string file;
};

/// The picture of the lens pane by itself, without outlines; a PNG file.
struct SaveLensPictureStep {
  std::string file;
};
/// The camera with its lenses; a JSON file.
struct SaveCameraStep {
  std::string file;
};

/// A preset of a transfer function, or a file, for the volume.
struct TransferStep {
  std::string nameOrFile;
};
/// The value of the surface of a volume that the panes of meshes show; nothing: none.
struct IsoStep {
  std::optional<double> value;
};
/// The picture of the volume pane by itself; a PNG file.
struct SaveVolumePictureStep {
  std::string file;
};
/// The transfer function as it is; a JSON file.
struct SaveTransferStep {
  std::string file;
};

using ScriptStep =
    std::variant<OpenStep, CameraStep, DropStep, KeyStep, TypeStep, MoveStep, ClickStep, DragStep, ScrollStep,
                 ResizeStep, WaitStep, SecondsStep, EffectStep, ShowStep, SaveStep, SaveEffectStep, SaveLensPictureStep,
                 SaveCameraStep, TransferStep, IsoStep, SaveVolumePictureStep, SaveTransferStep>;

struct ViewerScript {
  int width = 1280;
  int height = 800;
  double scale = 1;  ///< how much larger than at 96 dots an inch things are drawn
  std::vector<ScriptStep> steps;
};

/// Throws InputError naming the step and the field that is missing, unknown or out of range.
ViewerScript viewerScriptFromJsonText(const std::string& text, const std::string& where);
ViewerScript readViewerScript(const std::filesystem::path& path);

}  // namespace ocelli
