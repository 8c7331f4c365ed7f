#include "display_sim/viewer/viewer_script.h"

#include <cmath>
#include <functional>
#include <map>

#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"

namespace ocelli {
namespace {

constexpr int kMinSide = 64;
constexpr int kMaxSide = 8192;
constexpr double kMinScale = 0.5;
constexpr double kMaxScale = 4;
constexpr double kMaxSeconds = 600;
constexpr double kMaxScroll = 100;
constexpr double kMaxIso = 1e30;

glm::dvec2 readPair(JsonFields& fields, const std::string& name, double least, double most) {
  const nlohmann::json& value = fields.value(name);
  glm::dvec2 pair(0);
  if (!value.is_array() || value.size() != 2) {
    fields.fail(name, "must be an array of two numbers");
  }
  for (int i = 0; i < 2; ++i) {
    const nlohmann::json& element = value[static_cast<size_t>(i)];
    if (!element.is_number() || !(element.get<double>() >= least && element.get<double>() <= most)) {
      fields.fail(name, "must be an array of two numbers between " + std::to_string(static_cast<int>(least)) + " and " +
                            std::to_string(static_cast<int>(most)));
    }
    pair[i] = element.get<double>();
  }
  return pair;
}

glm::dvec2 readPlace(JsonFields& fields, const std::string& name) {
  return readPair(fields, name, 0, kMaxSide);
}

glm::ivec2 readSize(JsonFields& fields) {
  const glm::dvec2 size = readPair(fields, "size", kMinSide, kMaxSide);
  if (size.x != std::floor(size.x) || size.y != std::floor(size.y)) {
    fields.fail("size", "must be an array of two whole numbers");
  }
  return size;
}

double readScale(JsonFields& fields) {
  return fields.number("scale", kMinScale, kMaxScale, 1);
}

PointerButton readButton(JsonFields& fields) {
  const std::string name = fields.text("button", "left");
  if (name == "left") {
    return PointerButton::kLeft;
  }
  if (name == "right") {
    return PointerButton::kRight;
  }
  if (name == "middle") {
    return PointerButton::kMiddle;
  }
  fields.fail("button", "must be left, right or middle");
}

std::string readName(JsonFields& fields, const std::string& name) {
  std::string text = fields.text(name);
  if (text.empty()) {
    fields.fail(name, "must not be empty");
  }
  return text;
}

ScriptStep readKey(JsonFields& fields) {
  std::string name = fields.text("key");
  KeyStep step;
  const auto takes = [&](const std::string& prefix) {
    if (!name.starts_with(prefix)) {
      return false;
    }
    name = name.substr(prefix.size());
    return true;
  };
  for (bool found = true; found;) {
    const bool shift = takes("Shift+");
    const bool control = takes("Ctrl+");
    const bool alt = takes("Alt+");
    step.modifiers = {step.modifiers.shift || shift, step.modifiers.control || control, step.modifiers.alt || alt};
    found = shift || control || alt;
  }
  const std::optional<Key> key = keyFromName(name);
  if (!key) {
    fields.fail("key",
                "must be a key such as H, 1, F1, Left, PageUp, Escape, Space, Minus, Comma, with Shift+, Ctrl+ or "
                "Alt+ before it, not \"" +
                    name + "\"");
  }
  step.key = *key;
  return step;
}

/// The object that a field holds.
ScriptStep readInside(JsonFields& fields, const std::string& name, const std::string& where,
                      const std::function<ScriptStep(JsonFields&)>& read) {
  JsonFields inside(fields.value(name), where + ", field \"" + name + "\"");
  ScriptStep step = read(inside);
  inside.rejectUnknown();
  return step;
}

std::string readFileName(JsonFields& fields, const std::string& name, const std::string& ending = ".png") {
  const std::string file = readName(fields, name);
  if (!file.ends_with(ending)) {
    fields.fail(name, "must be a file that ends in " + ending);
  }
  return file;
}

ScriptStep readShow(JsonFields& fields) {
  const std::string name = fields.text("show");
  std::string known;
  for (const EffectShown::Content content : kEffectContents) {
    if (name == nameOf(content)) {
      return ShowStep{content};
    }
    known += (known.empty() ? "" : ", ") + std::string(nameOf(content));
  }
  fields.fail("show", "must be one of: " + known);
}

ScriptStep readIso(JsonFields& fields) {
  if (fields.value("iso").is_null()) {
    return IsoStep{};
  }
  return IsoStep{fields.number("iso", -kMaxIso, kMaxIso)};
}

ScriptStep readWait(JsonFields& fields) {
  if (fields.text("wait") != "idle") {
    fields.fail("wait", "must be \"idle\"");
  }
  return WaitStep{};
}

using StepReader = std::function<ScriptStep(JsonFields& fields, const std::string& where)>;

const std::map<std::string, StepReader>& stepReaders() {
  static const std::map<std::string, StepReader> readers{
      {"open", [](JsonFields& fields, const auto&) { return OpenStep{readName(fields, "open")}; }},
      {"camera", [](JsonFields& fields, const auto&) { return CameraStep{readName(fields, "camera")}; }},
      {"drop", [](JsonFields& fields, const auto&) { return DropStep{readName(fields, "drop")}; }},
      {"key", [](JsonFields& fields, const auto&) { return readKey(fields); }},
      {"text", [](JsonFields& fields, const auto&) { return TypeStep{fields.text("text")}; }},
      {"move", [](JsonFields& fields, const auto&) { return MoveStep{readPlace(fields, "move")}; }},
      {"click",
       [](JsonFields& fields, const std::string& where) {
         return readInside(fields, "click", where, [](JsonFields& inside) {
           return ClickStep{readPlace(inside, "at"), readButton(inside)};
         });
       }},
      {"drag",
       [](JsonFields& fields, const std::string& where) {
         return readInside(fields, "drag", where, [](JsonFields& inside) {
           return DragStep{readPlace(inside, "from"), readPlace(inside, "to"), readButton(inside)};
         });
       }},
      {"scroll",
       [](JsonFields& fields, const std::string& where) {
         return readInside(fields, "scroll", where, [](JsonFields& inside) {
           return ScrollStep{readPlace(inside, "at"), inside.number("up", -kMaxScroll, kMaxScroll)};
         });
       }},
      {"resize",
       [](JsonFields& fields, const std::string& where) {
         return readInside(fields, "resize", where, [](JsonFields& inside) {
           const glm::ivec2 size = readSize(inside);
           return ResizeStep{size.x, size.y, readScale(inside)};
         });
       }},
      {"wait", [](JsonFields& fields, const auto&) { return readWait(fields); }},
      {"seconds",
       [](JsonFields& fields, const auto&) { return SecondsStep{fields.number("seconds", 0, kMaxSeconds)}; }},
      {"effect",
       [](JsonFields& fields, const std::string& where) {
         return readInside(fields, "effect", where, [](JsonFields& inside) {
           const std::string name = readName(inside, "name");
           return EffectStep{name, inside.has("by") ? readName(inside, "by") : ""};
         });
       }},
      {"show", [](JsonFields& fields, const auto&) { return readShow(fields); }},
      {"save", [](JsonFields& fields, const auto&) { return SaveStep{readFileName(fields, "save")}; }},
      {"save_effect",
       [](JsonFields& fields, const auto&) { return SaveEffectStep{readFileName(fields, "save_effect")}; }},
      {"save_lenses",
       [](JsonFields& fields, const auto&) { return SaveLensPictureStep{readFileName(fields, "save_lenses")}; }},
      {"transfer", [](JsonFields& fields, const auto&) { return TransferStep{readName(fields, "transfer")}; }},
      {"iso", [](JsonFields& fields, const auto&) { return readIso(fields); }},
      {"save_volume",
       [](JsonFields& fields, const auto&) { return SaveVolumePictureStep{readFileName(fields, "save_volume")}; }},
      {"save_transfer", [](JsonFields& fields,
                           const auto&) { return SaveTransferStep{readFileName(fields, "save_transfer", ".json")}; }},
      {"save_camera",
       [](JsonFields& fields, const auto&) { return SaveCameraStep{readFileName(fields, "save_camera", ".json")}; }},
  };
  return readers;
}

std::string stepNames() {
  std::string names;
  for (const auto& [name, reader] : stepReaders()) {
    names += (names.empty() ? "" : ", ") + name;
  }
  return names;
}

ScriptStep readStep(const nlohmann::json& json, const std::string& where) {
  if (!json.is_object() || json.size() != 1) {
    throw InputError("a step is an object with one field", where, "use one of: " + stepNames());
  }
  const std::string name = json.begin().key();
  const auto reader = stepReaders().find(name);
  if (reader == stepReaders().end()) {
    throw InputError("field \"" + name + "\" is unknown", where, "use one of: " + stepNames());
  }
  JsonFields fields(json, where);
  return reader->second(fields, where);
}

}  // namespace

ViewerScript viewerScriptFromJsonText(const std::string& text, const std::string& where) {
  return readAs("display_sim/viewer/viewer_script.schema.json", [&] {
    const nlohmann::json json = parseJson(text, where);
    JsonFields fields(json, where);
    ViewerScript script;
    if (fields.has("size")) {
      const glm::ivec2 size = readSize(fields);
      script.width = size.x;
      script.height = size.y;
    }
    script.scale = readScale(fields);
    const nlohmann::json& steps = fields.value("steps");
    if (!steps.is_array()) {
      fields.fail("steps", "must be an array of objects");
    }
    for (size_t i = 0; i < steps.size(); ++i) {
      script.steps.push_back(readStep(steps[i], where + ", step " + std::to_string(i + 1)));
    }
    fields.rejectUnknown();
    return script;
  });
}

ViewerScript readViewerScript(const std::filesystem::path& path) {
  return viewerScriptFromJsonText(readJsonFile(path).dump(), path.string());
}

}  // namespace ocelli
