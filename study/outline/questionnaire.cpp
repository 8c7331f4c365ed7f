#include "study/outline/questionnaire.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "oc_core/base/json_fields.h"
#include "study/outline/built_in_files.h"
#include "study/outline/local_text.h"
#include "study/outline/question_kinds.h"

namespace ocelli {
namespace {

constexpr size_t kMaxScores = 20;
constexpr size_t kMaxWeights = 200;
constexpr double kMaxFactor = 1e6;

std::string nameOfFile(const std::string& path) {
  const size_t from = path.find_last_of('/') + 1;
  return path.substr(from, path.find_last_of('.') - from);
}

QuestionnaireScore readScore(JsonFields& fields, const std::set<std::string>& items) {
  QuestionnaireScore score;
  score.name = readColumnName(fields, "name", ProtocolReading::kByStudy);
  score.title = fields.shortText("title", kMaxTitleCharacters);
  score.factor = fields.number("factor", -kMaxFactor, kMaxFactor, score.factor);
  score.divisor = fields.number("divisor", 1, kMaxFactor, score.divisor);
  score.constant = fields.number("constant", -kMaxFactor, kMaxFactor, score.constant);
  score.least = fields.number("least", -kMaxFactor, kMaxFactor);
  score.most = fields.number("most", score.least, kMaxFactor);
  JsonFields weights = fields.inner("weights");
  for (const auto& [item, unused] : fields.value("weights").items()) {
    if (!items.contains(item)) {
      weights.fail(item, "is no question of the questionnaire");
    }
    score.weights[item] = weights.number(item, -kMaxFactor, kMaxFactor);
  }
  if (score.weights.empty() || score.weights.size() > kMaxWeights) {
    fields.fail("weights", "must name at least one question");
  }
  return score;
}

}  // namespace

Questionnaire questionnaireFromJsonText(const std::string& text, const std::string& where,
                                        const std::string& language) {
  return readAs("protocols/questionnaire.schema.json", [&] {
    const JsonDocument document(text, where);
    JsonFields fields(document);
    Questionnaire read;
    read.name = fields.shortText("name", kMaxTitleCharacters);
    read.source = fields.shortText("source", kMaxParagraphCharacters);
    // Questionnaires compare no views.
    const ViewConditions conditions = defaultConditions();
    read.form = readFormOutline(fields, read.name, {conditions, ProtocolReading::kByStudy, language});
    read.form.questionnaire = read.name;
    std::set<std::string> items;
    for (const QuestionItem& item : itemsOf(read.form.fields)) {
      items.insert(item.name);
    }
    fields.forEach("scores", 1, kMaxScores, [&](JsonFields& each) { read.scores.push_back(readScore(each, items)); });
    fields.rejectUnknown();
    return read;
  });
}

std::vector<std::string> questionnaireNames() {
  std::vector<std::string> names;
  for (const BuiltInFile& file : builtInQuestionnaires()) {
    names.push_back(nameOfFile(file.name));
  }
  return names;
}

std::optional<Questionnaire> findQuestionnaire(const std::string& name, const std::string& language) {
  for (const BuiltInFile& file : builtInQuestionnaires()) {
    if (nameOfFile(file.name) == name) {
      return questionnaireFromJsonText(file.text, file.name, language);
    }
  }
  return std::nullopt;
}

std::optional<double> scoreOf(const QuestionnaireScore& score, const std::map<std::string, double>& answers) {
  double sum = score.constant;
  for (const auto& [item, weight] : score.weights) {
    const auto answer = answers.find(item);
    if (answer == answers.end()) {
      return std::nullopt;
    }
    sum += weight * answer->second;
  }
  return score.factor * sum / score.divisor;
}

}  // namespace ocelli
