#include "oc_core/depth_views/views_fields.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "oc_core/base/check.h"
#include "oc_core/base/json_document.h"
#include "oc_core/depth_views/depth_levels.h"

namespace ocelli {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kMinDepth = 1e-6;
constexpr double kMaxDepth = 1e6;

Json objectOf(const std::vector<ViewsField>& fields) {
  Json object{{"type", "object"}, {"additionalProperties", false}};
  object["properties"] = {{"$schema", {{"type", "string"}}}, {"comment", {{"type", "string"}}}};
  Json required = Json::array();
  for (const ViewsField& field : fields) {
    Json property{
        {"description", std::string(field.meaning) + (*field.unit == '\0' ? "" : std::string(" (") + field.unit + ")")},
        {"type", field.type}};
    if (std::string(field.type) == "string") {
      property["minLength"] = 1;
    } else if (std::string(field.type) == "integer") {
      property["minimum"] = static_cast<int>(field.least);
      property["maximum"] = static_cast<int>(field.most);
    } else {
      property["minimum"] = field.least;
      property["maximum"] = field.most;
    }
    object["properties"][field.name] = property;
    if (field.isRequired) {
      required.push_back(field.name);
    }
  }
  object["required"] = required;
  return object;
}

}  // namespace

const std::vector<ViewsField>& viewsFileFields() {
  static const std::vector<ViewsField> fields{
      {"format", "integer", "", "Version of this format", true, kViewsFormat, kViewsFormat},
      {"near", "number", "units of the views", "Smallest z that levels stand for, of views that say no other", false,
       kMinDepth, kMaxDepth},
      {"far", "number", "units of the views", "Largest z that levels stand for; more than near", false, kMinDepth,
       kMaxDepth},
  };
  return fields;
}

const std::vector<ViewsField>& depthViewFields() {
  static const std::vector<ViewsField> fields{
      {"name", "string", "", "What messages and other files call it; that of its colours' file where none is given",
       false},
      {"color", "string", "", "PNG file of its colours (sRGB), in the folder", true},
      {"depth", "string", "",
       "PNG file of its depths: grey, 16 bits, of the same size, in the folder; level 0 where nothing is seen", true},
      {"near", "number", "units of the views", "Of this view alone", false, kMinDepth, kMaxDepth},
      {"far", "number", "units of the views", "Of this view alone", false, kMinDepth, kMaxDepth},
  };
  return fields;
}

const ViewsField& fieldNamed(const std::vector<ViewsField>& fields, const std::string& name) {
  const auto found =
      std::find_if(fields.begin(), fields.end(), [&](const ViewsField& field) { return field.name == name; });
  OC_CHECK(found != fields.end(), "every field that is read has its row");
  return *found;
}

std::string viewsSchemaText() {
  Json schema{
      {"$schema", "https://json-schema.org/draft/2020-12/schema"},
      {"title", "Ocelli views with depth"},
      {"description",
       "views.json of a folder of colour and depth images (docs/views_with_depth.md). y is up, right-handed; z of "
       "a pixel is its distance along the view direction, not along its ray. Made from the rows of "
       "oc_core/depth_views/views_fields.cpp."}};
  schema.update(objectOf(viewsFileFields()));
  Json names = Json::array();
  std::string meaning = "What levels of depth are:";
  for (const DepthScale& scale : depthScales()) {
    names.push_back(scale.name);
    meaning += std::string(" ") + scale.name + ": " + scale.meaning + ".";
  }
  schema["properties"]["depth_scale"] = {{"description", meaning}, {"enum", names}, {"default", names[0]}};
  Json view = objectOf(depthViewFields());
  view["properties"]["view"] = {{"$ref", "../camera/view.schema.json"}};
  view["required"].push_back("view");
  schema["properties"]["views"] = {{"type", "array"}, {"minItems", 1}, {"maxItems", kMaxDepthViews}, {"items", view}};
  schema["required"].push_back("views");
  return textOfJson(schema, 2) + "\n";
}

}  // namespace ocelli
