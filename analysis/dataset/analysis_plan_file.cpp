#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string_view>

#include "analysis/dataset/analysis_plan.h"
#include "analysis/dataset/csv_table.h"
#include "analysis/dataset/exclusions.h"
#include "analysis/dataset/row_digest.h"
#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/json_fields.h"

namespace ocelli {
namespace {

// Characters.
constexpr size_t kMaxName = 100;
constexpr size_t kMaxParagraph = 4000;
constexpr size_t kMaxEntries = 1000;
constexpr std::array<std::string_view, 7> kFactors{"view",       "session", "moving", "exposure",
                                                   "duplicates", "objects", "trial"};

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

/// A name that no earlier element has.
std::string newName(JsonFields& fields, std::set<std::string>& names) {
  std::string name = fields.shortText("name", kMaxName);
  if (!names.insert(name).second) {
    fields.fail("name", fmt::format("is \"{}\", as that of another in this list", name));
  }
  return name;
}

void checkTerm(const JsonFields& fields, const char* name, const std::string& term,
               const std::vector<std::string>& ofProtocol) {
  std::set<std::string_view> factors;
  for (std::string_view rest = term; !rest.empty();) {
    const size_t end = std::min(rest.find(':'), rest.size());
    const std::string_view factor = rest.substr(0, end);
    if ((!contains(kFactors, factor) && !contains(ofProtocol, factor)) || !factors.insert(factor).second) {
      fields.fail(name, fmt::format("holds \"{}\", but terms are made of different factors among {}, joined by \":\"",
                                    term, joined(kFactors) + (ofProtocol.empty() ? "" : ", " + joined(ofProtocol))));
    }
    rest = end < rest.size() ? rest.substr(end + 1) : std::string_view();
  }
  if (term.ends_with(':')) {
    fields.fail(name, fmt::format("holds \"{}\", which ends in \":\"", term));
  }
}

/// "condition" is another word for "view".
std::string withViewForCondition(const std::string& term) {
  std::string result;
  for (size_t at = 0; at <= term.size();) {
    const size_t end = std::min(term.find(':', at), term.size());
    const std::string factor = term.substr(at, end - at);
    result += factor == "condition" ? std::string("view") : factor;
    result += end < term.size() ? ":" : "";
    at = end + 1;
  }
  return result;
}

std::vector<std::string> readTerms(JsonFields& fields, const char* name, const std::vector<std::string>& ofProtocol) {
  std::vector<std::string> terms = fields.texts(name, 0, 50, kMaxName);
  std::set<std::string> seen;
  for (std::string& term : terms) {
    term = withViewForCondition(term);
    checkTerm(fields, name, term, ofProtocol);
    if (!seen.insert(term).second) {
      fields.fail(name, fmt::format("holds \"{}\" twice", term));
    }
  }
  return terms;
}

PlannedModel readModel(JsonFields& fields, const std::vector<std::string>& tasks,
                       const std::vector<std::string>& factors, std::set<std::string>& names) {
  PlannedModel model;
  model.name = newName(fields, names);
  model.task = fields.choice("task", tasks);
  model.kind = fields.choiceOf("kind", kModelKinds);
  model.terms = readTerms(fields, "terms", factors);
  std::set<std::string> groups;
  fields.forEach("random", 0, 10, [&](JsonFields& each) {
    RandomEffect effect;
    effect.group = each.choice("group", {"subject", "case"});
    if (!groups.insert(effect.group).second) {
      each.fail("group", fmt::format("is \"{}\" a second time", effect.group));
    }
    effect.slopes = readTerms(each, "slopes", factors);
    for (const std::string& slope : effect.slopes) {
      if (!contains(factors, slope) && isMixed(model.kind) && !model.terms.empty() && !contains(model.terms, slope)) {
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

Hypothesis readHypothesis(JsonFields& fields, const AnalysisPlan& plan, std::set<std::string>& names) {
  Hypothesis hypothesis;
  hypothesis.name = newName(fields, names);
  hypothesis.statement = fields.shortText("statement", kMaxParagraph);
  hypothesis.model = fields.shortText("model", kMaxName);
  hypothesis.term = fields.shortText("term", kMaxName, "");
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

ContrastLevels readContrastLevels(const JsonFields& fields, const std::string& factor, const nlohmann::json& levels,
                                  const AnalysisPlan& plan) {
  const bool areTwo = levels.is_array() && levels.size() == 2 && levels[0].is_string() && levels[1].is_string();
  if (!areTwo || levels[0] == levels[1]) {
    fields.fail("factors", fmt::format("must give two different levels for \"{}\": [\"graph\", \"pinhole\"] is graph "
                                       "less pinhole",
                                       factor));
  }
  if (!contains(plan.factors, factor)) {
    fields.fail("factors", fmt::format("names \"{}\", but the field \"factors\" of the plan has: {}", factor,
                                       joined(plan.factors)));
  }
  return {factor, levels[0].get<std::string>(), levels[1].get<std::string>()};
}

PlannedContrast readContrast(JsonFields& fields, const AnalysisPlan& plan, std::set<std::string>& names) {
  constexpr double kMaxWeight = 1000;
  PlannedContrast contrast;
  contrast.name = newName(fields, names);
  contrast.statement = fields.shortText("statement", kMaxParagraph, "");
  contrast.model = fields.shortText("model", kMaxName);
  contrast.family = fields.shortText("family", kMaxName, contrast.model);
  const PlannedModel* model = plan.findModel(contrast.model);
  if (model == nullptr || !isMixed(model->kind)) {
    fields.fail("model", fmt::format("is \"{}\", which is no mixed model of \"models\"", contrast.model));
  }
  const int ways =
      (fields.has("conditions") ? 1 : 0) + (fields.has("weights") ? 1 : 0) + (fields.has("factors") ? 1 : 0);
  if (ways != 1) {
    fields.fail("conditions", "or \"weights\" or \"factors\" must say what is compared: one of them");
  }
  if (fields.has("conditions")) {
    const std::vector<std::string> pair = fields.texts("conditions", 2, 2, kMaxName);
    if (pair[0] == pair[1]) {
      fields.fail("conditions", "must be two different conditions: the first is compared with the second");
    }
    contrast.weights = {{pair[0], 1}, {pair[1], -1}};
  } else if (fields.has("weights")) {
    JsonFields weights = fields.inner("weights");
    double sum = 0;
    for (const auto& [condition, weight] : fields.value("weights").items()) {
      contrast.weights.emplace_back(condition, weights.number(condition, -kMaxWeight, kMaxWeight));
      sum += contrast.weights.back().second;
    }
    weights.rejectUnknown();
    const auto isNone = [](const auto& each) { return each.second == 0; };
    if (std::abs(sum) > 1e-9 || std::all_of(contrast.weights.begin(), contrast.weights.end(), isNone)) {
      fields.fail("weights", fmt::format("must sum to 0 and not all be 0, but their sum is {:g}", sum));
    }
  } else {
    JsonFields levels = fields.inner("factors");
    for (const auto& [factor, two] : fields.value("factors").items()) {
      contrast.levels.push_back(readContrastLevels(fields, factor, levels.value(factor), plan));
    }
    if (contrast.levels.empty()) {
      fields.fail("factors", "is empty");
    }
  }
  return contrast;
}

HypothesisFamily readFamily(JsonFields& fields, const AnalysisPlan& plan, std::set<std::string>& names,
                            std::set<std::string>& taken) {
  HypothesisFamily family;
  family.name = newName(fields, names);
  family.holm = fields.choice("correction", {"holm", "none"}) == "holm";
  family.hypotheses = fields.texts("hypotheses", 0, kMaxEntries, kMaxName);
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

ExclusionRule readExclusion(JsonFields& fields) {
  ExclusionRule rule;
  rule.what = fields.shortText("what", kMaxName);
  const std::string test = fields.shortText("test", kMaxName, nameOf(ExclusionTest::kAlways));
  if (fields.has("value")) {
    const nlohmann::json& value = fields.value("value");
    if (value.is_string()) {
      rule.text = fields.shortText("value", kMaxParagraph);
    } else {
      rule.number = fields.number("value", 0, 1e9);
    }
  }
  rule.reason = fields.shortText("reason", kMaxParagraph);
  const std::string problem = problemOfRule(rule, test, fields.has("value"), !rule.text.empty());
  if (!problem.empty()) {
    fields.fail("what", problem);
  }
  rule.test = *exclusionTestOf(test);
  return rule;
}

AnalysisPlan readFields(JsonFields& fields, const std::vector<std::string>& plannable) {
  AnalysisPlan plan;
  plan.name = fields.shortText("name", kMaxName);
  plan.registered = fields.shortText("registered", kMaxParagraph, "");
  plan.protocolSha256 = fields.shortText("protocol_sha256", 64, "");
  if (!plan.protocolSha256.empty() &&
      (plan.protocolSha256.size() != 64 ||
       plan.protocolSha256.find_first_not_of("0123456789abcdef") != std::string::npos)) {
    fields.fail("protocol_sha256", "must be 64 digits from 0 to 9 and a to f, as `sha256sum PROTOCOL` prints");
  }
  plan.usesProtocolExclusions = fields.boolean("protocol_exclusions", true);
  if (fields.has("forced_sessions")) {
    plan.excludesForcedSessions = fields.choice("forced_sessions", {"excluded", "analysed"}) == "excluded";
  }
  fields.forEach("exclusions", 0, kMaxEntries,
                 [&](JsonFields& each) { plan.exclusions.push_back(readExclusion(each)); });
  if (fields.has("find_timeouts")) {
    plan.findTimeouts = fields.choiceOf("find_timeouts", kTimeoutTreatments);
  }
  std::set<std::string> modelNames;
  std::set<std::string> hypothesisNames;
  std::set<std::string> familyNames;
  std::set<std::string> inFamilies;
  std::set<std::string> contrastNames;
  std::set<std::string> tasks;
  plan.factors = fields.texts("factors", 0, 20, kMaxName);
  fields.forEach("models", 0, kMaxEntries, [&](JsonFields& each) {
    plan.models.push_back(readModel(each, plannable, plan.factors, modelNames));
  });
  fields.forEach("contrasts", 0, kMaxEntries,
                 [&](JsonFields& each) { plan.contrasts.push_back(readContrast(each, plan, contrastNames)); });
  fields.forEach("hypotheses", 0, kMaxEntries,
                 [&](JsonFields& each) { plan.hypotheses.push_back(readHypothesis(each, plan, hypothesisNames)); });
  fields.forEach("families", 0, kMaxEntries,
                 [&](JsonFields& each) { plan.families.push_back(readFamily(each, plan, familyNames, inFamilies)); });
  for (const Hypothesis& hypothesis : plan.hypotheses) {
    if (!inFamilies.contains(hypothesis.name)) {
      fields.fail("families",
                  fmt::format("does not hold hypothesis \"{}\"; a family of its own says that it stands alone",
                              hypothesis.name));
    }
  }
  fields.forEach("equivalence", 0, kMaxEntries, [&](JsonFields& each) {
    PlannedEquivalence bounds;
    bounds.task = each.choice("task", plannable);
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
  plan.alpha = fields.number("alpha", 1e-6, 0.5, plan.alpha);
  plan.bootstrapSamples = fields.integer("bootstrap_samples", 100, 1'000'000, plan.bootstrapSamples);
  plan.seed = static_cast<uint64_t>(fields.integer("seed", 0, 2'147'483'647, static_cast<int>(plan.seed)));
  fields.rejectUnknown();
  return plan;
}

}  // namespace

AnalysisPlan planFromJsonText(const std::string& text, const std::string& where,
                              const std::vector<std::string>& tasks) {
  return readAs("protocols/analysis_plan.schema.json", [&] {
    const JsonDocument document(text, where);
    JsonFields fields(document);
    AnalysisPlan plan = readFields(fields, tasks);
    plan.sha256 = sha256(text);
    return plan;
  });
}

AnalysisPlan readPlan(const std::string& path, const std::vector<std::string>& tasks) {
  return planFromJsonText(readFile(path, kMaxTextBytes), path, tasks);
}

}  // namespace ocelli
