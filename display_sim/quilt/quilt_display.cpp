#include "display_sim/quilt/quilt_display.h"

#include <fmt/format.h>

#include <cstdio>

#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"

namespace ocelli {
namespace {

constexpr const char* kSchema = "display_sim/quilt/quilt_display.schema.json";

/// A field of a display, described once: reader, writer and schema come from it.
struct QuiltField {
  const char* name;
  const char* meaning;
  double min;
  double max;
  int QuiltDisplay::*integer;
  double QuiltDisplay::*number;
  bool isRequired;
};

const std::vector<QuiltField>& quiltFields() {
  static const std::vector<QuiltField> fields{
      {"columns", "Tiles beside each other", 1, 64, &QuiltDisplay::columns, nullptr, true},
      {"rows", "Tiles above each other", 1, 64, &QuiltDisplay::rows, nullptr, true},
      {"width", "Pixels of the quilt", 2, kMaxQuiltSide, &QuiltDisplay::width, nullptr, true},
      {"height", "Pixels of the quilt", 2, kMaxQuiltSide, &QuiltDisplay::height, nullptr, true},
      {"aspect", "Width to height of what the display shows", 0.1, 10, nullptr, &QuiltDisplay::aspect, true},
      {"cone_degrees",
       "Angle between the outermost views, as seen from the middle of the display: `viewCone` of its calibration",
       kMinConeDegrees, kMaxConeDegrees, nullptr, &QuiltDisplay::coneDegrees, false},
  };
  return fields;
}

// As the maker publishes them. For the 32 inch display in portrait its texts disagree: 11 x 6 or 12 x 4 tiles.
std::vector<QuiltDisplay> builtinQuiltDisplays() {
  return {
      {"go", 11, 6, 4092, 4092, 0.5625}, {"portrait", 8, 6, 3360, 3360, 0.75},
      {"16", 7, 7, 5999, 5999, 1.777},   {"16-portrait", 11, 6, 5995, 6000, 0.5625},
      {"27", 8, 6, 7680, 4320, 1.777},   {"27-portrait", 12, 4, 7680, 4320, 0.5625},
      {"32", 7, 7, 8190, 8190, 1.777},   {"65", 8, 9, 8192, 8192, 1.777},
  };
}

Registry<QuiltDisplay>& quiltRegistry() {
  static Registry<QuiltDisplay> registry("light-field display", builtinQuiltDisplays());
  return registry;
}

double valueOf(const QuiltField& field, const QuiltDisplay& display) {
  return field.integer != nullptr ? display.*field.integer : display.*field.number;
}

}  // namespace

Rows<QuiltDisplay> quiltDisplays() {
  return quiltRegistry().rows();
}

void registerQuiltDisplay(QuiltDisplay display) {
  validate(display, "display \"" + display.name + "\"");
  quiltRegistry().add(std::move(display));
}

void validate(const QuiltDisplay& display, const std::string& where) {
  for (const QuiltField& field : quiltFields()) {
    const double value = valueOf(field, display);
    if (!(value >= field.min && value <= field.max)) {
      throw InputError(fmt::format("\"{}\" must be between {:g} and {:g}", field.name, field.min, field.max), where,
                       std::string("see ") + kSchema);
    }
  }
  if (display.viewCount() < 2) {
    throw InputError("a quilt has at least two views", where, "raise \"columns\" or \"rows\"");
  }
  if (display.tileWidth() < 1 || display.tileHeight() < 1) {
    throw InputError("a tile of this quilt would have no pixel", where, "raise \"width\" or \"height\"");
  }
}

QuiltDisplay quiltDisplayFromJsonText(const std::string& text, const std::string& where) {
  return readAs(kSchema, [&] {
    const JsonDocument document(text, where);
    JsonFields fields(document);
    QuiltDisplay display;
    display.name = fields.shortText("name", 64);
    for (const QuiltField& field : quiltFields()) {
      if (!field.isRequired && !fields.has(field.name)) {
        continue;
      }
      if (field.integer != nullptr) {
        display.*field.integer = fields.integer(field.name, static_cast<int>(field.min), static_cast<int>(field.max));
      } else {
        display.*field.number = fields.number(field.name, field.min, field.max);
      }
    }
    fields.rejectUnknown();
    validate(display, where);
    return display;
  });
}

std::string jsonText(const QuiltDisplay& display) {
  nlohmann::ordered_json json;
  json["name"] = display.name;
  for (const QuiltField& field : quiltFields()) {
    if (field.integer != nullptr) {
      json[field.name] = display.*field.integer;
    } else {
      json[field.name] = display.*field.number;
    }
  }
  return textOfJson(json);
}

std::string quiltDisplaySchemaText() {
  using Json = nlohmann::ordered_json;
  Json properties{{"$schema", {{"type", "string"}}}, {"comment", {{"type", "string"}}}};
  properties["name"] = {
      {"description", "What files and messages call it"}, {"type", "string"}, {"minLength", 1}, {"maxLength", 64}};
  Json required{"name"};
  const QuiltDisplay standard;
  for (const QuiltField& field : quiltFields()) {
    Json property{{"description", field.meaning}, {"type", field.integer != nullptr ? "integer" : "number"}};
    if (field.integer != nullptr) {
      property["minimum"] = static_cast<int>(field.min);
      property["maximum"] = static_cast<int>(field.max);
    } else {
      property["minimum"] = field.min;
      property["maximum"] = field.max;
    }
    if (field.isRequired) {
      required.push_back(field.name);
    } else {
      property["default"] = valueOf(field, standard);
    }
    properties[field.name] = property;
  }
  const Json schema{{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                    {"title", "Ocelli light-field display"},
                    {"description", "A display that takes quilts. Made from the table of fields in quilt_display.cpp."},
                    {"type", "object"},
                    {"additionalProperties", false},
                    {"required", required},
                    {"properties", properties}};
  return schema.dump(2) + "\n";
}

QuiltDisplay loadQuiltDisplay(const std::string& nameOrFile) {
  std::string names;
  for (const QuiltDisplay& display : quiltDisplays()) {
    if (display.name == nameOrFile) {
      return display;
    }
    names += (names.empty() ? "" : ", ") + display.name;
  }
  if (nameOrFile.ends_with(".json")) {
    return quiltDisplayFromJsonText(readJsonFile(nameOrFile).dump(), nameOrFile);
  }
  throw InputError("there is no light-field display of this name", "\"" + nameOrFile + "\"",
                   "one of " + names + ", or a .json file");
}

glm::ivec2 tileOriginOf(const QuiltDisplay& display, int view) {
  const int row = view / display.columns;  // from the bottom
  return {view % display.columns * display.tileWidth(), display.height - (row + 1) * display.tileHeight()};
}

std::string quiltSuffix(const QuiltDisplay& display) {
  return fmt::format("_qs{}x{}a{:.5g}", display.columns, display.rows, display.aspect);
}

std::string quiltFileName(const std::string& path, const QuiltDisplay& display) {
  const size_t dot = path.rfind('.');
  const size_t end = dot == std::string::npos || path.find('/', dot) != std::string::npos ? path.size() : dot;
  const std::string stem = path.substr(0, end);
  const std::string ours = quiltSuffix(display);
  const size_t mark = stem.rfind("_qs");
  const std::string given = mark == std::string::npos ? "" : stem.substr(mark);
  int columns = 0;
  int rows = 0;
  double aspect = 0;
  int length = 0;
  if (std::sscanf(given.c_str(), "_qs%dx%da%lf%n", &columns, &rows, &aspect, &length) != 3 ||
      static_cast<size_t>(length) != given.size()) {
    return stem + ours + path.substr(end);
  }
  if (given != ours) {
    throw InputError("this name says another quilt than " + display.name + " takes, which is " + ours, path,
                     "leave " + given + " out of the name: the right one is added");
  }
  return path;
}

}  // namespace ocelli
