#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <string_view>

#include "analysis/dataset/analysis_plan.h"
#include "analysis/dataset/csv_table.h"
#include "analysis/dataset/exclusions.h"
#include "analysis/dataset/json_text.h"
#include "analysis/dataset/row_digest.h"
#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"

namespace ocelli {
namespace {

constexpr size_t kMaxNameBytes = 100;
constexpr size_t kMaxParagraphBytes = 4000;
constexpr size_t kMaxEntries = 1000;
constexpr std::array<std::string_view, 7> kFactors{"view",       "session", "moving", "exposure",
                                                   "duplicates", "objects", "trial"};
constexpr std::array<std::string_view, 2> kGroups{"subject", "case"};

template <class List>
std::string joined(const List& list) {
  std::string text;
  for (const auto& each : list) {
    text += fmt::format("{}{}", text.empty() ? "" : ", ", each);
  }
  return text;
}

template <class List>
bool contains(const List& list, std::string_view value) {
  return std::find(list.begin(), list.end(), value) != list.end();
}

std::string choice(JsonObject& fields, const char* name, const auto& allowed) {
  const std::string given = fields.text(name, kMaxNameBytes);
  if (!contains(allowed, given)) {
    fields.fail(name, fmt::format("is \"{}\", but must be one of: {}", given, joined(allowed)));
  }
  return given;
}

template <class Choice, size_t kCount>
Choice choiceOf(JsonObject& fields, const char* name, const Choice (&choices)[kCount]) {
  std::array<std::string_view, kCount> names;
  std::transform(std::begin(choices), std::end(choices), names.begin(), [](Choice each) { return nameOf(each); });
  const std::string given = choice(fields, name, names);
  return choices[std::find(names.begin(), names.end(), given) - names.begin()];
}

/// A name that no earlier element has.
std::string newName(JsonObject& fields, std::set<std::string>& names) {
  std::string name = fields.text("name", kMaxNameBytes);
  if (!names.insert(name).second) {
    fields.fail("name", fmt::format("is \"{}\", as that of another in this list", name));
  }
  return name;
}

void checkTerm(const JsonObject& fields, const char* name, const std::string& term) {
  std::set<std::string_view> factors;
  for (std::string_view rest = term; !rest.empty();) {
    const size_t end = std::min(rest.find(':'), rest.size());
    const std::string_view factor = rest.substr(0, end);
    if (!contains(kFactors, factor) || !factors.insert(factor).second) {
      fields.fail(name, fmt::format("holds \"{}\", but terms are made of different factors among {}, joined by \":\"",
                                    term, joined(kFactors)));
    }
    rest = end < rest.size() ? rest.substr(end + 1) : std::string_view();
  }
  if (term.ends_with(':')) {
    fields.fail(name, fmt::format("holds \"{}\", which ends in \":\"", term));
  }
}

std::vector<std::string> readTerms(JsonObject& fields, const char* name) {
  std::vector<std::string> terms = fields.texts(name, 50, kMaxNameBytes);
  std::set<std::string> seen;
  for (const std::string& term : terms) {
    checkTerm(fields, name, term);
    if (!seen.insert(term).second) {
      fields.fail(name, fmt::format("holds \"{}\" twice", term));
    }
  }
  return terms;
}

PlannedModel readModel(JsonObject& fields, const std::vector<std::string>& tasks, std::set<std::string>& names) {
  PlannedModel model;
  model.name = newName(fields, names);
  model.task = choice(fields, "task", tasks);
  model.kind = choiceOf(fields, "kind", kModelKinds);
  model.terms = readTerms(fields, "terms");
  std::set<std::string> groups;
  fields.forEach("random", 10, [&](JsonObject& each) {
    RandomEffect effect;
    effect.group = choice(each, "group", kGroups);
    if (!groups.insert(effect.group).second) {
      each.fail("group", fmt::format("is \"{}\" a second time", effect.group));
    }
    effect.slopes = readTerms(each, "slopes");
    for (const std::string& slope : effect.slopes) {
      if (isMixed(model.kind) && !model.terms.empty() && !contains(model.terms, slope)) {
        each.fail("slopes",
                  fmt::format("holds \"{}\", which is not a term of the model: {}", slope, joined(model.terms)));
      }
    }
    model.randomEffects.push_back(std::move(effect));
  });
  if (isMixed(model.kind) && (model.terms.empty() || model.randomEffects.empty())) {
    fields.fail(model.terms.empty() ? "terms" : "random", "is missing, and a mixed model needs it");
  }
  return model;
}

Hypothesis readHypothesis(JsonObject& fields, const AnalysisPlan& plan, std::set<std::string>& names) {
  Hypothesis hypothesis;
  hypothesis.name = newName(fields, names);
  hypothesis.statement = fields.text("statement", kMaxParagraphBytes);
  hypothesis.model = fields.text("model", kMaxNameBytes);
  hypothesis.term = fields.textOr("term", kMaxNameBytes, "");
  const PlannedModel* model = plan.findModel(hypothesis.model);
  if (model == nullptr) {
    fields.fail("model", fmt::format("is \"{}\", which \"models\" does not hold", hypothesis.model));
  }
  if (model->kind == ModelKind::kLinearMixed && plan.findTimeouts == TimeoutTreatment::kCensored) {
    fields.fail(
        "model",
        fmt::format("is \"{}\", of the kind linear_mixed, which knows no censored times, but \"find_timeouts\" is "
                    "censored: give the model the kind log_normal_mixed, or set \"find_timeouts\" to "
                    "set_to_limit or removed",
                    model->name));
  }
  if (!hypothesis.term.empty() && !contains(model->terms, hypothesis.term)) {
    fields.fail("term", fmt::format("is \"{}\", but model \"{}\" has the terms: {}", hypothesis.term, model->name,
                                    joined(model->terms)));
  }
  if (hypothesis.term.empty() && !model->terms.empty()) {
    fields.fail("term", fmt::format("is missing; model \"{}\" has the terms: {}", model->name, joined(model->terms)));
  }
  return hypothesis;
}

HypothesisFamily readFamily(JsonObject& fields, const AnalysisPlan& plan, std::set<std::string>& names,
                            std::set<std::string>& taken) {
  HypothesisFamily family;
  family.name = newName(fields, names);
  family.holm = choice(fields, "correction", std::array<std::string_view, 2>{"holm", "none"}) == "holm";
  family.hypotheses = fields.texts("hypotheses", kMaxEntries, kMaxNameBytes);
  for (const std::string& hypothesis : family.hypotheses) {
    if (plan.findHypothesis(hypothesis) == nullptr) {
      fields.fail("hypotheses", fmt::format("names \"{}\", which the plan does not hold", hypothesis));
    }
    if (!taken.insert(hypothesis).second) {
      fields.fail("hypotheses", fmt::format("names \"{}\", which stands in a family already", hypothesis));
    }
  }
  if (family.hypotheses.empty()) {
    fields.fail("hypotheses", "is empty");
  }
  return family;
}

PlannedExclusion readExclusion(JsonObject& fields) {
  PlannedExclusion rule;
  rule.what = fields.text("what", kMaxNameBytes);
  const std::string test = fields.textOr("test", kMaxNameBytes, nameOf(ExclusionTest::kAlways));
  if (fields.has("value")) {
    const nlohmann::json& value = fields.value("value");
    if (value.is_string()) {
      rule.text = fields.text("value", kMaxParagraphBytes);
    } else {
      rule.number = fields.number("value", 0, 1e9);
    }
  }
  rule.reason = fields.text("reason", kMaxParagraphBytes);
  const std::string problem = problemOfRule(rule, test, fields.has("value"), !rule.text.empty());
  if (!problem.empty()) {
    fields.fail("what", problem);
  }
  rule.test = *exclusionTestOf(test);
  return rule;
}

AnalysisPlan readFields(JsonObject& fields, const std::vector<std::string>& plannable) {
  AnalysisPlan plan;
  plan.name = fields.text("name", kMaxNameBytes);
  plan.registered = fields.textOr("registered", kMaxParagraphBytes, "");
  plan.protocolSha256 = fields.textOr("protocol_sha256", 64, "");
  if (!plan.protocolSha256.empty() &&
      (plan.protocolSha256.size() != 64 ||
       plan.protocolSha256.find_first_not_of("0123456789abcdef") != std::string::npos)) {
    fields.fail("protocol_sha256", "must be 64 digits from 0 to 9 and a to f, as `sha256sum PROTOCOL` prints");
  }
  plan.usesProtocolExclusions = fields.booleanOr("protocol_exclusions", true);
  if (fields.has("forced_sessions")) {
    plan.excludesForcedSessions =
        choice(fields, "forced_sessions", std::array<std::string_view, 2>{"excluded", "analysed"}) == "excluded";
  }
  fields.forEach("exclusions", kMaxEntries, [&](JsonObject& each) { plan.exclusions.push_back(readExclusion(each)); });
  if (fields.has("find_timeouts")) {
    plan.findTimeouts = choiceOf(fields, "find_timeouts", kTimeoutTreatments);
  }
  std::set<std::string> modelNames;
  std::set<std::string> hypothesisNames;
  std::set<std::string> familyNames;
  std::set<std::string> inFamilies;
  std::set<std::string> tasks;
  fields.forEach("models", kMaxEntries,
                 [&](JsonObject& each) { plan.models.push_back(readModel(each, plannable, modelNames)); });
  fields.forEach("hypotheses", kMaxEntries,
                 [&](JsonObject& each) { plan.hypotheses.push_back(readHypothesis(each, plan, hypothesisNames)); });
  fields.forEach("families", kMaxEntries,
                 [&](JsonObject& each) { plan.families.push_back(readFamily(each, plan, familyNames, inFamilies)); });
  for (const Hypothesis& hypothesis : plan.hypotheses) {
    if (!inFamilies.contains(hypothesis.name)) {
      fields.fail("families",
                  fmt::format("does not hold hypothesis \"{}\"; a family of its own says that it stands alone",
                              hypothesis.name));
    }
  }
  fields.forEach("equivalence", kMaxEntries, [&](JsonObject& each) {
    PlannedEquivalence bounds;
    bounds.task = choice(each, "task", plannable);
    bounds.lower = each.number("lower", -1, 1);
    bounds.upper = each.number("upper", -1, 1);
    if (!(bounds.lower < 0 && bounds.upper > 0)) {
      each.fail("lower", "must lie below 0, and \"upper\" above it");
    }
    if (!tasks.insert(bounds.task).second) {
      each.fail("task", fmt::format("is \"{}\" a second time", bounds.task));
    }
    plan.equivalence.push_back(std::move(bounds));
  });
  for (const PlannedModel& model : plan.models) {
    if (model.kind == ModelKind::kEquivalence && !tasks.contains(model.task)) {
      fields.fail("equivalence", fmt::format("has no bounds for task \"{}\" of model \"{}\"", model.task, model.name));
    }
  }
  plan.alpha = fields.numberOr("alpha", 1e-6, 0.5, plan.alpha);
  plan.bootstrapSamples =
      static_cast<int>(fields.integerOr("bootstrap_samples", 100, 1'000'000, plan.bootstrapSamples));
  plan.seed = static_cast<uint64_t>(fields.integerOr("seed", 0, 2'147'483'647, static_cast<int64_t>(plan.seed)));
  fields.rejectUnknown();
  return plan;
}

}  // namespace

AnalysisPlan planFromJsonText(const std::string& text, const std::string& where,
                              const std::vector<std::string>& tasks) {
  const JsonText json(text, where, "protocols/analysis_plan.schema.json");
  JsonObject fields(json, json.root(), "");
  AnalysisPlan plan = readFields(fields, tasks);
  plan.sha256 = sha256(text);
  return plan;
}

AnalysisPlan readPlan(const std::string& path, const std::vector<std::string>& tasks) {
  return planFromJsonText(readFile(path, kMaxTextBytes), path, tasks);
}

}  // namespace ocelli
