// Drawing cameras by hand in scripts (section 4.3.2.1).
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/explore/explore_steps.h"
#include "oc_core/frustum_editor/editor_script.h"

namespace ocelli {
namespace {

constexpr size_t kMaxDrawFile = 4096;  // characters of its name

/// The drawing begins as the walker looks, unless its script says otherwise; what it leads to is shown.
ExploreStep readDraw(JsonFields& fields) {
  const std::string name = fields.shortText("draw", kMaxDrawFile);
  return [name](ExploreSession& session) {
    const std::string file = (session.scriptFolder / name).string();
    Explorer& explorer = session.explorer();
    const EditorScript script = editorScriptFromJsonText(readFile(file, kMaxTextBytes), file);
    EditorSession drawing =
        playEditorScript(script, std::filesystem::path(file).parent_path(), explorer.frame().pinhole.view(),
                         explorer.scene().mesh(), explorer.scene().guides(), session.pathOf("camera").parent_path());
    for (const std::filesystem::path& path : drawing.written()) {
      session.wrote(path);
    }
    explorer.showDrawn(drawing.editor().camera(), file);
    session.showFrame({});
  };
}

}  // namespace

std::vector<ExploreStepKind> exploreDrawSteps() {
  return {{"draw", "a script that draws a camera (docs/explore.md), which is shown then", readDraw}};
}

}  // namespace ocelli
