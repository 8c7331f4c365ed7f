#include "study/views/view_registry.h"

#include <fmt/format.h>

#include <algorithm>

#include "oc_core/base/json_fields.h"

namespace ocelli {

// Each in its NAME_view.cpp.
ViewKind panesViewKind();
ViewKind ocriViewKind();
ViewKind cameraViewKind();
ViewKind displayViewKind();

namespace {

/// "variant": the name that blocks give to other places to look from.
std::string readVariant(JsonFields& fields) {
  constexpr size_t kMaxVariantCharacters = 60;
  return fields.has("variant") ? fields.shortText("variant", kMaxVariantCharacters) : "";
}

Registry<ViewKind>& viewRegistry() {
  static Registry<ViewKind> registry("view", {{"pinhole", "the planar pinhole cameras of the task",
                                               [](JsonFields& fields) { return pinholeView(readVariant(fields)); }},
                                              {"graph", "the graph camera that the task makes",
                                               [](JsonFields& fields) { return graphView(readVariant(fields)); }},
                                              panesViewKind(),
                                              ocriViewKind(),
                                              cameraViewKind(),
                                              displayViewKind()});
  return registry;
}

const ViewKind& viewKindIn(JsonFields& fields, const std::string& field, const std::string& name) {
  const Rows<ViewKind> kinds = viewKinds();
  const auto found = std::find_if(kinds.begin(), kinds.end(), [&](const ViewKind& kind) { return kind.name == name; });
  if (found == kinds.end()) {
    fields.fail(field, fmt::format("is \"{}\", but the views are {}", name, viewNames()));
  }
  return *found;
}

}  // namespace

Rows<ViewKind> viewKinds() {
  return viewRegistry().rows();
}

void registerView(ViewKind kind) {
  if (kind.name.empty() || kind.read == nullptr) {
    throw InputError("this view has no name or no reader", fmt::format("\"{}\"", kind.name),
                     "set `name` and `read` of its row");
  }
  viewRegistry().add(std::move(kind));
}

std::string viewNames() {
  std::string names;
  for (const ViewKind& kind : viewKinds()) {
    names += fmt::format("{}{}", names.empty() ? "" : ", ", kind.name);
  }
  return names;
}

std::shared_ptr<const SceneView> readSceneView(JsonFields& fields, const std::string& name) {
  const nlohmann::json& value = fields.value(name);
  static const nlohmann::json kNoOptions = nlohmann::json::object();
  const bool isName = value.is_string();
  if (!isName && !value.is_object()) {
    fields.fail(name, fmt::format("must be one of {}, or an object with the field \"kind\"", viewNames()));
  }
  JsonFields options =
      isName ? JsonFields(kNoOptions, fmt::format("{}, \"{}\"", fields.where(), name)) : fields.inner(name);
  const ViewKind& kind =
      isName ? viewKindIn(fields, name, value.get<std::string>()) : viewKindIn(options, "kind", options.text("kind"));
  std::shared_ptr<const SceneView> view = kind.read(options);
  options.rejectUnknown();
  return view;
}

}  // namespace ocelli
