// Reads protocol files: protocols/protocol.schema.json and docs/protocols.md describe them.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/base/sha256.h"
#include "oc_core/worlds/maze_file.h"
#include "study/outline/local_text.h"
#include "study/protocol/condition_fields.h"
#include "study/protocol/protocol.h"
#include "study/protocol/protocol_fields.h"
#include "study/protocol/schedule.h"
#include "study/tasks/task_registry.h"

namespace ocelli {
namespace {

constexpr size_t kMaxMazes = 20;
constexpr size_t kMaxBlocks = 20;
constexpr int kMaxSessions = 20;
constexpr int kMaxSeed = 2147483647;

std::map<std::string, Maze> readMazes(JsonFields& fields) {
  std::map<std::string, Maze> mazes;
  fields.forEachNamed(
      "mazes", kMaxMazes,
      [&](const std::string& name, JsonFields& maze) {
        if (maze.has("landmarks")) {
          maze.fail("landmarks", "is not for protocols: where objects stand is for the cases of the blocks to say");
        }
        mazes.emplace(name, readMaze(maze));
      },
      "mazes");
  return mazes;
}

std::vector<int> readSessions(JsonFields& fields, int sessions) {
  std::set<int> list;
  if (!fields.has("sessions")) {
    return {};
  }
  const nlohmann::json& json = fields.value("sessions");
  const auto isSession = [&](const nlohmann::json& number) {
    return number.is_number_integer() && number >= 1 && number <= sessions;
  };
  if (!json.is_array() || json.empty() || !std::all_of(json.begin(), json.end(), isSession)) {
    fields.fail("sessions",
                fmt::format("must be an array of whole numbers from 1 to {}, the protocol's sessions", sessions));
  }
  for (const nlohmann::json& number : json) {
    if (!list.insert(number.get<int>()).second) {
      fields.fail("sessions", "has a session twice");
    }
  }
  return {list.begin(), list.end()};
}

const TaskKind& readTask(JsonFields& fields) {
  std::vector<std::string> names;
  for (const TaskKind& kind : taskKinds()) {
    names.emplace_back(kind.name);
  }
  const std::string name = fields.choice("task", names);
  return taskKinds()[static_cast<size_t>(std::find(names.begin(), names.end(), name) - names.begin())];
}

std::optional<ProtocolPractice> readPractice(JsonFields& fields, const std::optional<PracticeOutline>& outline,
                                             const TaskKind& kind, const TaskSetting& setting) {
  if (outline) {
    return ProtocolPractice{kind.read(fields, "practice_cases", setting), outline->minCorrect, outline->maxTrials,
                            outline->eachView};
  }
  if (fields.has("practice_cases")) {
    fields.fail("practice_cases", "is of no use without the field \"practice\", which says when practice ends");
  }
  return std::nullopt;
}

ProtocolBlock readBlock(JsonFields& fields, const Protocol& protocol, const TaskSetting& setting,
                        const FormSetting& forms) {
  constexpr int kMaxTrials = 1000;
  const BlockOutline outline = readBlockOutline(fields, ProtocolReading::kByStudy, forms.language);
  const TaskKind& kind = readTask(fields);
  ProtocolBlock block;
  block.name = outline.name;
  block.title = outline.title;
  block.taskName = outline.task;
  block.order = fields.choiceOf("order", kTrialOrders, block.order);
  block.views = outline.views;
  block.feedback = fields.boolean("feedback", block.feedback);
  block.breakEveryTrials = fields.integer("break_every_trials", 0, kMaxTrials, block.breakEveryTrials);
  block.breakAfter = fields.boolean("break_after", block.breakAfter);
  block.sessions = readSessions(fields, protocol.sessions);
  block.after = readFormList(fields, "after", "after " + block.name, forms);
  block.task = kind.read(fields, "cases", setting);
  block.practice = readPractice(fields, outline.practice, kind, setting);
  if (fields.has("example_cases")) {
    block.examples = kind.read(fields, "example_cases", setting);
  }
  PageTrials trials{protocol.conditions.names, block.examples, {}};
  trials.plan.index = -1;
  trials.plan.block = static_cast<int>(protocol.blocks.size());
  trials.plan.task = block.taskName;
  trials.plan.seed = protocol.seed;
  trials.plan.practice = true;
  block.instructions = readPages(fields, "instructions", forms.language, &trials);
  return block;
}

void readBlocks(JsonFields& fields, const TaskSetting& setting, const FormSetting& forms, Protocol& protocol) {
  std::set<std::string> names;
  fields.forEach(
      "blocks", 1, kMaxBlocks,
      [&](JsonFields& each) {
        const std::string& name = protocol.blocks.emplace_back(readBlock(each, protocol, setting, forms)).name;
        if (!names.insert(name).second) {
          fields.fail("blocks",
                      fmt::format("has two of the name \"{}\": the second is block {}", name, protocol.blocks.size()));
        }
      },
      "blocks");
  for (int session = 1; session <= protocol.sessions; ++session) {
    const auto isIn = [&](const ProtocolBlock& block) { return isInSession(block, session); };
    if (std::none_of(protocol.blocks.begin(), protocol.blocks.end(), isIn)) {
      fields.fail("sessions", fmt::format("is {}, but no block is in session {}", protocol.sessions, session));
    }
  }
}

}  // namespace

Protocol protocolFromJsonText(const std::string& text, const std::string& where) {
  return readAs("protocols/protocol.schema.json", [&] {
    const JsonDocument document(text, where);
    JsonFields fields(document);
    Protocol protocol;
    protocol.text = text;
    protocol.sha256 = sha256(text);
    protocol.name = readIdentifier(fields, "name", false);
    const std::string language = readLanguage(fields);
    protocol.texts = SubjectTexts(language);
    protocol.title = localText(fields, "title", kMaxTitleCharacters, language);
    protocol.description = localText(fields, "description", kMaxParagraphCharacters, language, "");
    constexpr int kMaxMinutes = 1'000'000;  // about two years
    protocol.sessions = fields.integer("sessions", 1, kMaxSessions, protocol.sessions);
    protocol.minutesBetweenSessions =
        fields.integer("minutes_between_sessions", 0, kMaxMinutes, protocol.minutesBetweenSessions);
    protocol.seed = static_cast<uint64_t>(fields.integer("seed", 0, kMaxSeed, 1));
    protocol.conditions = readConditions(fields);
    const FormSetting forms{protocol.conditions.names, ProtocolReading::kByStudy, language};
    if (fields.has("consent")) {
      protocol.consent = readPage(fields, "consent", language);
    }
    if (fields.has("demographics")) {
      protocol.demographics = readForm(fields, "demographics", forms);
    }
    protocol.before = readFormList(fields, "before", "before", forms);
    protocol.welcome = readPages(fields, "welcome", language);
    protocol.after = readFormList(fields, "after", "after", forms);
    if (fields.has("survey")) {
      protocol.survey = readForm(fields, "survey", forms);
    }
    protocol.surveyAfterLastSessionOnly =
        fields.boolean("survey_after_last_session_only", protocol.surveyAfterLastSessionOnly);
    protocol.shuffleBlocks = fields.boolean("shuffle_blocks", protocol.shuffleBlocks);
    protocol.breakSeconds = fields.integer("break_seconds", 0, 3600, protocol.breakSeconds);
    protocol.screen = screenGeometry(readStatedScreen(fields, ProtocolReading::kByStudy));
    protocol.timing = readTimingLimits(fields, ProtocolReading::kByStudy);
    protocol.resume = fields.choiceOf("resume", kResumePolicies, protocol.resume);
    if (fields.has("controls")) {
      JsonFields controls = fields.inner("controls");
      protocol.controls = readControls(controls);
      controls.rejectUnknown();
    }
    const TaskSetting setting{readMazes(fields), protocol.controls, protocol.conditions};
    readBlocks(fields, setting, forms, protocol);
    protocol.exclusions = readExclusions(fields, protocol);
    fields.rejectUnknown();
    return protocol;
  });
}

Protocol readProtocol(const std::filesystem::path& path) {
  Protocol protocol = protocolFromJsonText(readFile(path, kMaxTextBytes), path.string());
  protocol.file = path;
  return protocol;
}

}  // namespace ocelli
