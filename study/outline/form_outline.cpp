#include "study/outline/form_outline.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>

#include "oc_core/base/json_fields.h"
#include "study/outline/condition_names.h"
#include "study/outline/local_text.h"
#include "study/outline/question_kinds.h"
#include "study/outline/questionnaire.h"

namespace ocelli {
namespace {

constexpr size_t kMaxFieldsOfStudy = 40;
constexpr size_t kMaxForms = 20;
constexpr size_t kMaxListed = 1'000'000;  // to an analysis

size_t maxListed(ProtocolReading reading, size_t ofStudy) {
  return reading == ProtocolReading::kByStudy ? ofStudy : kMaxListed;
}

}  // namespace

ProtocolForm readFormOutline(JsonFields& fields, const std::string& name, const FormSetting& setting) {
  const bool byStudy = setting.reading == ProtocolReading::kByStudy;
  ProtocolForm form;
  form.name = name;
  if (byStudy) {
    form.title = localText(fields, "title", kMaxTitleCharacters, setting.language);
    form.introduction = localText(fields, "introduction", kMaxParagraphCharacters, setting.language, "");
  }
  fields.forEach("fields", byStudy ? 1 : 0, maxListed(setting.reading, kMaxFieldsOfStudy), [&](JsonFields& each) {
    form.fields.push_back(readFormField(each, setting.conditions, setting.reading, setting.language));
  });
  std::set<std::string> names;
  for (const QuestionItem& item : itemsOf(form.fields)) {
    if (byStudy && !names.insert(item.name).second) {
      fields.fail("fields", fmt::format("has two of the name \"{}\"", item.name));
    }
  }
  return form;
}

std::vector<ProtocolForm> readFormList(JsonFields& fields, const std::string& name, const std::string& when,
                                       const FormSetting& setting) {
  std::vector<ProtocolForm> forms;
  const bool byStudy = setting.reading == ProtocolReading::kByStudy;
  fields.forEach(
      name, 0, maxListed(setting.reading, kMaxForms),
      [&](JsonFields& each) {
        if (each.has("questionnaire")) {
          const std::string wanted = byStudy ? each.choice("questionnaire", questionnaireNames())
                                             : each.shortText("questionnaire", kMaxStoredCharacters);
          if (const auto known = findQuestionnaire(wanted, setting.language)) {
            forms.push_back(known->form);
            forms.back().name = fmt::format("{} {}", wanted, when);
          }
        } else {
          const std::string own = readColumnName(each, "name", setting.reading);
          forms.push_back(readFormOutline(each, fmt::format("{} {}", own, when), setting));
        }
        if (byStudy && std::ranges::count(forms, forms.back().name, &ProtocolForm::name) > 1) {
          fields.fail(name, fmt::format("has two of the name \"{}\"", forms.back().name));
        }
      },
      "forms");
  return forms;
}

std::vector<ProtocolForm> readAllForms(JsonFields& protocol, const FormSetting& setting) {
  std::vector<ProtocolForm> forms;
  const auto addOwn = [&](const std::string& name) {
    if (protocol.has(name)) {
      JsonFields inner = protocol.inner(name);
      forms.push_back(readFormOutline(inner, name, setting));
    }
  };
  const auto addList = [&](JsonFields& of, const std::string& name, const std::string& when) {
    std::ranges::move(readFormList(of, name, when, setting), std::back_inserter(forms));
  };
  addOwn("demographics");
  addList(protocol, "before", "before");
  protocol.forEach("blocks", 0, kMaxListed, [&](JsonFields& each) {
    addList(each, "after", "after " + each.shortText("name", kMaxStoredCharacters));
  });
  addList(protocol, "after", "after");
  addOwn("survey");
  return forms;
}

std::vector<ProtocolForm> formsOfProtocolText(const std::string& text, const std::string& where) {
  return readAs("protocols/protocol.schema.json", [&] {
    const JsonDocument document(text, where);
    JsonFields fields(document, UnknownFields::kIgnored);
    const ViewConditions conditions = readConditionNames(fields, [](JsonFields&, TrialView) {});
    return readAllForms(fields, {conditions, ProtocolReading::kByAnalysis, readLanguage(fields)});
  });
}

}  // namespace ocelli
