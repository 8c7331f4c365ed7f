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

/// Of a text in UTF-8, as JSON is: bytes that continue a character do not count.
size_t characterCount(const std::string& text) {
  return static_cast<size_t>(
      std::count_if(text.begin(), text.end(), [](char byte) { return (static_cast<uint8_t>(byte) & 0xc0U) != 0x80U; }));
}

std::vector<std::string> readTexts(JsonFields& fields, const std::string& name, size_t least, size_t most,
                                   size_t longest) {
  const nlohmann::json& list = fields.value(name);
  if (!list.is_array() || list.size() < least || list.size() > most) {
    fields.fail(name, fmt::format("must be an array of {} to {} texts", least, most));
  }
  std::vector<std::string> texts;
  for (const nlohmann::json& text : list) {
    if (!text.is_string() || text.get_ref<const std::string&>().empty() ||
        characterCount(text.get_ref<const std::string&>()) > longest) {
      fields.fail(name, fmt::format("must be an array of texts of 1 to {} characters, but entry {} is none", longest,
                                    texts.size() + 1));
    }
    texts.push_back(text.get<std::string>());
  }
  return texts;
}

/// Calls `visit(object, where)` for each entry of an array.
template <class Visit>
void forEachObject(JsonFields& fields, const std::string& name, size_t least, size_t most, const Visit& visit) {
  const nlohmann::json& list = fields.value(name);
  if (!list.is_array() || list.size() < least || list.size() > most) {
    fields.fail(name, fmt::format("must be an array of {} to {} objects", least, most));
  }
  for (size_t i = 0; i < list.size(); ++i) {
    visit(list[i], fmt::format("{}, \"{}\" {}", fields.where(), name, i + 1));
  }
}

ProtocolPage pageOf(const nlohmann::json& json, const std::string& where) {
  JsonFields fields(json, where);
  ProtocolPage page;
  page.title = readShortText(fields, "title", kMaxTitle);
  page.paragraphs = readTexts(fields, "paragraphs", 1, kMaxParagraphs, kMaxParagraph);
  if (fields.has("picture")) {
    std::vector<std::string> names;
    for (const TaskKind& kind : taskKinds()) {
      for (const InstructionImage& image : kind.images) {
        names.emplace_back(image.name);
      }
    }
    names.emplace_back(kControlsImage);
    page.image = readName(fields, "picture", names);
  }
  fields.rejectUnknown();
  return page;
}

/// What names columns of tables: "age_band".
std::string readColumnName(JsonFields& fields) {
  constexpr size_t kMax = 60;
  std::string name = readShortText(fields, "name", kMax);
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

FormField fieldOf(const nlohmann::json& json, const std::string& where, const ViewConditions& conditions) {
  JsonFields fields(json, where);
  FormField field;
  field.name = readColumnName(fields);
  field.question = readShortText(fields, "question", kMaxParagraph);
  field.options = readTexts(fields, "options", 2, kMaxOptions, kMaxTitle);
  if (std::set<std::string>(field.options.begin(), field.options.end()).size() != field.options.size()) {
    fields.fail("options", "must be different from each other");
  }
  if (fields.has("ends")) {
    field.ends = readTexts(fields, "ends", 2, 2, kMaxTitle);
  }
  if (fields.has("favors")) {
    field.favors = readFavors(fields, conditions);
  }
  fields.rejectUnknown();
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

std::string readShortText(JsonFields& fields, const std::string& name, size_t most) {
  std::string text = fields.text(name);
  if (text.empty() || characterCount(text) > most) {
    fields.fail(name, fmt::format("must have 1 to {} characters, not {}", most, characterCount(text)));
  }
  return text;
}

std::string readName(JsonFields& fields, const std::string& name, const std::vector<std::string>& allowed,
                     const std::string& otherwise) {
  if (!otherwise.empty() && !fields.has(name)) {
    return otherwise;
  }
  std::string given = fields.text(name);
  if (std::find(allowed.begin(), allowed.end(), given) == allowed.end()) {
    fields.fail(name, fmt::format("must be one of {}", fmt::join(allowed, ", ")));
  }
  return given;
}

ProtocolPage readPage(JsonFields& fields, const std::string& name) {
  return pageOf(fields.value(name), fmt::format("{}, \"{}\"", fields.where(), name));
}

std::vector<ProtocolPage> readPages(JsonFields& fields, const std::string& name) {
  std::vector<ProtocolPage> pages;
  if (fields.has(name)) {
    forEachObject(fields, name, 0, kMaxPages,
                  [&](const nlohmann::json& json, const std::string& where) { pages.push_back(pageOf(json, where)); });
  }
  return pages;
}

ProtocolForm readForm(JsonFields& fields, const std::string& name, const ViewConditions& conditions) {
  JsonFields inner(fields.value(name), fmt::format("{}, \"{}\"", fields.where(), name));
  ProtocolForm form;
  form.name = name;
  form.title = readShortText(inner, "title", kMaxTitle);
  if (inner.has("introduction")) {
    form.introduction = readShortText(inner, "introduction", kMaxParagraph);
  }
  std::set<std::string> names;
  forEachObject(inner, "fields", 1, kMaxFields, [&](const nlohmann::json& json, const std::string& where) {
    form.fields.push_back(fieldOf(json, where, conditions));
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
  JsonFields inner(fields.value("screen"), fmt::format("{}, \"screen\"", fields.where()));
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
  JsonFields inner(fields.value("timing"), fmt::format("{}, \"timing\"", fields.where()));
  timing.lateFactor = inner.number("late_factor", 1.01, 10, timing.lateFactor);
  timing.maxDroppedShare = inner.number("most_dropped_share", 0, 1, timing.maxDroppedShare);
  timing.maxJitterShare = inner.number("most_jitter_share", 0.001, 10, timing.maxJitterShare);
  timing.refreshTolerance = inner.number("refresh_tolerance", 0.0001, 1, timing.refreshTolerance);
  inner.rejectUnknown();
  return timing;
}

std::vector<ExclusionRule> readExclusions(JsonFields& fields, const Protocol& protocol) {
  std::vector<ExclusionRule> rules;
  if (!fields.has("exclusions")) {
    return rules;
  }
  forEachObject(fields, "exclusions", 0, kMaxRules, [&](const nlohmann::json& json, const std::string& where) {
    JsonFields inner(json, where);
    ExclusionRule rule;
    rule.what = inner.text("what");
    rule.test = readName(inner, "test", {"at_least", "at_most", "is", "is_not"});
    const nlohmann::json& value = inner.value("value");
    if (!value.is_string() && !value.is_number()) {
      inner.fail("value", "must be a text or a number");
    }
    rule.value = value.is_string() ? value.get<std::string>() : value.dump();
    rule.reason = readShortText(inner, "reason", kMaxParagraph);
    checkRule(inner, rule, protocol);
    inner.rejectUnknown();
    rules.push_back(rule);
  });
  return rules;
}

}  // namespace ocelli
