#include "analysis/report/questionnaire_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "analysis/dataset/form_item.h"
#include "analysis/dataset/protocol_facts.h"
#include "analysis/report/number_text.h"
#include "analysis/report/report_origins.h"
#include "analysis/report/survey_section.h"
#include "oc_core/base/csv.h"

namespace ocelli {
namespace {

/// The forms of all sources, each once.
std::vector<ProtocolForm> otherFormsOf(const Dataset& data) {
  std::vector<ProtocolForm> forms;
  for (const DataSource& source : data.sources) {
    if (source.protocolText.empty()) {
      continue;
    }
    for (const ProtocolForm& form : protocolFacts(source.protocolText, source.path).otherForms) {
      if (std::ranges::count(forms, form.name, &ProtocolForm::name) == 0) {
        forms.push_back(form);
      }
    }
  }
  return forms;
}

/// The view of all of a subject's trials before the form; nothing where they are of both, or there are none.
std::optional<TrialView> viewBefore(const Dataset& data, const std::string& form, const std::string& subject,
                                    int session) {
  std::set<TrialView> views;
  for (const Trial& trial : data.trials) {
    const bool isAfterBlock = form.find(" after ") != std::string::npos;
    if (trial.subject == subject && trial.session == session &&
        (!isAfterBlock || form.ends_with(" after " + trial.block))) {
      views.insert(trial.view);
    }
  }
  return views.size() == 1 && !form.ends_with(" before") ? std::optional(*views.begin()) : std::nullopt;
}

/// Numbers by item, of one subject in one session.
struct GivenAnswers {
  std::map<std::string, double> numbers{};
  std::map<std::string, RowRef> rows{};
};

struct ScoreSummary {
  size_t subjects = 0;
  size_t open = 0;  ///< of whom no score is known
  double mean = kNotKnown;
  double deviation = kNotKnown;
  double least = kNotKnown;
  double most = kNotKnown;
  std::vector<RowRef> rows{};
};

ScoreSummary summaryOf(const std::vector<const SubjectScore*>& scores) {
  ScoreSummary summary;
  std::vector<double> values;
  for (const SubjectScore* each : scores) {
    if (!each->value) {
      ++summary.open;
      continue;
    }
    values.push_back(*each->value);
    summary.rows.insert(summary.rows.end(), each->rows.begin(), each->rows.end());
  }
  summary.subjects = values.size();
  if (values.empty()) {
    return summary;
  }
  double sum = 0;
  for (const double value : values) {
    sum += value;
  }
  summary.mean = sum / static_cast<double>(values.size());
  summary.least = *std::ranges::min_element(values);
  summary.most = *std::ranges::max_element(values);
  if (values.size() > 1) {
    double squares = 0;
    for (const double value : values) {
      squares += (value - summary.mean) * (value - summary.mean);
    }
    summary.deviation = std::sqrt(squares / static_cast<double>(values.size() - 1));
  }
  return summary;
}

std::string scoreText(double value) {
  return std::isfinite(value) ? fixedText(value, 2) : "-";
}

void addScores(ReportWork& work, const std::vector<SubjectScore>& scores) {
  ReportTable table{"Scores of questionnaires, by when they were asked, session and view",
                    kScoresTable,
                    {{"Score", "", true},
                     {"Asked", "", true},
                     {"Session"},
                     {"View", "", true},
                     {"Subjects"},
                     {"Open"},
                     {"Mean"},
                     {"SD"},
                     {"Lowest"},
                     {"Highest"}},
                    {}};
  OriginTable origins(work.document.origins, kScoresTable, table.caption,
                      {"subjects", "mean", "sd", "lowest", "highest"});
  using Key = std::tuple<std::string, std::string, int, int>;
  std::vector<Key> order;
  std::map<Key, std::vector<const SubjectScore*>> groups;
  for (const SubjectScore& each : scores) {
    const Key key{each.form, each.score, each.session, each.view ? static_cast<int>(*each.view) : -1};
    if (!groups.contains(key)) {
      order.push_back(key);
    }
    groups[key].push_back(&each);
  }
  const ViewConditions& conditions = work.analysis.data.conditions;
  for (const Key& key : order) {
    const std::vector<const SubjectScore*>& group = groups[key];
    const SubjectScore& first = *group.front();
    const ScoreSummary summary = summaryOf(group);
    const std::string label = fmt::format("{} {}, session {}{}", first.form, first.score, first.session,
                                          first.view ? fmt::format(", {}", conditions.nameOf(*first.view)) : "");
    const std::string meaning =
        fmt::format("{} of {} subjects, session {}", first.title, summary.subjects, first.session);
    const auto subjects = static_cast<double>(summary.subjects);
    const std::string origin = origins.addRow(label, meaning, {summary.rows, Cell::From::kAnswers}, "",
                                              {subjects, summary.mean, summary.deviation, summary.least, summary.most});
    const std::string source = origins.sourceText(meaning);
    const auto cell = [&](const std::string& text, const char* column, double value) {
      ReportCell result{text, origin.empty() ? "" : fmt::format("{}/{}", origin, column), source};
      if (std::isfinite(value)) {
        result.value = value;
      }
      return result;
    };
    ReportCell score{first.title};
    score.shortName = first.score;
    const std::string asked = first.form.substr(first.questionnaire.size() + 1);
    table.rows.push_back({score, ReportCell{asked}, ReportCell{std::to_string(first.session)},
                          ReportCell{first.view ? conditions.of(*first.view).label : std::string("-")},
                          cell(std::to_string(summary.subjects), "subjects", subjects),
                          ReportCell{std::to_string(summary.open)}, cell(scoreText(summary.mean), "mean", summary.mean),
                          cell(scoreText(summary.deviation), "sd", summary.deviation),
                          cell(scoreText(summary.least), "lowest", summary.least),
                          cell(scoreText(summary.most), "highest", summary.most)});
  }
  work.document.add(table);
  origins.finish();
}

}  // namespace

std::vector<SubjectScore> scoresOf(const Dataset& data) {
  std::vector<SubjectScore> scores;
  for (const ProtocolForm& form : otherFormsOf(data)) {
    const auto questionnaire =
        form.questionnaire.empty() ? std::nullopt : findQuestionnaire(form.questionnaire, kSourceLanguage);
    if (!questionnaire) {
      continue;
    }
    std::map<std::pair<int, std::string>, GivenAnswers> given;
    for (const FormAnswer& answer : data.answers) {
      if (answer.form == form.name) {
        GivenAnswers& of = given[{answer.session, answer.subject}];
        if (const std::optional<double> number = numberOfAnswer(answer.answer)) {
          of.numbers[answer.field] = *number;
          of.rows[answer.field] = {answer.source, answer.answerId};
        }
      }
    }
    for (const QuestionnaireScore& score : questionnaire->scores) {
      for (const auto& [key, answers] : given) {
        SubjectScore one{form.name,
                         form.questionnaire,
                         key.second,
                         key.first,
                         viewBefore(data, form.name, key.second, key.first),
                         score.name,
                         score.title,
                         scoreOf(score, answers.numbers)};
        for (const auto& [item, weight] : score.weights) {
          if (const auto row = answers.rows.find(item); row != answers.rows.end()) {
            one.rows.push_back(row->second);
          }
        }
        scores.push_back(std::move(one));
      }
    }
  }
  return scores;
}

bool hasOtherForms(const Dataset& data) {
  return !otherFormsOf(data).empty();
}

void addQuestionnaires(ReportWork& work) {
  addHeading(work.document, 1, "Questionnaires", "questionnaires");
  const std::vector<SubjectScore> scores = scoresOf(work.analysis.data);
  if (!scores.empty()) {
    addScores(work, scores);
    work.methods.push_back(
        "Questionnaires were scored as published (protocols/questionnaires); a score with an item that was left open "
        "is "
        "missing, and is in no mean. A view is told where all trials before the questionnaire were in it.");
  }
  int described = 0;
  for (const ProtocolForm& form : otherFormsOf(work.analysis.data)) {
    const std::vector<ItemAnswers> items = answersToForm(work.analysis.data, form.name);
    if (!items.empty()) {
      addItemDescriptions(work, items, fmt::format("form-answers-{}", ++described),
                          fmt::format("Answers to the form \"{}\", each question on its own scale; the last answer of "
                                      "each subject",
                                      form.name));
    }
  }
  if (scores.empty() && described == 0) {
    addNotEstimable(work.document, "Questionnaires", "there are no answers to the forms that the protocol asks");
  }
}

std::string scoresCsv(const Dataset& data) {
  std::string text = "form,questionnaire,subject_id,session_number,view,score,value\r\n";
  for (const SubjectScore& each : scoresOf(data)) {
    text += fmt::format("{},{},{},{},{},{},{}\r\n", csvText(each.form), csvText(each.questionnaire),
                        csvText(each.subject), each.session, each.view ? data.conditions.nameOf(*each.view) : "",
                        each.score, each.value ? fmt::format("{}", *each.value) : "");
  }
  return text;
}

}  // namespace ocelli
