// Drawing by a script: what a person would do, step by step, without a window.
//
//   {"camera": "graph", "size": [1280, 720], "view": {...},
//    "steps": [{"tool": "bend"}, {"stroke": [[-4, 10], [4, 10]], "plan": "top"}, {"rename": "street"},
//              {"handle": "aim", "of": "street", "plan": "top"}, {"move": [12, 0]}, {"save": "town.json"}]}
//
// "camera" is "graph" or "curved" for one to begin, or a camera file. Points of plans are in the scene's units: [x, z]
// in the plan "top", [x, y] in "front" and [z, y] in "right". A step that cannot be done is an error, but where it has
// "refused": true, and then it is one where it can be done. editor_script.schema.json lists all steps.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "oc_core/frustum_editor/editor_drawing.h"

namespace ocelli {

class JsonFields;

/// What a script draws in.
class EditorSession {
 public:
  /// Files that the script names are written into `folder`. The mesh must live as long as the session.
  EditorSession(const std::string& text, const std::string& where, const PinholeCamera& reference, const Mesh& mesh,
                const SceneGuides& guides, std::filesystem::path folder);

  FrustumEditor& editor() { return editor_; }
  const Mesh& mesh() const { return *mesh_; }
  /// The folder of the file is made. Throws InputError for a path that leads out of the folder.
  std::filesystem::path pathOf(const std::string& file);
  /// The files that pathOf() gave so far.
  const std::vector<std::filesystem::path>& written() const { return written_; }
  const PlanBackdrop& backdrop(PlanSide side);

 private:
  const Mesh* mesh_;
  std::filesystem::path folder_;
  std::vector<std::filesystem::path> written_;
  FrustumEditor editor_;
  std::map<PlanSide, PlanBackdrop> backdrops_;
};

using EditorStep = std::function<void(EditorSession& session)>;

struct EditorStepKind {
  std::string name;  ///< the field that a step has
  std::string says;
  EditorStep (*read)(JsonFields& fields);
};

const std::vector<EditorStepKind>& editorStepKinds();

struct EditorScript {
  std::string camera = "graph";
  int width = 1280;
  int height = 720;
  std::optional<View> view;  ///< of a new camera: what the program gives where it is missing
  struct Step {
    std::string where;
    EditorStep play;
    bool isRefused = false;
  };
  std::vector<Step> steps;
};

/// Throws InputError naming the step and the field.
EditorScript editorScriptFromJsonText(const std::string& text, const std::string& where);

/// Plays it from its beginning: `otherwise` is the view where the script has none. Throws InputError naming the step
/// that cannot be done. A camera file is looked for beside the script, in `scriptFolder`.
EditorSession playEditorScript(const EditorScript& script, const std::filesystem::path& scriptFolder,
                               const View& otherwise, const Mesh& mesh, const SceneGuides& guides,
                               const std::filesystem::path& outputFolder);

}  // namespace ocelli
