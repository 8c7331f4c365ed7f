// Colours of the built-in scenes: saturated, told apart by colour-blind people (after Okabe and Ito, 2008), and with
// some light in each channel, because a display that dithers to one bit a channel shows a pure one badly. Given in
// sRGB.
#pragma once

#include <glm/vec3.hpp>

#include "oc_core/image/color.h"

namespace ocelli::palette {

inline glm::vec3 fromSrgbBytes(int red, int green, int blue) {
  return linearFromSrgb(glm::vec3(red, green, blue) / 255.0f);
}

inline glm::vec3 orange() {
  return fromSrgbBytes(240, 165, 40);
}
inline glm::vec3 skyBlue() {
  return fromSrgbBytes(95, 185, 238);
}
inline glm::vec3 green() {
  return fromSrgbBytes(40, 170, 125);
}
inline glm::vec3 yellow() {
  return fromSrgbBytes(245, 232, 85);
}
inline glm::vec3 blue() {
  return fromSrgbBytes(40, 120, 190);
}
inline glm::vec3 vermilion() {
  return fromSrgbBytes(225, 105, 45);
}
inline glm::vec3 purple() {
  return fromSrgbBytes(212, 130, 175);
}
inline glm::vec3 ivory() {
  return fromSrgbBytes(245, 236, 212);
}
inline glm::vec3 brick() {
  return fromSrgbBytes(176, 88, 62);
}
inline glm::vec3 mortar() {
  return fromSrgbBytes(214, 200, 180);
}
inline glm::vec3 slate() {
  return fromSrgbBytes(62, 88, 118);
}

}  // namespace ocelli::palette
