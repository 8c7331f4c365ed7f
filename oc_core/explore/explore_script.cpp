#include "oc_core/explore/explore_script.h"

#include <iterator>

#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/base/output_folder.h"
#include "oc_core/explore/explore_message.h"
#include "oc_core/explore/explore_steps.h"

namespace ocelli {
namespace {

constexpr int kMinSide = 64;
constexpr int kMaxSide = 4096;
constexpr size_t kMaxSteps = 10'000;

ExploreScript::Step readStep(JsonFields& fields) {
  std::string known;
  for (const ExploreStepKind& kind : exploreStepKinds().rows()) {
    if (fields.has(kind.name)) {
      return {fields.where() + ", \"" + kind.name + "\"", kind.read(fields)};
    }
    known += (known.empty() ? "" : ", ") + kind.name;
  }
  throw JsonFieldError("a step has one of the fields " + known, fields.where());
}

}  // namespace

Registry<ExploreStepKind>& exploreStepKinds() {
  static Registry<ExploreStepKind> kinds("step of explore scripts", [] {
    std::vector<ExploreStepKind> rows = exploreWalkSteps();
    for (std::vector<ExploreStepKind> others : {exploreChoiceSteps(), exploreDrawSteps(), exploreEventSteps()}) {
      rows.insert(rows.end(), std::make_move_iterator(others.begin()), std::make_move_iterator(others.end()));
    }
    return rows;
  }());
  return kinds;
}

std::filesystem::path ExploreSession::pathOf(const std::string& file) const {
  return pathInFolder(files_.folder, file, "script");
}

void ExploreSession::wrote(const std::filesystem::path& path) const {
  if (files_.wrote) {
    files_.wrote(path);
  }
}

void ExploreSession::give(const InputEvent&) {
  throw InputError("this step needs the window", "", "give --window, or leave the step out");
}

ExploreScript exploreScriptFromJsonText(const std::string& text, const std::string& where) {
  const JsonDocument document(text, where);
  return readAs("oc_core/explore/explore_script.schema.json", [&] {
    JsonFields fields(document);
    ExploreScript script;
    if (fields.has("size")) {
      const std::vector<double> size = fields.numbers("size", 2, kMinSide, kMaxSide);
      script.width = static_cast<int>(size[0]);
      script.height = static_cast<int>(size[1]);
      if (script.width != size[0] || script.height != size[1]) {
        fields.fail("size", "must be two whole numbers");
      }
    }
    fields.value("steps");
    fields.forEach("steps", 0, kMaxSteps, [&](JsonFields& each) { script.steps.push_back(readStep(each)); });
    fields.rejectUnknown();
    return script;
  });
}

ExploreScript readExploreScript(const std::filesystem::path& path) {
  ExploreScript script = exploreScriptFromJsonText(readFile(path), path.string());
  script.folder = path.parent_path();
  return script;
}

void play(const ExploreScript& script, ExploreSession& session) {
  session.scriptFolder = script.folder;
  for (const ExploreScript::Step& step : script.steps) {
    try {
      step.play(session);
    } catch (const InputError& error) {
      const ExploreMessage message = messageOf(error);
      throw InputError(message.what, step.where, message.next);
    }
  }
}

}  // namespace ocelli
