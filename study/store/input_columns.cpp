#include "study/store/input_columns.h"

#include <array>
#include <nlohmann/json.hpp>

namespace ocelli {
namespace {

constexpr int kShift = 1;
constexpr int kControl = 2;
constexpr int kAlt = 4;

// In the order of PointerButton.
constexpr std::array<const char*, 3> kButtons{"left", "right", "middle"};

int numberOf(const Modifiers& modifiers) {
  return (modifiers.shift ? kShift : 0) + (modifiers.control ? kControl : 0) + (modifiers.alt ? kAlt : 0);
}

Modifiers modifiersOf(const InputColumns& columns) {
  const int number = columns.modifiers.value_or(0);
  return {(number & kShift) != 0, (number & kControl) != 0, (number & kAlt) != 0};
}

struct ToColumns {
  InputColumns operator()(const KeyEvent& e) const {
    return {"key", std::string(nameOf(e.key)), e.pressed, numberOf(e.modifiers)};
  }
  InputColumns operator()(const TextEvent& e) const {
    return withJson("text", {{"character", static_cast<uint32_t>(e.character)}});
  }
  InputColumns operator()(const PointerMoveEvent& e) const { return {"pointer_move", {}, {}, {}, e.x, e.y}; }
  InputColumns operator()(const PointerButtonEvent& e) const {
    return {"pointer_button", kButtons[static_cast<size_t>(e.button)], e.pressed, numberOf(e.modifiers)};
  }
  InputColumns operator()(const ScrollEvent& e) const { return {"scroll", {}, {}, {}, e.right, e.up}; }
  InputColumns operator()(const ResizeEvent& e) const {
    return withJson("resize", {{"width", e.width},
                               {"height", e.height},
                               {"pixels_per_unit", e.pixelsPerUnit},
                               {"content_scale", e.contentScale}});
  }
  // Their names are nobody's business.
  InputColumns operator()(const DropEvent& e) const { return withJson("drop", {{"files", e.files.size()}}); }
  InputColumns operator()(const CloseEvent&) const { return {"close"}; }

  static InputColumns withJson(const char* kind, const nlohmann::json& json) {
    return {kind, {}, {}, {}, {}, {}, json.dump()};
  }
};

std::optional<PointerButton> buttonFromName(const std::string& name) {
  for (size_t i = 0; i < kButtons.size(); ++i) {
    if (kButtons[i] == name) {
      return static_cast<PointerButton>(i);
    }
  }
  return std::nullopt;
}

}  // namespace

InputColumns columnsOf(const InputEvent& event) {
  return std::visit(ToColumns{}, event);
}

std::optional<InputEvent> eventOf(const InputColumns& columns) {
  if (columns.kind == "key") {
    const std::optional<Key> key = keyFromName(columns.what.value_or(""));
    return key ? std::optional<InputEvent>(KeyEvent{*key, columns.pressed.value_or(true), modifiersOf(columns)})
               : std::nullopt;
  }
  if (columns.kind == "pointer_button") {
    const std::optional<PointerButton> button = buttonFromName(columns.what.value_or(""));
    return button ? std::optional<InputEvent>(
                        PointerButtonEvent{*button, columns.pressed.value_or(true), modifiersOf(columns)})
                  : std::nullopt;
  }
  if (columns.kind == "pointer_move") {
    return PointerMoveEvent{columns.x.value_or(0), columns.y.value_or(0)};
  }
  if (columns.kind == "scroll") {
    return ScrollEvent{columns.x.value_or(0), columns.y.value_or(0)};
  }
  if (columns.kind == "close") {
    return CloseEvent{};
  }
  const nlohmann::json json = nlohmann::json::parse(columns.moreJson.value_or(""), nullptr, false);
  if (!json.is_object()) {
    return std::nullopt;
  }
  if (columns.kind == "text") {
    return TextEvent{static_cast<char32_t>(json.value("character", 0u))};
  }
  if (columns.kind == "resize") {
    return ResizeEvent{json.value("width", 0), json.value("height", 0), json.value("pixels_per_unit", 1.0),
                       json.value("content_scale", 1.0)};
  }
  if (columns.kind == "drop") {
    return DropEvent{std::vector<std::string>(json.value("files", size_t{0}))};
  }
  return std::nullopt;
}

}  // namespace ocelli
