// A scene with the roles of its objects, an effect in it, and two ways to draw that: the one that is chosen, and the
// traced one. Everything about effects comes from their table (oc_core/shade/effects.h).
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "display_sim/viewer/effect_wanted.h"
#include "oc_core/base/progress.h"
#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/image/png_file.h"

namespace ocelli {

/// Used by one thread.
class EffectModel {
 public:
  EffectModel();
  ~EffectModel();
  EffectModel(const EffectModel&) = delete;
  EffectModel& operator=(const EffectModel&) = delete;

  /// Makes what differs from what stands, which goes first: there is never one of a kind twice. Where no effect is
  /// named, it is only found out which. What `progress` throws goes through. Throws InputError where the scene cannot
  /// be loaded or has no roles, no object has the role of the effect, or the effect does not take this way.
  void build(const EffectWanted& wanted, const Progress& progress);
  void buildTraced(const Progress& progress);
  void clear();

  /// Of the effect that was built, or that would be.
  const std::string& effect() const { return effect_; }
  const View& home() const { return home_; }

  /// What `ocelli shade -o` writes for the camera. Built before. Throws InputError where the effect has no picture of
  /// this view.
  Image<Rgb8> drawByWay(const PinholeCamera& camera) const;
  Image<Rgb8> drawTraced(const PinholeCamera& camera) const;

 private:
  struct Made;
  std::unique_ptr<Made> made_;
  std::string effect_;
  View home_;
};

/// Whether something says the roles of the objects of a scene: itself, or a file beside it.
bool sceneHasRoles(const std::string& source);

}  // namespace ocelli
