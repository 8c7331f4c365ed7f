// Reads protocol files: protocols/protocol.schema.json and docs/protocols.md describe them.
#include <fmt/format.h>

#include <algorithm>
#include <regex>
#include <set>

#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/base/sha256.h"
#include "oc_core/worlds/maze_file.h"
#include "study/outline/csv_cases.h"
#include "study/outline/local_text.h"
#include "study/outline/study_factors.h"
#include "study/protocol/condition_fields.h"
#include "study/protocol/leveled_block.h"
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

/// The tables that the cases of a block came from; nullptr where they stand in the protocol.
struct BlockTables {
  const CsvCases* cases = nullptr;
  const CsvCases* practice = nullptr;
};

BlockTables tablesOf(const std::vector<CsvCases>& tables, size_t block) {
  const auto find = [&](const char* field) {
    const std::string pointer = fmt::format("/blocks/{}/{}", block, field);
    const auto found =
        std::find_if(tables.begin(), tables.end(), [&](const CsvCases& each) { return each.pointer == pointer; });
    return found == tables.end() ? nullptr : &*found;
  };
  return {find("cases"), find("practice_cases")};
}

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

/// Of all cases of the block, or of none: a task may have cases that the factors do not describe.
std::vector<FactorLevels> readCaseLevels(JsonFields& fields, const std::vector<StudyFactor>& factors) {
  std::vector<FactorLevels> levels;
  const nlohmann::json& cases = fields.value("cases");
  const auto hasLevels = [](const nlohmann::json& each) { return each.contains("factors"); };
  if (!cases.is_array() || std::none_of(cases.begin(), cases.end(), hasLevels)) {
    return levels;
  }
  fields.forEach("cases", 1, cases.size(), [&](JsonFields& each) {
    for (const auto& [name, value] : cases[levels.size()].items()) {
      each.has(name);  // the task has checked them
    }
    levels.push_back(readLevels(each, factors, FactorsOf::kCases));
  });
  return levels;
}

/// An eye that moves by itself goes with tasks in which nothing else does: images of all its poses are made beforehand.
void checkEyes(JsonFields& fields, const TaskBlock& task, const StudyConditions& conditions) {
  for (const TrialView view : conditions.names.all()) {
    if (conditions.views[indexOfCondition(view)]->movesEye() && !task.isStill()) {
      fields.fail("task",
                  fmt::format("is one in which the subject or an object moves, but the view of the condition "
                              "\"{}\" has a \"head\" that moves: leave \"head\" away, or take a task in which all "
                              "stands still",
                              conditions.names.nameOf(view)));
    }
  }
}

/// What is wrong with cases of a table is told with its line and column.
template <class Read>
auto readFromTable(const CsvCases* table, const Read& read) {
  if (table == nullptr) {
    return read();
  }
  try {
    return read();
  } catch (const JsonFieldError& error) {
    static const std::regex kCase("cases\" ([0-9]+)");
    static const std::regex kField("^field \"([^\"]*)\"");
    std::smatch found;
    if (!std::regex_search(error.where(), found, kCase)) {
      throw;
    }
    const size_t index = std::stoul(found[1]) - 1;
    const bool hasField = std::regex_search(error.problem(), found, kField);
    throw JsonFieldError(error.problem(), table->placeOf(index, hasField ? found[1].str() : std::string()));
  } catch (const InputError& error) {
    // A field that no case has: its message is made already.
    static const std::regex kUnknown("cases\" ([0-9]+)[^:]*: (field \"([^\"]*)\" is unknown)\\s+try: ([^\\n]*)");
    const std::string message = error.what();
    std::smatch found;
    if (!std::regex_search(message, found, kUnknown)) {
      throw;
    }
    throw InputError(found[2], table->placeOf(std::stoul(found[1]) - 1, found[3]), found[4]);
  }
}

ProtocolBlock readBlock(JsonFields& fields, const Protocol& protocol, const TaskSetting& setting,
                        const FormSetting& forms, const BlockTables& tables) {
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
  readFromTable(tables.cases, [&] {
    block.task = kind.read(fields, "cases", setting);
    block.caseLevels = readCaseLevels(fields, protocol.conditions.names.factors);
    block.staircase = readBlockStaircase(fields, *block.task, block.views);
    if (block.staircase) {
      block.task = leveledBlock(block.task, block.staircase->levelsByCase());
    }
  });
  checkEyes(fields, *block.task, setting.conditions);
  readFromTable(tables.practice, [&] { block.practice = readPractice(fields, outline.practice, kind, setting); });
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

void readBlocks(JsonFields& fields, const TaskSetting& setting, const FormSetting& forms,
                const std::vector<CsvCases>& tables, Protocol& protocol) {
  std::set<std::string> names;
  fields.forEach(
      "blocks", 1, kMaxBlocks,
      [&](JsonFields& each) {
        const BlockTables ofBlock = tablesOf(tables, protocol.blocks.size());
        const std::string& name = protocol.blocks.emplace_back(readBlock(each, protocol, setting, forms, ofBlock)).name;
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

Protocol protocolOf(const ProtocolText& source, const std::string& where) {
  const std::string& text = source.text;
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
    protocol.gaze = fields.boolean("gaze", protocol.gaze);
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
    readBlocks(fields, setting, forms, source.tables, protocol);
    protocol.exclusions = readExclusions(fields, protocol);
    fields.rejectUnknown();
    return protocol;
  });
}

}  // namespace

Protocol protocolFromJsonText(const std::string& text, const std::string& where) {
  return protocolOf({text}, where);
}

Protocol readProtocol(const std::filesystem::path& path) {
  Protocol protocol = protocolOf(readProtocolText(path), path.string());
  protocol.file = path;
  return protocol;
}

}  // namespace ocelli
