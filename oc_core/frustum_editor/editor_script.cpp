#include "oc_core/frustum_editor/editor_script.h"

#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/base/output_folder.h"

namespace ocelli {
namespace {

constexpr const char* kScriptDescription = "oc_core/frustum_editor/editor_script.schema.json";
constexpr size_t kMaxSteps = 10000;

/// The step's kind and what it does.
EditorScript::Step readStep(const nlohmann::json& json, const std::string& where) {
  JsonFields fields(json, where);
  EditorScript::Step step;
  step.where = where;
  std::string names;
  for (const EditorStepKind& kind : editorStepKinds()) {
    names += (names.empty() ? "" : ", ") + kind.name;
    if (fields.has(kind.name)) {
      if (step.play) {
        throw InputError("the step does two things", where, "make two steps of it");
      }
      step.play = kind.read(fields);
    }
  }
  if (!step.play) {
    throw InputError("the step does nothing", where, "give it one of these fields: " + names);
  }
  step.isRefused = fields.boolean("refused", false);
  fields.rejectUnknown();
  return step;
}

/// What an error says, in one line.
std::string lineOf(std::string text) {
  for (size_t at = text.find("\n  "); at != std::string::npos; at = text.find("\n  ", at)) {
    text.replace(at, 3, "; ");
  }
  return text;
}

void playStep(const EditorScript::Step& step, EditorSession& session) {
  bool refused = false;
  std::string why;
  try {
    step.play(session);
    why = session.editor().message();
    // While a drag goes on, the pointer may pass what is no camera.
    refused = !why.empty() && !session.editor().isDragging() && !session.editor().drawn().overlapAllowed;
  } catch (const InputError& error) {
    refused = true;
    why = error.what();
  }
  if (refused != step.isRefused) {
    throw InputError(
        refused ? "the step cannot be done: " + lineOf(why) : "the step was done, though it should be refused",
        step.where, "change the step");
  }
}

}  // namespace

EditorSession::EditorSession(const std::string& text, const std::string& where, const PinholeCamera& reference,
                             const Mesh& mesh, const SceneGuides& guides, std::filesystem::path folder)
    : mesh_(&mesh), folder_(std::move(folder)), editor_(text, where, reference, mesh, guides) {}

std::filesystem::path EditorSession::pathOf(const std::string& file) {
  const std::filesystem::path whole = pathInFolder(folder_, file, "script");
  written_.push_back(whole);
  return whole;
}

const PlanBackdrop& EditorSession::backdrop(PlanSide side) {
  const auto found = backdrops_.find(side);
  if (found != backdrops_.end()) {
    return found->second;
  }
  return backdrops_.emplace(side, planBackdrop(*mesh_, side, glm::dvec3(editor_.drawn().view.eye))).first->second;
}

EditorScript editorScriptFromJsonText(const std::string& text, const std::string& where) {
  return readAs(kScriptDescription, [&] {
    const nlohmann::json json = parseJson(text, where);
    JsonFields fields(json, where);
    EditorScript script;
    script.camera = fields.text("camera", "graph");
    if (fields.has("size")) {
      const std::vector<double> size = fields.numbers("size", 2, 1, PinholeCamera::kMaxPixelsASide);
      script.width = static_cast<int>(size[0]);
      script.height = static_cast<int>(size[1]);
      if (script.width != size[0] || script.height != size[1]) {
        fields.fail("size", "must be two whole numbers");
      }
    }
    if (fields.has("view")) {
      script.view = viewFromJsonText(fields.value("view").dump(), where + ", \"view\"");
    }
    const nlohmann::json& steps = fields.value("steps");
    if (!steps.is_array() || steps.size() > kMaxSteps) {
      fields.fail("steps", "must be an array of at most " + std::to_string(kMaxSteps) + " steps");
    }
    for (const nlohmann::json& each : steps) {
      script.steps.push_back(readStep(each, where + ", step " + std::to_string(script.steps.size() + 1)));
    }
    fields.rejectUnknown();
    return script;
  });
}

EditorSession playEditorScript(const EditorScript& script, const std::filesystem::path& scriptFolder,
                               const View& otherwise, const Mesh& mesh, const SceneGuides& guides,
                               const std::filesystem::path& outputFolder) {
  const PinholeCamera reference(script.view.value_or(otherwise), script.width, script.height);
  const bool isGraph = script.camera == "graph";
  const bool isNew = isGraph || script.camera == "curved";
  const std::filesystem::path file = scriptFolder / script.camera;
  const std::string text = isGraph ? FrustumEditor::newGraphCamera(reference)
                           : isNew ? FrustumEditor::newCurvedCamera(reference)
                                   : readFile(file, kMaxTextBytes);
  EditorSession session(text, isNew ? "new camera" : file.string(), reference, mesh, guides, outputFolder);
  for (const EditorScript::Step& step : script.steps) {
    playStep(step, session);
  }
  return session;
}

}  // namespace ocelli
