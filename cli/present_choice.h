// What `ocelli present` is asked for: its options, and which of them go together.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "cli/command.h"
#include "cli/emulated_display.h"
#include "cli/scene_options.h"
#include "cli/shown_output.h"
#include "cli/slicing_options.h"
#include "cli/volume_slicing_options.h"
#include "oc_core/worlds/scene_motion.h"

namespace ocelli {

/// Of --transfer-seconds.
inline constexpr double kTransferSeconds = 4;

struct PresentChoice {
  SceneChoice scene;
  std::string device;
  std::string profile;
  SlicingChoice slicing;
  VolumeChoice volume;
  VolumeSlicingChoice volumeSlicing;
  std::string transferTo;
  double transferSeconds = kTransferSeconds;
  std::optional<double> seconds;
  bool loop = false;
  bool follow = false;
  std::optional<double> turn;
  std::string eyes;
  std::string prediction = "kalman";
  std::string camera;
  std::string size = "720x480";
  double speed = 1;
  bool tear = false;
  bool coarse = false;
  double minImageScale = 0.25;
  int refreshesToMake = 1;
  std::string timeLine;
  std::string record;
  bool fast = false;
  EmulatedDisplayChoice simulated;
  ShownChoice shown;
  bool json = false;

  bool isRecording() const { return scene.source.ends_with(".svol"); }
  bool isVolume() const { return isVolumeSource(scene.source); }
  bool isFolder() const { return std::filesystem::is_directory(scene.source) && !isVolume(); }
  bool isDeviceLog() const { return scene.source.ends_with(".session"); }
  bool isScene() const { return !isRecording() && !isDeviceLog(); }
  bool hasCamera() const { return !camera.empty() && camera != "none"; }
  /// Of a file only loadMotion() tells.
  bool mayPlay() const {
    return isScene() && !isVolume() && !turn && !scene.options.motion.seconds && mayMove(scene.source);
  }
};

/// `choice` must outlive the command.
void addPresentOptions(CLI::App& command, PresentChoice& choice, const CommandContext& context);

/// Throws InputError where options do not go together.
void checkPresentChoice(const PresentChoice& choice);

/// Throws InputError where a slicer is asked for that is too slow for what moves.
void refuseSlowSlicers(const PresentChoice& choice);

/// Throws InputError for options that say how a scene moves, of one that does not move by itself.
void refuseOptionsOfMotion(const PresentChoice& choice);

}  // namespace ocelli
