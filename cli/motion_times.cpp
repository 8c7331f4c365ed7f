#include "cli/motion_times.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>

#include "cli/number_check.h"
#include "oc_core/base/error.h"

namespace ocelli {

void addFrameRateOption(CLI::App& command, std::optional<double>& hertz, const std::string& help) {
  command.add_option("--frames-per-second", hertz, help)->check(numberCheck(1e-3, 1e4))->type_name("HERTZ");
}

FramedMotion loadFramedMotion(const SceneChoice& scene, double hertz, const CommandContext& context) {
  if (scene.options.motion.seconds) {
    throw InputError("this is one moment of a motion, or all of it", "--time",
                     "leave it out; for a single moment leave --frames-per-second out");
  }
  FramedMotion framed;
  framed.motion = mayMove(scene.source) ? loadMotion(scene.source, scene.options, context.progress()) : nullptr;
  if (framed.motion == nullptr) {
    throw InputError("this scene stands still", scene.source,
                     "leave --frames-per-second out, and write a single frame");
  }
  constexpr double kMaxMotionFrames = 100'000;
  const double frames = std::max(1.0, std::round(framed.motion->durationSeconds() * hertz));
  if (!(frames <= kMaxMotionFrames)) {
    throw InputError(fmt::format("{:g} frames are more than {:g}", frames, kMaxMotionFrames), "--frames-per-second",
                     "choose a lower rate");
  }
  for (double i = 0; i < frames; ++i) {
    framed.seconds.push_back(i / hertz);
  }
  return framed;
}

}  // namespace ocelli
