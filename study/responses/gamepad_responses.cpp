// A gamepad: buttons, directional pad, left stick and triggers as keys. The system tells of no changes: it is looked at
// every few milliseconds, so that a press is known as late as that.
#include <fmt/format.h>

#include <array>
#include <atomic>
#include <map>
#include <mutex>
#include <utility>

#include "oc_core/base/error.h"
#include "oc_core/base/steady_time.h"
#include "study/responses/key_map.h"
#include "study/responses/response_device.h"

namespace ocelli {
namespace {

/// A stick or trigger counts as pressed from here on, and as released below the other: it may tremble between them.
constexpr double kPressed = 0.5;
constexpr double kReleased = 0.35;

enum class PartKind { kButton, kAxis };
struct GamepadPart {
  const char* name;
  PartKind kind;
  size_t index;     ///< of GamepadState
  double sign;      ///< of an axis
  const char* key;  ///< where no map is given; empty for none
};
constexpr std::array kParts{
    GamepadPart{"South", PartKind::kButton, 0, 1, "Space"},    GamepadPart{"East", PartKind::kButton, 1, 1, "Enter"},
    GamepadPart{"West", PartKind::kButton, 2, 1, ""},          GamepadPart{"North", PartKind::kButton, 3, 1, ""},
    GamepadPart{"LeftBumper", PartKind::kButton, 4, 1, ""},    GamepadPart{"RightBumper", PartKind::kButton, 5, 1, ""},
    GamepadPart{"Back", PartKind::kButton, 6, 1, ""},          GamepadPart{"Start", PartKind::kButton, 7, 1, "Enter"},
    GamepadPart{"LeftStick", PartKind::kButton, 9, 1, ""},     GamepadPart{"RightStick", PartKind::kButton, 10, 1, ""},
    GamepadPart{"Up", PartKind::kButton, 11, 1, "Up"},         GamepadPart{"Right", PartKind::kButton, 12, 1, "Right"},
    GamepadPart{"Down", PartKind::kButton, 13, 1, "Down"},     GamepadPart{"Left", PartKind::kButton, 14, 1, "Left"},
    GamepadPart{"StickRight", PartKind::kAxis, 0, 1, "Right"}, GamepadPart{"StickLeft", PartKind::kAxis, 0, -1, "Left"},
    GamepadPart{"StickDown", PartKind::kAxis, 1, 1, "Down"},   GamepadPart{"StickUp", PartKind::kAxis, 1, -1, "Up"},
    GamepadPart{"LeftTrigger", PartKind::kAxis, 4, 1, ""},     GamepadPart{"RightTrigger", PartKind::kAxis, 5, 1, ""},
};

bool isPressed(const GamepadPart& part, const GamepadState& state, bool before) {
  if (part.kind == PartKind::kButton) {
    return state.buttons[part.index];
  }
  return part.sign * static_cast<double>(state.axes[part.index]) > (before ? kReleased : kPressed);
}

using GamepadMap = std::array<std::optional<Key>, kParts.size()>;

GamepadMap gamepadMapFromText(const std::string& text, const std::string& where) {
  GamepadMap map;
  if (text.empty()) {
    for (size_t i = 0; i < kParts.size(); ++i) {
      map[i] = keyFromName(kParts[i].key);
    }
    return map;
  }
  std::string names;
  for (const GamepadPart& part : kParts) {
    names += std::string(names.empty() ? "" : ", ") + part.name;
  }
  for (const KeyMapEntry& entry : keyMapFromText(text, where)) {
    const auto* const part =
        std::find_if(kParts.begin(), kParts.end(), [&](const GamepadPart& p) { return entry.from == p.name; });
    if (part == kParts.end() || entry.releases) {
      throw InputError("\"" + entry.from + "\" is no part of a gamepad, or its key has a \"-\"", where,
                       "one of: " + names);
    }
    map[static_cast<size_t>(part - kParts.begin())] = entry.key;
  }
  return map;
}

class GamepadResponses : public ResponseDevice {
 public:
  GamepadResponses(const GamepadMap& map, std::function<std::optional<GamepadState>()> read, std::string name)
      : map_(map), read_(std::move(read)), name_(std::move(name)) {}

  bool mustBePolled() const override { return true; }
  void poll() override {
    const std::optional<GamepadState> state = read_();
    const int64_t now = steadyNanoseconds();
    connected_ = state.has_value();
    for (size_t i = 0; i < kParts.size(); ++i) {
      const bool pressed = state && isPressed(kParts[i], *state, down_[i]);
      if (pressed != std::exchange(down_[i], pressed)) {
        change(map_[i], pressed, now);
      }
    }
  }
  std::vector<KeyChange> take() override {
    const std::scoped_lock lock(mutex_);
    return std::exchange(changes_, {});
  }
  bool isConnected() const override { return connected_; }
  ResponseCounts counts() const override {
    const std::scoped_lock lock(mutex_);
    return counts_;
  }
  std::string description() const override { return "gamepad: " + name_; }

 private:
  /// Several parts may have one key: it is down as long as one of them is.
  void change(std::optional<Key> key, bool pressed, int64_t now) {
    const std::scoped_lock lock(mutex_);
    if (!key) {
      counts_.unknown += pressed ? 1 : 0;
      return;
    }
    int& parts = partsDown_[*key];
    const bool before = parts > 0;
    parts += pressed ? 1 : -1;
    if (before != (parts > 0)) {
      counts_.presses += pressed ? 1 : 0;
      changes_.push_back({*key, pressed, now});
    }
  }

  // Of the main thread.
  GamepadMap map_;
  std::function<std::optional<GamepadState>()> read_;
  std::string name_;
  std::array<bool, kParts.size()> down_{};
  std::map<Key, int> partsDown_{};
  std::atomic<bool> connected_{true};
  mutable std::mutex mutex_;
  std::vector<KeyChange> changes_{};  ///< guarded, as all below
  ResponseCounts counts_{};
};

std::unique_ptr<ResponseDevice> openGamepad(const std::string& text, const ResponseTools& tools) {
  const std::string where = text.empty() ? "--responses gamepad" : "--responses gamepad:" + text;
  const GamepadMap map = gamepadMapFromText(text, where);
  const std::optional<GamepadState> state = tools.readGamepad ? tools.readGamepad() : std::nullopt;
  if (!state) {
    throw WorkError("there is no gamepad", where,
                    "connect one, and check that you may read it (group input); joysticks that the system does not "
                    "know as gamepads are not read");
  }
  return std::make_unique<GamepadResponses>(map, tools.readGamepad, state->name);
}

}  // namespace

ResponseDeviceKind gamepadResponses() {
  return {
      "gamepad", "gamepad[:BUTTON=KEY,...]",
      "the first gamepad. Without a map the directional pad and the left stick are the arrows, South is Space, East "
      "and Start are Enter",
      openGamepad};
}

}  // namespace ocelli
