#include "study/protocol/protocol_fields.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <set>

#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"
#include "study/tasks/task_registry.h"

namespace ocelli {
namespace {

constexpr size_t kMaxParagraphs = 40;
constexpr size_t kMaxParagraph = 4000;
constexpr size_t kMaxPages = 20;
constexpr size_t kMaxFields = 40;
constexpr size_t kMaxOptions = 20;
constexpr size_t kMaxRules = 100;

ProtocolPage pageOf(JsonFields& fields) {
  ProtocolPage page;
  page.title = fields.shortText("title", kMaxTitle);
  page.paragraphs = fields.texts("paragraphs", 1, kMaxParagraphs, kMaxParagraph);
  if (fields.has("picture")) {
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

/// What names columns of tables: "age_band".
std::string readColumnName(JsonFields& fields) {
  constexpr size_t kMax = 60;
  std::string name = fields.shortText("name", kMax);
  const auto isAllowed = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; };
  if (!std::all_of(name.begin(), name.end(), isAllowed) || !(name.front() >= 'a' && name.front() <= 'z')) {
    fields.fail("name", "must be of small letters, digits and _, and begin with a letter, as it names a column");
  }
  return name;
}

/// Both conditions, in either order.
std::vector<TrialView> readFavors(JsonFields& fields, const ViewConditions& conditions) {
  const nlohmann::json& list = fields.value("favors");
  std::vector<TrialView> favors;
  for (size_t i = 0; list.is_array() && i < list.size(); ++i) {
    if (const auto view = list[i].is_string() ? conditions.viewNamed(list[i].get<std::string>()) : std::nullopt) {
      favors.push_back(*view);
    }
  }
  if (!list.is_array() || list.size() != 2 || favors.size() != 2 || favors[0] == favors[1]) {
    const auto& [reference, other] = conditions.list;
    fields.fail("favors",
                fmt::format(R"(must be ["{0}", "{1}"] or ["{1}", "{0}"]: the condition that the first option )"
                            "speaks for, and that of the last",
                            reference.name, other.name));
  }
  return favors;
}

FormField fieldOf(JsonFields& fields, const ViewConditions& conditions) {
  FormField field;
  field.name = readColumnName(fields);
  field.question = fields.shortText("question", kMaxParagraph);
  field.options = fields.texts("options", 2, kMaxOptions, kMaxTitle);
  if (std::set<std::string>(field.options.begin(), field.options.end()).size() != field.options.size()) {
    fields.fail("options", "must be different from each other");
  }
  if (fields.has("ends")) {
    field.ends = fields.texts("ends", 2, 2, kMaxTitle);
  }
  if (fields.has("favors")) {
    field.favors = readFavors(fields, conditions);
  }
  return field;
}

const FormField* findField(const Protocol& protocol, const std::string& name) {
  for (const std::optional<ProtocolForm>* form : {&protocol.demographics, &protocol.survey}) {
    if (*form) {
      for (const FormField& field : (*form)->fields) {
        if (field.name == name) {
          return &field;
        }
      }
    }
  }
  return nullptr;
}

void checkRule(JsonFields& fields, const ExclusionRule& rule, const Protocol& protocol) {
  static const std::vector<std::string> kFigures{"sessions_completed", "timeout_share", "dropped_share"};
  static const std::vector<std::string> kEndings{"completed", "unwell", "aborted", "declined", "failed"};
  const std::string kForm = "form:";
  const bool isFigure = std::find(kFigures.begin(), kFigures.end(), rule.what) != kFigures.end();
  const bool compares = rule.test == "at_least" || rule.test == "at_most";
  std::vector<std::string> values = kEndings;
  if (rule.what.starts_with(kForm)) {
    const FormField* field = findField(protocol, rule.what.substr(kForm.size()));
    if (field == nullptr) {
      fields.fail("what", fmt::format("names \"{}\", but neither demographics nor survey ask for that", rule.what));
    }
    values = field->options;
  } else if (!isFigure && rule.what != "ending") {
    fields.fail("what", fmt::format("must be one of {}, ending, or form:FIELD", fmt::join(kFigures, ", ")));
  }
  if (isFigure) {
    double number = 0;
    const char* end = rule.value.data() + rule.value.size();
    const auto read = std::from_chars(rule.value.data(), end, number);
    const double most = rule.what.ends_with("_share") ? 1 : protocol.sessions;
    if (!compares) {
      fields.fail("test", fmt::format("must be at_least or at_most, as \"{}\" is a number", rule.what));
    }
    if (read.ec != std::errc() || read.ptr != end || !(number >= 0 && number <= most)) {
      fields.fail("value", fmt::format("must be a number between 0 and {} for \"{}\"", most, rule.what));
    }
  } else if (compares) {
    fields.fail("test", fmt::format("must be is or is_not, as \"{}\" is no number", rule.what));
  } else if (std::find(values.begin(), values.end(), rule.value) == values.end()) {
    fields.fail("value", fmt::format("must be one of: {}", fmt::join(values, ", ")));
  }
}

}  // namespace

ProtocolPage readPage(JsonFields& fields, const std::string& name) {
  JsonFields inner = fields.inner(name);
  ProtocolPage page = pageOf(inner);
  inner.rejectUnknown();
  return page;
}

std::vector<ProtocolPage> readPages(JsonFields& fields, const std::string& name) {
  std::vector<ProtocolPage> pages;
  fields.forEach(name, 0, kMaxPages, [&](JsonFields& each) { pages.push_back(pageOf(each)); });
  return pages;
}

ProtocolForm readForm(JsonFields& fields, const std::string& name, const ViewConditions& conditions) {
  JsonFields inner = fields.inner(name);
  ProtocolForm form;
  form.name = name;
  form.title = inner.shortText("title", kMaxTitle);
  form.introduction = inner.shortText("introduction", kMaxParagraph, "");
  std::set<std::string> names;
  inner.forEach("fields", 1, kMaxFields, [&](JsonFields& each) {
    form.fields.push_back(fieldOf(each, conditions));
    if (!names.insert(form.fields.back().name).second) {
      inner.fail("fields", fmt::format("has two of the name \"{}\"", form.fields.back().name));
    }
  });
  inner.rejectUnknown();
  return form;
}

ScreenGeometry readScreen(JsonFields& fields) {
  ScreenGeometry screen;
  if (!fields.has("screen")) {
    return screen;
  }
  JsonFields inner = fields.inner("screen");
  screen.widthMillimeters = inner.number("width_millimeters", 50, 10000, screen.widthMillimeters);
  screen.heightMillimeters = inner.number("height_millimeters", 50, 10000, screen.heightMillimeters);
  screen.distanceMillimeters = inner.number("distance_millimeters", 50, 20000, screen.distanceMillimeters);
  screen.minWidth = inner.integer("least_width", 640, 16384, screen.minWidth);
  screen.minHeight = inner.integer("least_height", 480, 16384, screen.minHeight);
  if (inner.has("refresh_hertz")) {
    screen.refreshHertz = inner.number("refresh_hertz", 10, 1000);
  }
  screen.photodiodePatch = inner.boolean("photodiode_patch", screen.photodiodePatch);
  inner.rejectUnknown();
  return screen;
}

TimingLimits readTiming(JsonFields& fields) {
  TimingLimits timing;
  if (!fields.has("timing")) {
    return timing;
  }
  JsonFields inner = fields.inner("timing");
  timing.lateFactor = inner.number("late_factor", 1.01, 10, timing.lateFactor);
  timing.maxDroppedShare = inner.number("most_dropped_share", 0, 1, timing.maxDroppedShare);
  timing.maxJitterShare = inner.number("most_jitter_share", 0.001, 10, timing.maxJitterShare);
  timing.refreshTolerance = inner.number("refresh_tolerance", 0.0001, 1, timing.refreshTolerance);
  inner.rejectUnknown();
  return timing;
}

std::vector<ExclusionRule> readExclusions(JsonFields& fields, const Protocol& protocol) {
  std::vector<ExclusionRule> rules;
  fields.forEach("exclusions", 0, kMaxRules, [&](JsonFields& each) {
    ExclusionRule rule;
    rule.what = each.text("what");
    rule.test = each.choice("test", {"at_least", "at_most", "is", "is_not"});
    const nlohmann::json& value = each.value("value");
    if (!value.is_string() && !value.is_number()) {
      each.fail("value", "must be a text or a number");
    }
    rule.value = value.is_string() ? value.get<std::string>() : value.dump();
    rule.reason = each.shortText("reason", kMaxParagraph);
    checkRule(each, rule, protocol);
    rules.push_back(rule);
  });
  return rules;
}

}  // namespace ocelli
