// What a condition of a study can show, a row a kind: what protocols name in the field "view" of a condition.
//
// Recipe for a new kind, two places and a line:
//   1. study/views/NAME_view.cpp: a SceneView (study/task/scene_view.h), its reader, and a function that makes the row.
//   2. study/views/view_registry.cpp: that function, at the end of the table.
//   3. The name of the file in the CMakeLists.txt beside it.
// Then its fields in protocols/protocol.schema.json and in docs/protocols.md. tests/study_views/view_contract_test.cpp
// runs over all rows. study/views/ocri_view.cpp is the example. Tasks, screens, databases, replays and analyses take it
// as it is.
//
// A program outside of the tree registers a row of its own with registerView().
#pragma once

#include <memory>
#include <string>

#include "oc_core/base/registry.h"
#include "study/task/scene_view.h"

namespace ocelli {

class JsonFields;

struct ViewKind {
  std::string name;         ///< in protocols
  std::string description;  ///< what is seen, in a few words
  /// Reads the options of the kind from the fields of the view; others are left for the caller to reject. Throws
  /// InputError naming the field.
  std::shared_ptr<const SceneView> (*read)(JsonFields& fields) = nullptr;
};

/// The built-in rows, then those that were registered. Any thread may call it at any time.
Rows<ViewKind> viewKinds();

/// Adds a row: from then on protocols may name it. Throws InputError where the name is taken or empty, or `read` is
/// missing.
void registerView(ViewKind kind);

/// "pinhole, graph, ...".
std::string viewNames();

/// The view that a field of an object describes: the name of a kind, or an object with the field "kind" and the options
/// of the kind. Throws InputError naming the field.
std::shared_ptr<const SceneView> readSceneView(JsonFields& fields, const std::string& name);

}  // namespace ocelli
