// What the effect pane asks for, as plain data.
#pragma once

#include <glm/vec2.hpp>
#include <string>

#include "display_sim/viewer/viewer_state.h"

namespace ocelli {

struct EffectWanted {
  bool on = false;     ///< otherwise nothing is kept
  bool shows = false;  ///< whether pictures are wanted: not of a pane that is hidden

  std::string source;
  SceneOptions sceneOptions;
  uint64_t sceneRevision = 0;  ///< another one where the scene, its options or its file are others
  std::string rolesFile;       ///< empty: that of the scene
  int rolesRead = 0;           ///< as in EffectShown
  std::string effect;          ///< empty: the first one that the scene has objects for; then nothing is drawn
  std::string way;
  glm::ivec2 referenceSize{0};  ///< of reference images, pixels; 0: the effect's
  int environmentHeight = 0;    ///< rows of environment maps

  View view;           ///< of the picture
  glm::ivec2 size{0};  ///< of the picture, pixels
  EffectShown::Content content = EffectShown::Content::kByWay;

  bool hasSameScene(const EffectWanted& other) const {
    return sceneRevision == other.sceneRevision && source == other.source && rolesFile == other.rolesFile &&
           rolesRead == other.rolesRead;
  }
  bool hasSameStage(const EffectWanted& other) const {
    return hasSameScene(other) && effect == other.effect && referenceSize == other.referenceSize &&
           environmentHeight == other.environmentHeight;
  }
  bool hasSameWay(const EffectWanted& other) const { return hasSameStage(other) && way == other.way; }
  bool hasSamePicture(const EffectWanted& other) const {
    return hasSameWay(other) && view == other.view && size == other.size;
  }
  bool operator==(const EffectWanted& other) const {
    return on == other.on && shows == other.shows && hasSamePicture(other) && content == other.content;
  }
};

}  // namespace ocelli
