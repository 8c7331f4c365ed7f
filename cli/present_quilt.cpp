#include "cli/present_quilt.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "cli/interrupt.h"
#include "cli/quilt_choice.h"
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

void refuseOptionsOfVolumes(const PresentChoice& choice) {
  const bool given = !choice.profile.empty() || choice.turn || !choice.eyes.empty() || choice.hasCamera() ||
                     !choice.record.empty() || !choice.timeLine.empty() || choice.tear || choice.coarse ||
                     choice.simulated.given() || choice.shown.given();
  if (given || !choice.isScene() || choice.isVolume()) {
    throw InputError("a light-field display shows views of a scene, and no volumes", choice.device,
                     "give a scene or an image, with --seconds, --speed and --loop alone");
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

void play(PictureDevice& device, SceneMotion& motion, const PresentChoice& choice, const QuiltViews& views,
          const CommandContext& context) {
  const QuiltWay& way = quiltWayNamed("eoc-h", "--device");
  const double length = motion.durationSeconds();
  const Clock::time_point start = Clock::now();
  size_t frames = 0;
  const InterruptGuard guard;
  for (bool open = true; open && !InterruptGuard::interrupted();) {
    const double passed = secondsAfter(start);
    double at = passed * choice.speed;
    if ((choice.seconds && passed >= *choice.seconds) || (!choice.loop && at >= length)) {
      break;
    }
    at = length > 0 ? std::fmod(at, length) : 0;
    Mesh scene = motion.at(at);
    views.stretchScene(scene, views.stretch());
    device.show(way.make({views, scene, QuiltImageOptions{}, QuiltDepths::kNone, {}}).color);
    ++frames;
    open = device.wait(0);
  }
  context.note(fmt::format("showed {} quilts in {:.1f} s", frames, secondsAfter(start)));
}

}  // namespace

void presentQuilt(const PresentChoice& choice, const CommandContext& context) {
  refuseOptionsOfVolumes(choice);
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
