// A small scene with a mirror, for tests of the effect pane: what it asks for, and what `ocelli shade` draws of it.
#pragma once

#include "display_sim/viewer/effect_wanted.h"
#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/image/png_file.h"
#include "oc_core/shade/effects.h"

namespace ocelli::test {

inline constexpr const char* kSmallScene = "builtin:teapot,segments=4";
/// A ball that mirrors, beside the teapot.
inline constexpr const char* kMirrorRoles = R"({"objects": [{"object": 0, "roles": ["cast"]},
    {"source": "builtin:sphere", "center": [1.3, 0.2, -0.6], "radius": 0.5, "roles": ["mirror"]}]})";

/// As `ocelli shade --by WAY` draws it.
inline Image<Rgb8> shadedPicture(const EffectWanted& wanted, const std::string& way) {
  const Effect& effect = shadeEffect(wanted.effect);
  StageInputs inputs{.scene = std::make_shared<const ShadedScene>(loadShadedScene(
                         wanted.source, rolesFor(wanted.source, wanted.rolesFile), wanted.sceneOptions)),
                     .referenceSize = wanted.referenceSize};
  inputs.environmentHeight = wanted.environmentHeight;
  return srgbFromLinear(
      effect.stage(inputs)->build(way)->draw(PinholeCamera(wanted.view, wanted.size.x, wanted.size.y)));
}

}  // namespace ocelli::test
