#include "oc_core/ocri/camera_schema.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "oc_core/base/json_fields.h"
#include "oc_core/ocri/representation_kind.h"

namespace ocelli {
namespace {

using Json = nlohmann::ordered_json;

/// Every option once, in the order of the first row that takes it.
std::vector<const CameraOption*> allOptions() {
  std::vector<const CameraOption*> all;
  for (const RepresentationKind& kind : representationKinds()) {
    for (const CameraOption* option : kind.options) {
      if (std::find(all.begin(), all.end(), option) == all.end()) {
        all.push_back(option);
      }
    }
  }
  return all;
}

std::vector<const CameraStructure*> allStructures() {
  std::vector<const CameraStructure*> all;
  for (const RepresentationKind& kind : representationKinds()) {
    for (const CameraStructure* each : kind.structures) {
      if (std::find(all.begin(), all.end(), each) == all.end()) {
        all.push_back(each);
      }
    }
  }
  return all;
}

/// As short as it reads back: 0.1, not 0.10000000149011612.
double shortest(double value) {
  return std::stod(fmt::format("{}", static_cast<float>(value)));
}

Json limit(const CameraOption& option, double value) {
  return isInteger(option) ? Json(static_cast<int>(value)) : Json(value);
}

/// The default that all of them share. Options that are off by default have none.
Json defaultOf(const CameraOption& option) {
  const CameraChoice choice;
  if (option.onOff.isOn != nullptr) {
    return {};
  }
  if (isDirection(option)) {
    const glm::vec3 direction = directionOf(option, choice);
    return {shortest(direction.x), shortest(direction.y), shortest(direction.z)};
  }
  if (isBoolean(option)) {
    return numberOf(option, choice) != 0;
  }
  return isInteger(option) ? Json(static_cast<int>(numberOf(option, choice)))
                           : Json(shortest(numberOf(option, choice)));
}

Json propertyOf(const CameraOption& option) {
  Json property;
  property["description"] = *option.unit == '\0' ? option.meaning : fmt::format("{} ({})", option.meaning, option.unit);
  if (isDirection(option)) {
    property["type"] = "array";
    property["minItems"] = 3;
    property["maxItems"] = 3;
    property["items"] = {{"type", "number"}, {"minimum", option.min}, {"maximum", option.max}};
  } else if (isBoolean(option)) {
    property["type"] = "boolean";
  } else {
    property["type"] = isInteger(option) ? "integer" : "number";
    property["minimum"] = limit(option, option.min);
    property["maximum"] = limit(option, option.max);
  }
  const Json standard = defaultOf(option);
  if (!standard.is_null()) {
    property["default"] = standard;
  }
  return property;
}

/// The names of a row as a schema: its own, and those with other numbers.
Json namesOf(const std::vector<const RepresentationKind*>& kinds, bool withShortForms) {
  Json own = Json::array();
  Json anyOf = Json::array();
  for (const RepresentationKind* kind : kinds) {
    own.push_back(kind->name);
    if (withShortForms && *kind->otherName != '\0') {
      own.push_back(kind->otherName);
    }
    if (kind->maxCount > 0) {
      const std::string name = kind->name;
      std::vector<int> numbers(static_cast<size_t>(kind->maxCount));
      std::iota(numbers.begin(), numbers.end(), 1);
      const std::string stem = name.substr(0, name.rfind('-') + 1);
      anyOf.push_back({{"type", "string"}, {"pattern", fmt::format("^{}({})$", stem, fmt::join(numbers, "|"))}});
    }
  }
  anyOf.insert(anyOf.begin(), Json{{"enum", own}});
  return anyOf.size() == 1 ? anyOf.front() : Json{{"anyOf", anyOf}};
}

/// One rule for all kinds that take the same options.
Json rules() {
  std::vector<std::vector<const RepresentationKind*>> groups;
  for (const RepresentationKind& kind : representationKinds()) {
    const auto same = std::find_if(groups.begin(), groups.end(), [&](const auto& group) {
      return group.front()->options == kind.options && group.front()->structures == kind.structures;
    });
    if (same == groups.end()) {
      groups.push_back({&kind});
    } else {
      same->push_back(&kind);
    }
  }
  Json all = Json::array();
  for (const std::vector<const RepresentationKind*>& kinds : groups) {
    Json allowed{"$schema", "comment", "camera", "name"};
    for (const CameraOption* option : kinds.front()->options) {
      allowed.push_back(option->name);
    }
    for (const CameraStructure* structure : kinds.front()->structures) {
      allowed.push_back(structure->name);
    }
    all.push_back({{"if", {{"properties", {{"camera", namesOf(kinds, true)}}}}},
                   {"then", {{"propertyNames", {{"enum", allowed}}}}}});
  }
  return all;
}

/// `list` is that of a row which `option` may stand in.
template <class Option>
std::string takersOf(const Option& option, std::vector<const Option*> RepresentationKind::*list) {
  std::string names;
  for (const RepresentationKind& kind : representationKinds()) {
    if (std::find((kind.*list).begin(), (kind.*list).end(), &option) != (kind.*list).end()) {
      names += fmt::format("{}`{}`", names.empty() ? "" : ", ", kind.name);
    }
  }
  return names;
}

}  // namespace

std::string cameraSchemaText() {
  std::vector<const RepresentationKind*> kinds;
  for (const RepresentationKind& kind : representationKinds()) {
    kinds.push_back(&kind);
  }
  Json properties{{"$schema", {{"type", "string"}}}, {"comment", {{"type", "string"}}}};
  properties["camera"] = {{"description",
                           "One of the names that `ocelli ocri build --help` lists; docs/cameras.md and "
                           "docs/choosing.md say what they are"}};
  properties["camera"].update(namesOf(kinds, true));
  properties["name"] = {{"description", "What tables and files call it; the camera's where it is missing"},
                        {"type", "string"}};
  for (const CameraOption* option : allOptions()) {
    properties[option->name] = propertyOf(*option);
  }
  for (const CameraStructure* structure : allStructures()) {
    Json property{{"description", structure->meaning}};
    property.update(Json::parse(structure->schema()));
    properties[structure->name] = property;
  }
  const Json schema{{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                    {"title", "Ocelli camera"},
                    {"description",
                     "A camera that builds reference images, and its options. Pixels are those of the "
                     "reference image. Made from the table of options; see camera_schema.h."},
                    {"type", "object"},
                    {"additionalProperties", false},
                    {"required", {"camera"}},
                    {"allOf", rules()},
                    {"properties", properties}};
  return schema.dump(2) + "\n";
}

std::string cameraOptionTable() {
  std::string table = "| option | default | unit | meaning | cameras |\n| --- | ---: | --- | --- | --- |\n";
  for (const CameraOption* option : allOptions()) {
    const Json standard = defaultOf(*option);
    table += fmt::format("| `{}` | {} | {} | {} | {} |\n", option->name, standard.is_null() ? "off" : standard.dump(),
                         option->unit, option->meaning, takersOf(*option, &RepresentationKind::options));
  }
  for (const CameraStructure* structure : allStructures()) {
    table += fmt::format("| `{}` | `{}` |  | {} | {} |\n", structure->name, structure->text(CameraChoice()),
                         structure->meaning, takersOf(*structure, &RepresentationKind::structures));
  }
  return table;
}

}  // namespace ocelli
