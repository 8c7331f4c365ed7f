#include "cli/present_choice.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "cli/number_check.h"
#include "cli/output_option.h"
#include "display_driver/devices/device_kinds.h"
#include "display_driver/pacing/eye_feed.h"
#include "oc_core/base/error.h"
#ifdef OCELLI_WITH_OPENGL
#include "display_driver/picture_device/picture_devices.h"
#endif

namespace ocelli {
namespace {

void refuse(bool refused, const char* what, const char* option, const char* next) {
  if (refused) {
    throw InputError(what, option, next);
  }
}

/// What is presented would be destroyed by what is shown.
void refuseOwnSource(const PresentChoice& choice, const std::filesystem::path& output, const char* option) {
  std::error_code noFile;
  if (output == choice.scene.source || std::filesystem::equivalent(output, choice.scene.source, noFile)) {
    throw InputError(fmt::format("{} would be replaced while it is presented", output.string()), option,
                     "choose another file");
  }
}

std::string deviceHelp() {
  std::string help = "Where it is shown:";
  for (const DeviceKind& kind : deviceKinds()) {
    help += "\n  " + kind.usage() + ": " + kind.help;
  }
#ifdef OCELLI_WITH_OPENGL
  for (const PictureDeviceKind& kind : pictureDeviceKinds()) {
    help += "\n  " + kind.usage() + ": " + kind.help;
  }
#endif
  return help;
}

}  // namespace

void refuseSlowSlicers(const PresentChoice& choice) {
  refuse(choice.slicing.exact || needsExactSlicer(sliceOptionsOf(choice.slicing)),
         "what moves is sliced by the fast slicer alone", "--exact, --even-light or --dither diffusion",
         "leave it out");
}

void refuseOptionsOfMotion(const PresentChoice& choice) {
  refuse(choice.follow && !choice.turn && choice.eyes.empty() && choice.transferTo.empty(),
         "nothing moves in this scene", "--follow", "--turn 30, or --eyes FILE.csv");
  refuse(choice.speed != 1, "nothing moves by itself in this scene", "--speed", "leave it out");
}

void checkPresentChoice(const PresentChoice& choice) {
  refuse(choice.turn && !choice.isScene(), "only a scene can be turned", "--turn", "give a scene, or leave out --turn");
  refuse(!choice.eyes.empty() && !choice.isScene(), "only a scene can be seen from somewhere else", "--eyes",
         "give a scene, or leave out --eyes");
  refuse(choice.turn && !choice.eyes.empty(), "a scene either turns or follows an eye", "--turn",
         "leave out --turn or --eyes");
  refuse(choice.turn && choice.hasCamera(), "a scene that turns is sliced without a camera", "--camera",
         "leave out --camera or --turn");
  refuse(choice.hasCamera() && !choice.isScene(), "only scenes are seen by a camera", "--camera", "leave it out");
  refuse(!choice.eyes.empty() && choice.camera == "none", "without a camera the eye changes nothing", "--camera none",
         "--camera ddoc");
  refuse(choice.scene.options.motion.meshesPerSecond && !choice.isFolder(),
         "only a folder of meshes has a rate of its own", "--rate", "leave it out");
  refuse(choice.turn && choice.isFolder() && !choice.scene.options.motion.seconds,
         "a scene either turns or moves by itself", "--turn", "leave it out, or turn one moment of it (--time)");
  refuse((choice.isRecording() || choice.isDeviceLog()) && !choice.profile.empty(), "a volume has its profile already",
         "--profile", "leave it out");
  refuse(choice.isDeviceLog() && (choice.loop || choice.tear || choice.coarse || choice.seconds || choice.follow ||
                                  !choice.timeLine.empty()),
         "a device log is played as it was, once", "--loop, --tear, --coarse, --seconds, --follow or --timeline",
         "leave it out");
  refuse(choice.fast && !choice.isDeviceLog(), "only a device log can go faster", "--fast", "leave it out");
  if (choice.isVolume()) {
    refuse(!choice.eyes.empty(), "a volume is shown for eyes that stay where they are", "--eyes",
           "--viewer X,Y,Z with --seen-opacity 0.5");
    refuse(choice.hasCamera(), "a volume is shown straight from its field", "--camera",
           "leave it out, or show what --viewer sees, with --seen-opacity 0.5");
    refuse(choice.turn && (choice.volumeSlicing.cutaway || choice.volumeSlicing.seenOpacity),
           "what is left out for a viewer would turn with the volume", "--turn",
           "leave it out, or --cutaway and --seen-opacity");
    refuse(choice.scene.options.iso && !choice.transferTo.empty(), "a surface has no transfer function",
           "--transfer-to", "leave it out, or --iso");
  } else {
    refuseVolumeOptions(choice.volume);
    refuseVolumeSlicingOptions(choice.volumeSlicing);
    refuseVolumeOption(!choice.transferTo.empty(), "--transfer-to");
  }
  refuse(choice.transferSeconds != kTransferSeconds && choice.transferTo.empty(), "no transfer function moves",
         "--transfer-seconds", "add --transfer-to NAME");
  if (choice.turn || !choice.eyes.empty() || !choice.transferTo.empty()) {
    refuseSlowSlicers(choice);
  }
  refuse(choice.device != "sim" && (choice.simulated.given() || choice.shown.given()),
         "only the simulated display has a link, faults and an observer of its own",
         "--link, --faults, --jitter, --shown or --watch", "--device sim");
  if (choice.isScene() && !choice.mayPlay() && !choice.isVolume()) {
    refuseOptionsOfMotion(choice);
  }
  if (choice.device.starts_with("file:")) {
    refuseOwnSource(choice, choice.device.substr(5), "--device");
  }
  if (!choice.shown.folder.empty()) {
    refuseOwnSource(choice, shownRecord(choice.shown), "--shown");
  }
}

void addPresentOptions(CLI::App& command, PresentChoice& choice, const CommandContext& context) {
  addSceneOptions(command, choice.scene, context);
  addMotionOptions(command, choice.scene);
  command.get_option("--rate")->description("Meshes a second of a folder of numbered meshes; by default one a refresh");
  command.get_option("SCENE")->description(
      "A scene, which plays where it moves, the mesh of a reference image (.exr), a volume of scalars, a display's "
      "volume or recording (.svol), or a folder of numbered meshes");
  command.add_option("--device", choice.device, deviceHelp())->type_name("DEVICE")->required();
  addProfileOption(command, choice.profile);
  addSlicingOptions(command, choice.slicing);
  addVolumeOptions(command, choice.volume);
  addVolumeSlicingOptions(command, choice.volumeSlicing);
  command
      .add_option("--transfer-to", choice.transferTo,
                  "Of a volume: the transfer function becomes this one, and then itself again, over and over")
      ->type_name("NAME|FILE.json");
  command.add_option("--transfer-seconds", choice.transferSeconds, "How long that takes, there and back")
      ->check(numberCheck(0.1, 1e6))
      ->type_name("SECONDS")
      ->capture_default_str();
  command.add_option("--seconds", choice.seconds, "Stop after so long; otherwise at the end, or with Ctrl-C")
      ->check(numberCheck(0, 1e9))
      ->type_name("SECONDS");
  command.add_flag("--loop", choice.loop, "At the end of a recording, a motion or a path of eyes begin again");
  command.add_flag("--follow", choice.follow, "Tell of every refresh that was missed, when it is");
  command.add_option("--turn", choice.turn, "Turn the scene about the display's axis")
      ->check(numberCheck(-1e5, 1e5))
      ->type_name("DEGREES_PER_SECOND");
  command
      .add_option("--eyes", choice.eyes,
                  "Where the viewer's eye is: a file with the header time,x,y,z, or such lines live; \"-\" is standard "
                  "input. For each place a reference image is built")
      ->type_name("FILE.csv|FILE.json|udp:[ADDRESS:]PORT|-");
  command
      .add_option("--predict", choice.prediction,
                  "Where live eyes will be when they see what is made for them: as they were last, at constant "
                  "velocity, or by a Kalman filter")
      ->check(CLI::IsMember(eyePredictionNames()))
      ->type_name("NAME")
      ->capture_default_str();
  addCameraOption(command, choice.camera);
  addSizeOption(command, choice.size);
  command
      .add_option("--min-scale", choice.minImageScale,
                  "When time runs short, the images for --eyes may have this share of the pixels each way; 1: always "
                  "all of them, though refreshes are missed")
      ->check(numberCheck(0.05, 1))
      ->type_name("SHARE")
      ->capture_default_str();
  command
      .add_option("--making-refreshes", choice.refreshesToMake,
                  "Refreshes that making what an eye sees may take. 1: what is seen is young; 2: the image of one is "
                  "built while another is sliced, so images are larger, and a refresh older")
      ->check(CLI::Range(1, 2))
      ->type_name("1|2")
      ->capture_default_str();
  command.add_option("--speed", choice.speed, "Of a scene that moves: so many times as fast")
      ->check(numberCheck(1e-3, 1e3))
      ->type_name("FACTOR")
      ->capture_default_str();
  command.add_flag("--tear", choice.tear, "Show frames that come late at once, in the middle of a turn");
  command.add_flag("--coarse", choice.coarse, "Show the part of a frame that is there in time");
  addEmulatedDisplayOptions(command, choice.simulated, "of the simulated display: unlimited");
  addShownOptions(command, choice.shown);
  addSecondOutputOption(command, "--timeline", choice.timeLine, "A table of what became of each refresh", {".csv"});
  addSecondOutputOption(command, "--record", choice.record, "All that passes to the device and back", {".session"});
  command.add_flag("--fast", choice.fast, "A device log as fast as the display goes");
  command.add_flag("--json", choice.json, "Print the figures as JSON");
}

}  // namespace ocelli
