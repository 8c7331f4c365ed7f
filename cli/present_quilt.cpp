#include "cli/present_quilt.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <chrono>
#include <limits>

#include "cli/interrupt.h"
#include "cli/quilt_choice.h"
#include "display_driver/pacing/motion_clock.h"
#include "display_driver/picture_device/picture_devices.h"
#include "display_sim/quilt/quilt_ways.h"
#include "oc_core/base/error.h"
#include "oc_core/worlds/scene_motion.h"

namespace ocelli {
namespace {

using Clock = std::chrono::steady_clock;

double secondsAfter(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Throws InputError for options that are of volumes, or of displays that show them.
void refuseOtherOptions(const PresentChoice& choice, const CLI::App& command, const CommandContext& context) {
  constexpr std::array kTaken{"--device", "--seconds", "--speed", "--loop"};
  CLI::App taken;  // what says which scene it is, and what every command takes
  SceneChoice scene;
  addSceneOptions(taken, scene, context);
  addMotionOptions(taken, scene);
  context.addCommonOptions(taken);
  for (const CLI::Option* option : command.get_options([](const CLI::Option* each) { return each->count() > 0; })) {
    const std::string name = option->get_name();
    if (taken.get_option_no_throw(name) == nullptr && std::ranges::find(kTaken, name) == kTaken.end()) {
      throw InputError("a light-field display takes no " + name, "--device " + choice.device,
                       "leave it out; beside the scene there are --seconds, --speed and --loop");
    }
  }
  if (!choice.isScene() || choice.isVolume()) {
    throw InputError("a light-field display shows views of a scene, and no volumes", choice.scene.source,
                     "give a scene, or a reference image (.exr)");
  }
}

/// Waits in steps that notice a signal.
bool waitUntil(PictureDevice& device, double seconds) {
  constexpr double kStep = 0.1;
  const Clock::time_point start = Clock::now();
  bool open = true;
  while (open && !InterruptGuard::interrupted() && secondsAfter(start) < seconds) {
    open = device.wait(std::min(kStep, seconds - secondsAfter(start)));
  }
  return open && !InterruptGuard::interrupted();
}

/// Each frame is a new quilt: as many as there is time for.
void play(PictureDevice& device, SceneMotion& motion, const PresentChoice& choice, const QuiltViews& views,
          const CommandContext& context) {
  const QuiltWay& way = quiltWayNamed(QuiltChoice().by, "--device");
  MotionClock clock(motion.durationSeconds(), {.speed = choice.speed, .loop = choice.loop});
  const Clock::time_point start = Clock::now();
  size_t frames = 0;
  const InterruptGuard guard;
  for (bool open = true; open && !InterruptGuard::interrupted();) {
    const std::optional<double> at = clock.at(Clock::now());
    if (!at || (choice.seconds && secondsAfter(start) >= *choice.seconds)) {
      break;
    }
    Mesh scene = motion.at(*at);
    views.stretchScene(scene, views.stretch());
    device.show(way.make({views, scene, QuiltImageOptions{}, QuiltDepths::kNone, {}}).color);
    ++frames;
    open = device.wait(0);
  }
  context.note(fmt::format("showed {} quilts in {:.1f} s", frames, secondsAfter(start)));
}

}  // namespace

void presentQuilt(const PresentChoice& choice, const CLI::App& command, const CommandContext& context) {
  refuseOtherOptions(choice, command, context);
  // Read before the display goes dark.
  QuiltChoice quilt;
  quilt.scene = choice.scene;
  const std::unique_ptr<SceneMotion> motion =
      choice.mayPlay() ? loadMotion(choice.scene.source, choice.scene.options, context.progress()) : nullptr;
  const std::unique_ptr<PictureDevice> device = openPictureDevice(choice.device);
  const QuiltViews views(device->display(), View{});
  context.note(fmt::format("showing {}; Escape ends it", device->description()));
  if (motion != nullptr) {
    play(*device, *motion, choice, views, context);
    return;
  }
  const QuiltSource source(quilt, views, context);
  device->show(source.picture(views, QuiltDepths::kNone, context.progress()).color);
  context.clearProgress();
  const InterruptGuard guard;
  waitUntil(*device, choice.seconds.value_or(std::numeric_limits<double>::infinity()));
}

}  // namespace ocelli
