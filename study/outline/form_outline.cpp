#include "study/outline/form_outline.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "oc_core/base/json_fields.h"
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

}  // namespace ocelli
