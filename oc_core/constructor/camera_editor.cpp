#include "oc_core/constructor/camera_editor.h"

#include <algorithm>
#include <set>

#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/constructor/curved_bends.h"
#include "oc_core/constructor/graph_operations.h"

namespace ocelli {
namespace {

using Json = nlohmann::ordered_json;

bool isEditable(const std::string& camera) {
  return camera == "graph" || camera == "curved";
}

/// The document of one kind of camera, as edits see it.
class Document {
 public:
  explicit Document(const std::string& text) : json_(Json::parse(text, nullptr, true, true)) {}

  std::string text() const { return json_.dump(1); }

  /// Within several edits, one may meet what another has made, which is no camera yet, and need not have any field.
  void apply(JsonFields& edit) {
    try {
      applyOne(edit);
    } catch (const nlohmann::json::exception&) {
      edit.fail("edit", "meets what is no frustum or turn");
    }
  }

 private:
  void applyOne(JsonFields& edit) {
    const std::string kind = edit.text("edit");
    if (kind == "add") {
      const char* what = isGraph() ? "operation" : "turn";
      list().push_back(Json::parse(edit.value(what).dump()));
    } else if (kind == "remove") {
      remove(edit.text("name"), edit);
    } else if (kind == "change") {
      change(edit.text("name"), edit);
    } else if (kind == "rename") {
      rename(edit.text("name"), edit.text("to"), edit);
    } else if (kind == "view") {
      json_["view"] = Json::parse(edit.value("view").dump());
    } else if (kind == "limits") {
      replaceLimits(edit.text("name"), edit);
    } else if (kind == "overlap") {
      requireGraph(edit);
      json_["overlap"] = edit.text("overlap");
    } else if (kind == "several") {
      applySeveral(edit);
    } else {
      edit.fail("edit", "must be add, remove, change, rename, view, limits, overlap, several, undo or redo");
    }
    edit.rejectUnknown();
  }

  bool isGraph() const { return json_.at("camera") == "graph"; }
  Json& list() { return json_.at(isGraph() ? "operations" : "turns"); }
  void requireGraph(const JsonFields& edit) const {
    if (!isGraph()) {
      edit.fail("edit", "is one of a graph camera");
    }
  }

  /// What an operation makes, and a turn is: objects with a name.
  static std::vector<Json*> namedIn(Json& entry) {
    std::vector<Json*> named;
    if (!entry.contains("into")) {
      if (entry.contains("name")) {
        named.push_back(&entry);
      }
    } else if (entry["into"].is_array()) {
      for (Json& each : entry["into"]) {
        named.push_back(&each);
      }
    } else {
      named.push_back(&entry["into"]);
    }
    return named;
  }

  Json& find(const std::string& name, const JsonFields& edit) {
    for (Json& entry : list()) {
      for (Json* named : namedIn(entry)) {
        if (named->at("name") == name) {
          return *named;
        }
      }
    }
    edit.fail("name", "is \"" + name + "\", which nothing is called");
  }

  /// Whether an operation acts on one of these.
  static bool actsOn(const Json& entry, const std::set<std::string>& names) {
    if (!entry.contains("of")) {
      return false;
    }
    const Json& of = entry["of"];
    return of.is_array() ? std::any_of(of.begin(), of.end(), [&](const Json& each) { return names.contains(each); })
                         : names.contains(of);
  }

  /// With what comes from it; the other half of a split goes as well, as a split makes both.
  void remove(const std::string& name, const JsonFields& edit) {
    find(name, edit);
    std::set<std::string> gone{name};
    for (size_t before = 0; before != gone.size();) {
      before = gone.size();
      for (Json& entry : list()) {
        const std::vector<Json*> named = namedIn(entry);
        const bool makesOne =
            std::any_of(named.begin(), named.end(), [&](const Json* each) { return gone.contains(each->at("name")); });
        if (makesOne || actsOn(entry, gone)) {
          for (const Json* each : named) {
            gone.insert(each->at("name"));
          }
        }
      }
    }
    Json kept = Json::array();
    for (Json& entry : list()) {
      const std::vector<Json*> named = namedIn(entry);
      const bool makesOne =
          std::any_of(named.begin(), named.end(), [&](const Json* each) { return gone.contains(each->at("name")); });
      if (!makesOne && !actsOn(entry, gone)) {
        kept.push_back(entry);
      }
    }
    list() = kept;
  }

