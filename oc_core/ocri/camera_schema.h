// The JSON Schema of camera files, and a table for the documentation: both say what the rows of representation_kind.h
// do.
#pragma once

#include <string>

namespace ocelli {

/// The text of oc_core/ocri/camera.schema.json.
std::string cameraSchemaText();

/// The options of all representations as rows of a Markdown table: name, default, unit, meaning, and which take it.
std::string cameraOptionTable();

}  // namespace ocelli
