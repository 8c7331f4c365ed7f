// What is decided before the data are seen: who is left out, which hypotheses are tested by which models, and how.
// analysis_plan.schema.json in protocols/ lists the fields of the file.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "study/outline/exclusion_rule.h"

namespace ocelli {

/// How a trial counts whose time ran out.
enum class TimeoutTreatment : uint8_t {
  kCensored,    ///< the response would have come later
  kRemoved,     ///< as the text of 2010 does
  kSetToLimit,  ///< as if the response had come at the limit
};
inline constexpr TimeoutTreatment kTimeoutTreatments[] = {TimeoutTreatment::kCensored, TimeoutTreatment::kRemoved,
                                                          TimeoutTreatment::kSetToLimit};
const char* nameOf(TimeoutTreatment treatment);

enum class ModelKind : uint8_t {
  kLinearMixed,     ///< of the logarithm of times: knows no censored ones
  kLogNormalMixed,  ///< likewise, and of censored times
  kBinomialMixed,   ///< of right answers
  kKaplanMeier,
  kCox,
  kLogNormalSurvival,
  kMcNemar,
  kSignedError,
  kEquivalence,
  kBayesFactor,
  kAgainstChance,
  kOrdinal,
  kSignedErrorMixed,    ///< of signed errors of estimates: log(estimate / truth) of lengths, degrees of directions
  kAbsoluteErrorMixed,  ///< of the logarithm of their absolute values
};
inline constexpr ModelKind kModelKinds[] = {ModelKind::kLinearMixed,
                                            ModelKind::kLogNormalMixed,
                                            ModelKind::kBinomialMixed,
                                            ModelKind::kKaplanMeier,
                                            ModelKind::kCox,
                                            ModelKind::kLogNormalSurvival,
                                            ModelKind::kMcNemar,
                                            ModelKind::kSignedError,
                                            ModelKind::kEquivalence,
                                            ModelKind::kBayesFactor,
                                            ModelKind::kAgainstChance,
                                            ModelKind::kOrdinal,
                                            ModelKind::kSignedErrorMixed,
                                            ModelKind::kAbsoluteErrorMixed};
const char* nameOf(ModelKind kind);

/// What a model is of.
enum class ModelOutcome : uint8_t {
  kTimes,
  kAnswers,    ///< whether they are right, or how they differ from what is right; of forms, what is answered
  kEstimates,  ///< answers that are numbers (study/trial/estimated_value.h)
};
ModelOutcome modelOutcomeOf(ModelKind kind);
bool isOfTimes(ModelKind kind);
/// Whether the kind has random effects.
bool isMixed(ModelKind kind);

/// (1 + slopes | group), as planned; analysis/report/planned_design.h has what is fitted of it.
struct RandomEffect {
  std::string group;  ///< "subject" or "case" (Trial::item())
  std::vector<std::string> slopes{};
};

struct PlannedModel {
  std::string name;
  std::string task;  ///< "find"
  ModelKind kind = ModelKind::kLinearMixed;
  /// Of "view" (the condition), "session", "moving", "exposure", "duplicates", "objects", "trial", and of
  /// AnalysisPlan::factors; "view:session" is an interaction.
  std::vector<std::string> terms{};
  std::vector<RandomEffect> randomEffects{};
};

struct Hypothesis {
  std::string name;
  std::string statement;  ///< for the reader
  std::string model;      ///< name of the model that tests it
  std::string term;       ///< of the model; empty where the test has but one
};

/// Two levels of a factor that a contrast compares.
struct ContrastLevels {
  std::string factor;
  std::string first;   ///< less
  std::string second;  ///< this one
};

/// A comparison of conditions by a model: weights of conditions, which sum to 0, or levels of factors. Of one factor
/// the levels are a main effect (means over the other factors), of several their interaction (difference of
/// differences).
struct PlannedContrast {
  std::string name;
  std::string statement{};                                ///< for the reader; empty: the name
  std::string model;                                      ///< name of the mixed model that estimates it
  std::string family{};                                   ///< p values are corrected in it by Holm's method
  std::vector<std::pair<std::string, double>> weights{};  ///< by names of conditions
  std::vector<ContrastLevels> levels{};
};

struct HypothesisFamily {
  std::string name;
  bool holm = true;  ///< or no correction
  std::vector<std::string> hypotheses;
};

/// Differences (other less reference) that are too small to matter.
struct PlannedEquivalence {
  std::string task;
  double lower = 0;  ///< of proportions of right answers
  double upper = 0;
};

struct AnalysisPlan {
  std::string name;              ///< empty: there is no plan, these are the defaults
  std::string registered{};      ///< where and when, in the words of the file
  std::string sha256{};          ///< of the file, 64 hexadecimal digits; empty where there is none
  std::string protocolSha256{};  ///< of the protocol that it is for, where it says so

  bool usesProtocolExclusions = true;
  /// Sessions whose timing check failed and that were started nevertheless; a rule about them says it too.
  bool excludesForcedSessions = true;
  std::vector<ExclusionRule> exclusions{};
  TimeoutTreatment findTimeouts = TimeoutTreatment::kCensored;
  std::vector<PlannedModel> models{};
  std::vector<Hypothesis> hypotheses{};
  std::vector<HypothesisFamily> families{};
  std::vector<PlannedEquivalence> equivalence{};
  std::vector<std::string> factors{};  ///< of the protocol, that terms and slopes may name
  std::vector<PlannedContrast> contrasts{};

  double alpha = 0.05;
  int bootstrapSamples = 2000;
  uint64_t seed = 1;

  bool isRegistered() const { return !name.empty(); }
  const PlannedModel* findModel(const std::string& model) const;
  const Hypothesis* findHypothesis(const std::string& hypothesis) const;
};

/// "plan \"rosen2010\", registered ..., SHA-256 ..." or that no plan was registered and these are defaults.
std::string describe(const AnalysisPlan& plan);

/// `tasks`: those that a plan may name. Throws InputError that says line and field.
AnalysisPlan readPlan(const std::string& path, const std::vector<std::string>& tasks);
AnalysisPlan planFromJsonText(const std::string& text, const std::string& where, const std::vector<std::string>& tasks);

}  // namespace ocelli
