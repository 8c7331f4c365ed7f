// Plays a script to a viewer.
#pragma once

#include <filesystem>
#include <functional>

#include "display_sim/viewer/viewer.h"
#include "display_sim/viewer/viewer_script.h"

namespace ocelli {

/// Seconds that pass from frame to frame.
inline constexpr double kScriptFrameSeconds = 1.0 / 60;

class ScriptPlayer {
 public:
  /// Images go to `folder`, which is made where it does not exist. `saved` is told of each; it may be empty.
  ScriptPlayer(Viewer& viewer, std::filesystem::path folder, std::function<void(const std::string& file)> saved = {});

  /// Throws InputError where the first scene cannot be loaded or a step closes the viewer before the last one,
  /// WorkError where an image cannot be written or the viewer does not come to rest, GlError. InputError where the
  /// effect pane, or that of the lenses or of a volume, has nothing to save. All else that goes wrong shows in the
  /// window, as it would for a person.
  void play(const ViewerScript& script);
  void play(const ScriptStep& step);

 private:
  void give(const std::vector<InputEvent>& events);
  /// Frames until every event has been seen, one at the least.
  void showFrames();
  /// Frames without time passing, until they tell all.
  void settle();
  void press(const glm::dvec2& at, PointerButton button, bool pressed);
  void perform(const OpenStep& step);
  void perform(const CameraStep& step);
  void perform(const DropStep& step);
  void perform(const KeyStep& step);
  void perform(const TypeStep& step);
  void perform(const MoveStep& step);
  void perform(const ClickStep& step);
  void perform(const DragStep& step);
  void perform(const ScrollStep& step);
  void perform(const ResizeStep& step);
  void perform(const WaitStep& step);
  void perform(const SecondsStep& step);
  void perform(const EffectStep& step);
  void perform(const ShowStep& step);
  void perform(const SaveStep& step);
  void perform(const SaveEffectStep& step);
  void perform(const SaveLensPictureStep& step);
  void perform(const SaveCameraStep& step);
  void perform(const TransferStep& step);
  void perform(const IsoStep& step);
  void perform(const SaveVolumePictureStep& step);
  void perform(const SaveTransferStep& step);
  /// Where a file goes; its folder is made.
  std::filesystem::path pathOf(const std::string& file) const;
  void tell(const std::filesystem::path& path) const;
  void write(const std::string& file, const Image<Rgb8>& image);

  Viewer& viewer_;
  std::filesystem::path folder_;
  std::function<void(const std::string& file)> saved_;
};

}  // namespace ocelli
