#include "display_sim/viewer/display_pane.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "display_sim/viewer/shaders.h"
#include "display_sim/viewer/viewer_colors.h"
#include "oc_core/base/error.h"
#include "oc_core/gl/gl_api.h"
#include "oc_core/gl/gl_program.h"
#include "oc_core/gl/shaders.h"

namespace ocelli {
namespace {

constexpr int kRimSegments = 96;
constexpr int kGainImageSide = 256;

double focalPixels(const ObserverOptions& options) {
  return options.height / 2.0 / std::tan(radiansFromDegrees(options.fovVerticalDegrees) / 2);
}

/// The place on the screen at an angle: `outward` from -1 to 1, `up` from -1 to 1.
glm::vec3 onScreen(const DisplayProfile& profile, double degrees, double outward, double up) {
  const double t = radiansFromDegrees(degrees);
  return {outward * std::cos(t), up * profile.halfHeightRadii, outward * std::sin(t)};
}

/// A fast screen is a blur that nobody sees.
bool showsScreen(const DisplayShown& shown) {
  constexpr double kFastest = 0.5;
  return !shown.running || shown.speed <= kFastest;
}

/// The display itself: its rims, its axis, and the screen.
std::vector<ColoredLine> linesOf(const DisplayShown& shown, const DisplayProfile& profile, float lineScale) {
  std::vector<ColoredLine> lines;
  const glm::vec4 rim = withOpacity(kDisplayColor, 0.45f);
  for (const double up : {-1.0, 1.0}) {
    std::vector<glm::vec3> circle;
    for (int i = 0; i <= kRimSegments; ++i) {
      circle.push_back(onScreen(profile, 360.0 * i / kRimSegments, 1, up));
    }
    addPolyline(lines, circle, rim, lineScale);
  }
  lines.push_back(
      {onScreen(profile, 0, 0, -1), onScreen(profile, 0, 0, 1), withOpacity(kDisplayColor, 0.3f), lineScale});
  if (showsScreen(shown)) {
    const glm::vec4 color = opaque(kDisplayColor);
    const auto corner = [&](double outward, double up) { return onScreen(profile, shown.sweepDegrees, outward, up); };
    addPolyline(lines, {corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1), corner(-1, -1)}, color,
                1.75f * lineScale);
  }
  return lines;
}

}  // namespace

ShownSweep shownSweep(const DisplayShown& shown, const DisplayProfile& profile) {
  const double step = kPi / profile.slicesPerHalfTurn;
  const double refresh = step * profile.storedSlices();
  const double radiansPerSecond = shown.speed * profile.rotationsPerMinute / 60 * 2 * kPi;
  const double fade = std::max(shown.persistenceSeconds * radiansPerSecond, step);
  const double end = radiansFromDegrees(shown.sweepDegrees);
  if (fade >= refresh) {
    return {{.endRadians = end, .sweptRadians = refresh}, 1};
  }
  constexpr double kFades = 6;  // e^-6 of the light is too little to see
  const double swept = std::min(kFades * fade, refresh);
  return {{.endRadians = end, .sweptRadians = swept, .fadeRadians = fade},
          std::min(refresh / fade, kMaxSlowMotionGain)};
}

bool looksSteady(const DisplayShown& shown, const DisplayProfile& profile) {
  return !showsScreen(shown) && shownSweep(shown, profile).window.fadeRadians == 0;
}

DisplayPane::DisplayPane(GlContext& context)
    : context_(&context),
      target_(context),
      lineDraw_(context),
      program_(makeProgram(context, "light of the display",
                           {{GL_VERTEX_SHADER, {shaders::kScreenVertex}},
                            {GL_FRAGMENT_SHADER, {shaders::kEncode, shaders::kLightFragment}}})),
      vertexArray_(makeVertexArray(context)),
      observer_(context) {}

/// The gain is that of a view from in front, so that it does not change while the eye moves.
void DisplayPane::look(const SlicedVolume& volume) {
  glVolume_.reset();
  glVolume_.emplace(*context_, volume.volume);
  observer_.look(*glVolume_);
  const DisplayProfile& profile = volume.volume.profile();
  GlObserverOptions front;
  front.view.eye = {0, 0, static_cast<float>(profile.viewingDistanceRadii())};
  front.view.width = front.view.height = kGainImageSide;
  front.view.fovVerticalDegrees = degreesFromRadians(2 * std::asin(1 / profile.viewingDistanceRadii()));
  observer_.draw(front);
  gain_ = automaticGain(observer_.readLight()) / std::pow(focalPixels(front.view), 2);
}

bool DisplayPane::draw(const ViewerState& state, const ViewerData& data, const glm::ivec2& size, float lineScale) {
  DisplayShown shown = state.display;
  if (data.volume && looksSteady(shown, data.volume->volume.profile())) {
    shown.sweepDegrees = 0;
  }
  const Key key{data.volume, shown, displayView(state), size, lineScale};
  if (key == drawn_) {
    return false;
  }
  drawn_ = key;
  problem_.clear();
  if (data.volume != volume_) {
    volume_.reset();
    if (data.volume) {
      look(*data.volume);
    }
    volume_ = data.volume;
  }
  if (!volume_) {
    target_.begin(size.x, size.y, rgb(kSpaceColor));
    return true;
  }
  const DisplayProfile& profile = volume_->volume.profile();
  View view = displayView(state);
  const ShownSweep sweep = shownSweep(shown, profile);
  GlObserverOptions options;
  options.view.eye = view.eye;
  options.view.width = size.x;
  options.view.height = size.y;
  options.view.fovVerticalDegrees = view.resolvedFovVerticalDegrees();
  options.window = sweep.window;
  try {
    observer_.draw(options);
  } catch (const InputError&) {
    target_.begin(size.x, size.y, rgb(kSpaceColor));
    problem_ = "your eye is inside of the display";
    return true;
  }
  target_.begin(size.x, size.y, rgb(kSpaceColor));
  showLight(gain_ * std::pow(focalPixels(options.view), 2) * sweep.gain * shown.gain);
  view.target = {0, 0, 0};  // an observer looks at the middle of the display
  view.up = {0, 1, 0};
  view.fovVerticalDegrees = options.view.fovVerticalDegrees;
  const float reach = glm::length(view.eye) + 2 + static_cast<float>(profile.halfHeightRadii);
  lineDraw_.draw(linesOf(shown, profile, lineScale), {view, size.x, size.y}, {view.zNear, reach}, 1);
  return true;
}

void DisplayPane::showLight(double gain) {
  const GladGLContext& gl = context_->gl();
  gl.ProgramUniform1f(program_.id(), 0, static_cast<float>(gain));
  gl.Disable(GL_DEPTH_TEST);
  gl.UseProgram(program_.id());
  gl.BindVertexArray(vertexArray_.id());
  gl.BindTextureUnit(0, observer_.light().id());
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
  gl.Enable(GL_DEPTH_TEST);
  context_->check("showing the display");
}

}  // namespace ocelli
