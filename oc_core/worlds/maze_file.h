// Maze files: JSON, described by maze.schema.json and docs/files.md. The plan is a drawing
// (oc_core/maze/maze_drawing.h) with one gap in the outer wall, the entrance.
#pragma once

#include <filesystem>
#include <string>

#include "oc_core/scene/maze.h"

namespace ocelli {

class JsonFields;

/// A valid maze. Throws InputError that says the file and the field or cell.
Maze readMaze(const std::filesystem::path& path);
Maze mazeFromJsonText(const std::string& text, const std::string& where);
/// From an object within another file; rejects unknown fields.
Maze readMaze(JsonFields& fields);

/// Reading it gives the same maze again, but for `origin`, which a file does not hold.
std::string jsonText(const Maze& maze);

}  // namespace ocelli
