// The fields of views.json, once: the parser, the JSON Schema and the documentation come from these rows.
#pragma once

#include <string>
#include <vector>

namespace ocelli {

inline constexpr int kViewsFormat = 1;
inline constexpr int kMaxDepthViews = 1000;
inline constexpr size_t kMaxViewNameCharacters = 100;
inline constexpr const char* kViewsFile = "views.json";

/// One row a field; where `isRequired`, a file without it is an error.
struct ViewsField {
  const char* name;
  const char* type;  ///< of JSON
  const char* unit;  ///< empty for none
  const char* meaning;
  bool isRequired;
  double least = 0;  ///< of numbers
  double most = 0;
};

/// Of the file, but for "depth_scale" (depth_levels.h) and "views".
const std::vector<ViewsField>& viewsFileFields();
/// Of each object of "views", but for "view" (oc_core/camera/view.schema.json).
const std::vector<ViewsField>& depthViewFields();
/// The row of that name. Aborts where there is none.
const ViewsField& fieldNamed(const std::vector<ViewsField>& fields, const std::string& name);

/// oc_core/depth_views/views.schema.json, as a test checks.
std::string viewsSchemaText();

}  // namespace ocelli
