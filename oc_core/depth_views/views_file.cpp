#include "oc_core/depth_views/views_file.h"

#include <set>

#include "oc_core/base/check.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/depth_views/views_fields.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;

constexpr size_t kMaxFileNameCharacters = 255;

float depthOr(JsonFields& fields, const std::vector<ViewsField>& rows, const char* name, float otherwise) {
  const ViewsField& row = fieldNamed(rows, name);
  if (!fields.has(name)) {
    return otherwise;
  }
  return static_cast<float>(fields.number(name, row.least, row.most));
}

/// Of a file of the folder itself: nothing that leads out of it.
std::string fileIn(JsonFields& fields, const char* name) {
  const std::string file = fields.shortText(name, kMaxFileNameCharacters);
  if (fs::path(file).filename() != file || file == "." || file == ".." || file.find('\0') != std::string::npos) {
    fields.fail(name, "must be the name of a file in the folder");
  }
  return file;
}

ListedView readListedView(JsonFields& fields, const DepthLevels& otherwise) {
  ListedView listed;
  listed.colorFile = fileIn(fields, "color");
  listed.depthFile = fileIn(fields, "depth");
  listed.name = fields.shortText("name", kMaxViewNameCharacters, fs::path(listed.colorFile).stem().string());
  listed.view = viewFromJsonText(fields.value("view").dump(), fields.where() + ", \"view\"");
  listed.levels = otherwise;
  listed.levels.near = depthOr(fields, depthViewFields(), "near", otherwise.near);
  listed.levels.far = depthOr(fields, depthViewFields(), "far", otherwise.far);
  if (!(listed.levels.near > 0) || !(listed.levels.far > 0)) {
    fields.fail(listed.levels.near > 0 ? "far" : "near", "is missing, here and for all views");
  }
  if (!(listed.levels.near < listed.levels.far)) {
    fields.fail("near", "must be less than \"far\"");
  }
  return listed;
}

}  // namespace

std::vector<ListedView> viewsFromJsonText(const std::string& text, const std::string& where) {
  return readAs("oc_core/depth_views/views.schema.json", [&] {
    const JsonDocument document(text, where);
    JsonFields fields(document);
    fields.integer("format", kViewsFormat, kViewsFormat);
    DepthLevels levels;
    const DepthScale chosen = fields.choiceOf("depth_scale", depthScales(), depthScales()[0]);
    for (const DepthScale& scale : depthScales()) {
      if (scale.name == chosen.name) {
        levels.scale = &scale;
      }
    }
    levels.near = depthOr(fields, viewsFileFields(), "near", 0);
    levels.far = depthOr(fields, viewsFileFields(), "far", 0);
    std::vector<ListedView> views;
    std::set<std::string> names;
    fields.forEach("views", 1, kMaxDepthViews, [&](JsonFields& each) {
      views.push_back(readListedView(each, levels));
      if (!names.insert(views.back().name).second) {
        each.fail("name", "\"" + views.back().name + "\" is the name of an earlier view too");
      }
    });
    fields.rejectUnknown();
    return views;
  });
}

std::string viewsJsonText(const std::vector<ListedView>& views) {
  OC_CHECK(!views.empty(), "a file lists a view at least");
  nlohmann::ordered_json json{{"format", kViewsFormat}, {"depth_scale", views.front().levels.scale->name}};
  json["views"] = nlohmann::ordered_json::array();
  for (const ListedView& listed : views) {
    json["views"].push_back({{"name", listed.name},
                             {"color", listed.colorFile},
                             {"depth", listed.depthFile},
                             {"near", listed.levels.near},
                             {"far", listed.levels.far},
                             {"view", nlohmann::ordered_json::parse(jsonText(listed.view))}});
  }
  return textOfJson(json, 2) + "\n";
}

}  // namespace ocelli
