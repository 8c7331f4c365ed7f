#include "display_sim/viewer/display_pane.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "display_sim/viewer/shaders.h"
#include "display_sim/viewer/viewer_colors.h"
#include "oc_core/base/error.h"
#include "oc_core/gl/gl_api.h"
#include "oc_core/gl/gl_program.h"

namespace ocelli {
namespace {

constexpr int kRimSegments = 96;
constexpr int kGainImageSide = 256;

double sliceSeconds(const DisplayProfile& profile) {
  return 30 / profile.rotationsPerMinute / profile.slicesPerHalfTurn;
}

/// The place on the screen at an angle: `outward` from -1 to 1, `up` from -1 to 1.
glm::vec3 onScreen(const DisplayProfile& profile, double degrees, double outward, double up) {
  const double t = radiansFromDegrees(degrees);
  return {outward * std::cos(t), up * profile.halfHeightRadii, outward * std::sin(t)};
}

}  // namespace

double shownExposure(const DisplayShown& shown, const DisplayProfile& profile) {
  const double refresh = 1 / profile.refreshHertz();
  return std::clamp(shown.persistenceSeconds * shown.speed, std::min(sliceSeconds(profile), refresh), refresh);
}

DisplayPane::DisplayPane(GlContext& context)
    : context_(&context),
      target_(context),
      lineDraw_(context),
      program_(makeProgram(context, "light of the display",
                           {{GL_VERTEX_SHADER, {shaders::kScreenVertex}},
                            {GL_FRAGMENT_SHADER, {shaders::kEncode, shaders::kLightFragment}}})),
      vertexArray_(makeVertexArray(context)) {}

void DisplayPane::draw(const ViewerState& state, const ViewerData& data, const glm::ivec2& size, float lineScale) {
  target_.begin(size.x, size.y, rgb(kSpaceColor));
  problem_.clear();
  if (!data.volume) {
    return;
  }
  const Volume& volume = data.volume->volume;
  const DisplayProfile& profile = volume.profile();
  View view = displayView(state);
  view.target = {0, 0, 0};  // an observer looks at the middle of the display
  ObserverOptions options{.eye = view.eye, .width = size.x, .height = size.y};
  options.fovVerticalDegrees = displayView(state).resolvedFovVerticalDegrees();
  options.missingSectorStartDegrees = state.display.sweepDegrees;
  try {
    if (gainVersion_ != data.version) {  // seen from in front, so that it does not change while the eye moves
      gain_ = automaticGain(collectLight(volume, {.eye = {0, 0, static_cast<float>(profile.viewingDistanceRadii())},
                                                  .width = kGainImageSide,
                                                  .height = kGainImageSide}));
      gainVersion_ = data.version;
    }
    options.exposureSeconds = shownExposure(state.display, profile);
    const double slowness = 1 / (options.exposureSeconds * profile.refreshHertz());
    showLight(collectLight(volume, options), gain_ * state.display.gain * std::min(slowness, kMostSlowMotionGain));
  } catch (const InputError&) {
    problem_ = "your eye is inside of the display";
    return;
  }
  view.fovVerticalDegrees = options.fovVerticalDegrees;
  const float reach = glm::length(view.eye) + 2 + static_cast<float>(profile.halfHeightRadii);
  lineDraw_.draw(lines(state.display, profile, lineScale), {view, size.x, size.y}, {view.zNear, reach}, 1);
}

void DisplayPane::showLight(const Image<glm::vec3>& light, double gain) {
  const GladGLContext& gl = context_->gl();
  const glm::ivec2 size(light.width(), light.height());
  if (size != lightSize_) {
    light_ = makeTexture(*context_, GL_RGB32F, size.x, size.y);
    lightSize_ = size;
  }
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.TextureSubImage2D(light_.id(), 0, 0, 0, size.x, size.y, GL_RGB, GL_FLOAT, light.data());
  gl.ProgramUniform1f(program_.id(), 0, static_cast<float>(gain));
  gl.Disable(GL_DEPTH_TEST);
  gl.UseProgram(program_.id());
  gl.BindVertexArray(vertexArray_.id());
  gl.BindTextureUnit(0, light_.id());
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
  gl.Enable(GL_DEPTH_TEST);
  context_->check("showing the display");
}

std::vector<ColoredLine> DisplayPane::lines(const DisplayShown& shown, const DisplayProfile& profile,
                                            float lineScale) const {
  std::vector<ColoredLine> lines;
  const glm::vec4 rim = withOpacity(kDisplayColor, 0.45f);
  for (const double up : {-1.0, 1.0}) {
    std::vector<glm::vec3> circle;
    for (int i = 0; i <= kRimSegments; ++i) {
      circle.push_back(onScreen(profile, 360.0 * i / kRimSegments, 1, up));
    }
    addPolyline(lines, circle, rim, lineScale);
  }
  lines.push_back({onScreen(profile, 0, 0, -1), onScreen(profile, 0, 0, 1), withOpacity(kDisplayColor, 0.3f), lineScale});
  // A fast screen is a blur that nobody sees.
  const auto sharpness = static_cast<float>(std::clamp(0.2 / shown.speed, 0.0, 1.0));
  const bool visible = !shown.running || sharpness > 0.25f;
  if (visible) {
    const glm::vec4 color = withOpacity(kDisplayColor, shown.running ? sharpness : 1);
    const auto corner = [&](double outward, double up) { return onScreen(profile, shown.sweepDegrees, outward, up); };
    addPolyline(lines, {corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1), corner(-1, -1)}, color,
                1.75f * lineScale);
  }
  return lines;
}

}  // namespace ocelli
