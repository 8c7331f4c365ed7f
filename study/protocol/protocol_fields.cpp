#include "study/protocol/protocol_fields.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"
#include "study/outline/local_text.h"
#include "study/outline/question_kinds.h"
#include "study/tasks/task_registry.h"
#include "study/trial/trial_words.h"

namespace ocelli {
namespace {

constexpr size_t kMaxParagraphs = 40;
constexpr size_t kMaxPages = 20;
constexpr size_t kMaxRules = 100;

/// The field "picture" where it is an object: which example case of the block, and in which condition.
std::shared_ptr<const PageExample> readExample(JsonFields& fields, const PageTrials* trials) {
  if (trials == nullptr) {
    fields.fail("picture", "shows a trial, which only the instructions of a block can");
  }
  if (!trials->examples) {
    fields.fail("picture", "shows a trial, but the block has no field \"example_cases\" that says of which case");
  }
  JsonFields picture = fields.inner("picture");
  std::vector<std::string> views;
  for (const ViewCondition& condition : trials->conditions.list) {
    views.push_back(condition.name);
  }
  std::vector<std::string> labels;
  for (int i = 0; i < trials->examples->caseCount(); ++i) {
    labels.push_back(trials->examples->caseInfo(i).label);
  }
  auto example = std::make_shared<PageExample>(PageExample{trials->examples, trials->plan});
  example->plan.view = *trials->conditions.viewNamed(picture.choice("condition", views));
  const std::string label = picture.has("case") ? picture.choice("case", labels) : labels.front();
  example->plan.caseIndex = static_cast<int>(std::find(labels.begin(), labels.end(), label) - labels.begin());
  picture.rejectUnknown();
  return example;
}

ProtocolPage pageOf(JsonFields& fields, const std::string& language, const PageTrials* trials = nullptr) {
  ProtocolPage page;
  page.title = localText(fields, "title", kMaxTitleCharacters, language);
  page.paragraphs = localTexts(fields, "paragraphs", 1, kMaxParagraphs, kMaxParagraphCharacters, language);
  if (fields.has("picture") && fields.value("picture").is_object()) {
    page.example = readExample(fields, trials);
  } else if (fields.has("picture")) {
    std::vector<std::string> names;
    for (const TaskKind& kind : taskKinds()) {
      for (const InstructionImage& image : kind.images) {
        names.emplace_back(image.name);
      }
    }
    names.emplace_back(kControlsImage);
    page.image = fields.choice("picture", names);
  }
  return page;
}

/// The question whose answer is called so.
const FormField* findField(const Protocol& protocol, const std::string& name) {
  for (const ProtocolForm* form : formsOf(protocol)) {
    for (const QuestionItem& item : itemsOf(form->fields)) {
      if (item.name == name) {
        return &form->fields[static_cast<size_t>(item.field)];
      }
    }
  }
  return nullptr;
}

std::string kindsOfProtocols() {
  std::string kinds;
  for (const ExclusionKind& kind : kExclusionKinds) {
    kinds += kind.inProtocols ? fmt::format("{}, ", kind.what) : "";
  }
  return kinds;
}

/// Against the forms and sessions of the protocol.
void checkRule(JsonFields& fields, const ExclusionRule& rule, const Protocol& protocol) {
  const std::optional<ExclusionKind> kind = exclusionKindOf(rule.what);
  if (!kind || !kind->inProtocols) {
    fields.fail("what", fmt::format("must be one of {}or form:FIELD", kindsOfProtocols()));
  }
  if (kind->value != ExclusionValue::kText) {
    const double most = kind->value == ExclusionValue::kShare ? 1 : protocol.sessions;
    if (!comparesNumbers(rule.test)) {
      fields.fail("test", fmt::format("must be at_least or at_most, as \"{}\" is a number", rule.what));
    }
    if (!(rule.number >= 0 && rule.number <= most)) {
      fields.fail("value", fmt::format("must be a number between 0 and {} for \"{}\"", most, rule.what));
    }
    return;
  }
  std::vector<std::string> values;
  for (const SessionEnding ending : kSessionEndings) {
    values.emplace_back(nameOf(ending));
  }
  if (kind->what == kFormPrefix) {
    const FormField* field = findField(protocol, rule.what.substr(kFormPrefix.size()));
    if (field == nullptr) {
      fields.fail("what", fmt::format("names \"{}\", but no form asks for that", rule.what));
    }
    if (questionKind(field->kind).value != QuestionValue::kOption) {
      fields.fail("what", fmt::format("names \"{}\", whose answers are not one of several options", rule.what));
    }
    values = storedOptions(*field);
  }
  if (comparesNumbers(rule.test)) {
    fields.fail("test", fmt::format("must be is or is_not, as \"{}\" is no number", rule.what));
  }
  if (std::find(values.begin(), values.end(), rule.text) == values.end()) {
    fields.fail("value", fmt::format("must be one of: {}", fmt::join(values, ", ")));
  }
}

}  // namespace

ProtocolPage readPage(JsonFields& fields, const std::string& name, const std::string& language) {
  JsonFields inner = fields.inner(name);
  ProtocolPage page = pageOf(inner, language);
  inner.rejectUnknown();
  return page;
}

std::vector<ProtocolPage> readPages(JsonFields& fields, const std::string& name, const std::string& language,
                                    const PageTrials* trials) {
  std::vector<ProtocolPage> pages;
  fields.forEach(name, 0, kMaxPages, [&](JsonFields& each) { pages.push_back(pageOf(each, language, trials)); });
  return pages;
}

ProtocolForm readForm(JsonFields& fields, const std::string& name, const FormSetting& setting) {
  JsonFields inner = fields.inner(name);
  ProtocolForm form = readFormOutline(inner, name, setting);
  inner.rejectUnknown();
  return form;
}

ScreenGeometry screenGeometry(const StatedScreen& stated) {
  ScreenGeometry screen;
  screen.widthMillimeters = stated.widthMillimeters.value_or(screen.widthMillimeters);
  screen.heightMillimeters = stated.heightMillimeters.value_or(screen.heightMillimeters);
  screen.distanceMillimeters = stated.distanceMillimeters.value_or(screen.distanceMillimeters);
  screen.minWidth = stated.minWidth.value_or(screen.minWidth);
  screen.minHeight = stated.minHeight.value_or(screen.minHeight);
  screen.refreshHertz = stated.refreshHertz;
  screen.gamma = stated.gamma;
  screen.calibration = stated.calibration;
  screen.photodiodePatch = stated.photodiodePatch;
  return screen;
}

std::vector<ExclusionRule> readExclusions(JsonFields& fields, const Protocol& protocol) {
  std::vector<ExclusionRule> rules;
  fields.forEach("exclusions", 0, kMaxRules, [&](JsonFields& each) {
    rules.push_back(readExclusionRule(each, kMaxParagraphCharacters));
    checkRule(each, rules.back(), protocol);
  });
  return rules;
}

}  // namespace ocelli
