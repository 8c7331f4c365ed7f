// Plays drawing scripts in the scene of editor_scene.h.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>

#include "oc_core/base/error.h"
#include "oc_core/frustum_editor/editor_script.h"
#include "tests/base/temporary_folder.h"
#include "tests/frustum_editor/editor_scene.h"

namespace ocelli::test {

/// A script with these steps, in which ' stands for ".
inline std::string scriptText(std::string steps) {
  std::replace(steps.begin(), steps.end(), '\'', '"');
  return R"({"camera": "graph", "size": [64, 36], "steps": [)" + steps + "]}";
}

class EditorScriptPlayer : public testing::Test {
 protected:
  EditorSession playText(const std::string& text) {
    return playEditorScript(editorScriptFromJsonText(text, "script.json"), folder.path(), editorView(), mesh, {},
                            folder.path());
  }
  EditorSession play(const std::string& steps) { return playText(scriptText(steps)); }
  /// "" where it plays.
  std::string errorOfText(const std::string& text) {
    try {
      playText(text);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }
  std::string errorOf(const std::string& steps) { return errorOfText(scriptText(steps)); }

  Mesh mesh = editorMesh();
  TemporaryFolder folder;
};

}  // namespace ocelli::test
