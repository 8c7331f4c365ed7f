#include "study/task/controls.h"

#include <algorithm>
#include <array>
#include <utility>

#include "oc_core/base/json_fields.h"

namespace ocelli {
namespace {

/// What these do is the same in all studies.
bool isReserved(Key key) {
  const std::array reserved{Key::kUp,     Key::kDown, Key::kLeft,   Key::kRight,    Key::kEnter,
                            Key::kEscape, Key::kTab,  Key::kDelete, Key::kBackspace};
  return std::find(reserved.begin(), reserved.end(), key) != reserved.end() || (key >= Key::k0 && key <= Key::k9) ||
         (key >= Key::kF1 && key <= Key::kF12);
}

void readKey(JsonFields& fields, const char* name, Key& key) {
  if (!fields.has(name)) {
    return;
  }
  const std::string text = fields.text(name);
  const std::optional<Key> given = keyFromName(text);
  if (!given) {
    fields.fail(name, "is \"" + text + "\", which is no key; keys are A to Z, Space, Minus, Comma, Home, ...");
  }
  if (isReserved(*given)) {
    fields.fail(name, "is \"" + text + "\", but arrows, digits, F keys, Enter, Escape and Tab have a meaning already");
  }
  key = *given;
}

}  // namespace

Controls readControls(JsonFields& fields) {
  Controls controls;
  const std::array<std::pair<const char*, Key*>, 7> keys{{{"forward", &controls.forward},
                                                          {"backward", &controls.backward},
                                                          {"left", &controls.left},
                                                          {"right", &controls.right},
                                                          {"turn_left", &controls.turnLeft},
                                                          {"turn_right", &controls.turnRight},
                                                          {"select", &controls.select}}};
  for (const auto& [name, key] : keys) {
    readKey(fields, name, *key);
  }
  for (size_t i = 0; i < keys.size(); ++i) {
    for (size_t k = 0; k < i; ++k) {
      if (*keys[i].second == *keys[k].second) {
        fields.fail(keys[i].first, "is the same key as \"" + std::string(keys[k].first) + "\"");
      }
    }
  }
  controls.walkMetersPerSecond = fields.number("walk_meters_per_second", 0.1, 20, controls.walkMetersPerSecond);
  controls.turnDegreesPerSecond = fields.number("turn_degrees_per_second", 5, 720, controls.turnDegreesPerSecond);
  controls.mouseDegreesPerPixel = fields.number("mouse_degrees_per_pixel", 0.001, 5, controls.mouseDegreesPerPixel);
  controls.pointerPixelsPerSecond =
      fields.number("pointer_pixels_per_second", 10, 10000, controls.pointerPixelsPerSecond);
  controls.eyeHeightMeters = fields.number("eye_height_meters", 0.05, 50, controls.eyeHeightMeters);
  controls.bodyRadiusMeters = fields.number("body_radius_meters", 0.02, 20, controls.bodyRadiusMeters);
  fields.rejectUnknown();
  return controls;
}

}  // namespace ocelli