  /// Frusta take them anew at the end of the list: their order does not matter.
  void replaceLimits(const std::string& name, JsonFields& edit) {
    requireGraph(edit);
    const nlohmann::json& planes = edit.value("planes");
    if (!planes.is_array()) {
      edit.fail("planes", "must be an array of planes");
    }
    Json kept = Json::array();
    for (Json& entry : list()) {
      const bool isOne = entry.value("operation", "") == "limit" && entry.value("of", Json()) == name;
      if (!isOne) {
        kept.push_back(entry);
      }
    }
    for (const nlohmann::json& plane : planes) {
      kept.push_back({{"operation", "limit"}, {"of", name}, {"plane", Json::parse(plane.dump())}});
    }
    list() = kept;
  }

  void applySeveral(JsonFields& edit) {
    const nlohmann::json& edits = edit.value("edits");
    if (!edits.is_array()) {
      edit.fail("edits", "must be an array of edits");
    }
    size_t number = 0;
    for (const nlohmann::json& each : edits) {
      JsonFields inner(each, edit.where() + ", edit " + std::to_string(++number));
      if (inner.text("edit") == "several") {
        inner.fail("edit", "is \"several\" within \"several\"");
      }
      apply(inner);
    }
  }

  void change(const std::string& name, JsonFields& edit) {
    const nlohmann::json& to = edit.value("to");
    if (!to.is_object() || to.contains("name")) {
      edit.fail("to", "must be an object of fields other than \"name\"");
    }
    Json& named = find(name, edit);
    for (const auto& [field, value] : to.items()) {
      named[field] = Json::parse(value.dump());
    }
  }

  void rename(const std::string& name, const std::string& to, const JsonFields& edit) {
    find(name, edit)["name"] = to;
    for (Json& entry : list()) {
      if (!entry.contains("of")) {
        continue;
      }
      if (entry["of"].is_array()) {
        for (Json& each : entry["of"]) {
          each = each == name ? Json(to) : each;
        }
      } else if (entry["of"] == name) {
        entry["of"] = to;
      }
    }
  }

  Json json_;
};

}  // namespace

CameraEditor::CameraEditor(const std::string& text, const std::string& where, const PinholeCamera& reference,
                           const Box& world)
    : reference_(reference), world_(world), texts_{text}, camera_(cameraOf(text, where, reference, world)) {}

MultiperspectiveCamera CameraEditor::cameraOf(const std::string& text, const std::string& where,
                                              const PinholeCamera& reference, const Box& world) {
  return readAs("docs/graph_cameras.md", [&] {
    const nlohmann::json json = parseJson(text, where);
    JsonFields fields(json, where);
    const std::string kind = fields.text("camera");
    if (!isEditable(kind)) {
      fields.fail("camera", "must be graph or curved for edits");
    }
    MultiperspectiveCamera camera = kind == "graph" ? MultiperspectiveCamera(readGraphCamera(fields, reference, world))
                                                    : MultiperspectiveCamera(readCurvedRayCamera(fields, reference));
    fields.rejectUnknown();
    return camera;
  });
}

void CameraEditor::apply(const std::string& text, const std::string& where) {
  readAs("docs/graph_cameras.md#step-by-step", [&] { applyEdit(text, where); });
}

std::string CameraEditor::edited(const std::string& text, const std::string& where) const {
  return readAs("docs/graph_cameras.md#step-by-step", [&] {
    const nlohmann::json json = parseJson(text, where);
    JsonFields edit(json, where);
    Document document(this->text());
    document.apply(edit);
    return document.text();
  });
}

void CameraEditor::applyEdit(const std::string& text, const std::string& where) {
  const nlohmann::json json = parseJson(text, where);
  JsonFields edit(json, where);
  const std::string kind = edit.text("edit");
  if (kind == "undo" || kind == "redo") {
    edit.rejectUnknown();
    if (kind == "undo" ? !canUndo() : !canRedo()) {
      edit.fail("edit", "has nothing to " + kind);
    }
    at_ += kind == "undo" ? -size_t{1} : size_t{1};
    camera_ = cameraOf(texts_[at_], where, reference_, world_);
    return;
  }
  Document document(this->text());
  document.apply(edit);
  camera_ = cameraOf(document.text(), where, reference_, world_);
  texts_.resize(at_ + 1);
  texts_.push_back(document.text());
  ++at_;
}

std::string editableText(const std::string& nameOrFile, const MultiperspectiveCamera& constructed) {
  if (nameOrFile.ends_with(".json")) {
    const std::string text = readFile(nameOrFile, kMaxTextBytes);
    const nlohmann::json json = parseJson(text, nameOrFile);
    JsonFields fields(json, nameOrFile);
    if (isEditable(fields.text("camera"))) {
      return text;
    }
  }
  return std::visit([](const auto& each) { return jsonText(each); }, constructed);
}

}  // namespace ocelli
