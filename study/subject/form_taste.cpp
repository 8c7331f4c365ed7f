#include "study/subject/form_taste.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <string_view>

#include "study/tasks/task_registry.h"

namespace ocelli {
namespace {

/// Differences that are noticed, and those that are plain, as shares.
constexpr double kNoticed = 0.1;
constexpr double kPlain = 0.3;
constexpr double kSpread = 0.05;

bool mentions(const std::string& text, const std::string& word) {
  const auto found = std::search(text.begin(), text.end(), word.begin(), word.end(), [](char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
  });
  return found != text.end();
}

bool mentionsAny(const std::string& text, const std::vector<std::string>& words) {
  return std::any_of(words.begin(), words.end(), [&](const std::string& word) { return mentions(text, word); });
}

/// Of a scale with ends: its first option speaks for the condition that is not the reference. Protocols without
/// "favors" say it in words.
bool otherIsFirst(const FormField& asked, const ViewConditions& conditions) {
  if (!conditions.isPair()) {
    return true;  // comparedBy() takes them so
  }
  const std::vector<std::string>& words = conditions.of(TrialView::kOther).wordsOfEnds;
  return asked.favors.empty() ? mentionsAny(asked.ends[0], words) && !mentionsAny(asked.ends[1], words)
                              : asked.favors[0] == TrialView::kOther;
}

/// Two conditions that a scale compares: of a pair the reference and the other, or else those of its field "favors".
struct ComparedConditions {
  TrialView reference = TrialView::kReference;
  TrialView other = TrialView::kOther;
};

std::optional<ComparedConditions> comparedBy(const FormField& asked, const ViewConditions& conditions) {
  if (conditions.isPair()) {
    return ComparedConditions{};
  }
  return asked.favors.size() == 2 ? std::optional(ComparedConditions{asked.favors[1], asked.favors[0]}) : std::nullopt;
}

/// By how much harder the reference is than the other condition; nothing where the subject did not have both.
std::optional<double> preferenceOf(const std::string& task, const Efforts& efforts,
                                   const ComparedConditions& compared) {
  const Effort& reference = efforts[indexOfCondition(compared.reference)];
  const Effort& other = efforts[indexOfCondition(compared.other)];
  if (reference.trials == 0 || other.trials == 0) {
    return std::nullopt;
  }
  const double difference = reference.mean() - other.mean();
  switch (taskKind(task, "answers to forms").outcome) {
    case OutcomeKind::kTime:
      return difference;  // of logarithms
    case OutcomeKind::kAnswer:
    case OutcomeKind::kEstimate:
      break;  // of an effort above 0: nobody feels how far an estimate is off, who is not told
  }
  const double sum = reference.mean() + other.mean();
  return sum > 0 ? 2 * difference / sum : 0;
}

/// What a rule is about where it is about the answers of a form: "form:vision".
bool isAbout(const ExclusionRule& rule, const std::string& field) {
  return rule.what.starts_with(kFormPrefix) && std::string_view(rule.what).substr(kFormPrefix.size()) == field;
}

bool excludes(const ExclusionRule& rule, const std::string& option) {
  return (rule.test == ExclusionTest::kIs && option == rule.text) ||
         (rule.test == ExclusionTest::kIsNot && option != rule.text);
}

}  // namespace

int optionOf(const Protocol& protocol, const ProtocolForm& form, int field, const Experience& experience,
             Random& random) {
  const FormField& asked = form.fields[static_cast<size_t>(field)];
  const auto count = static_cast<int>(asked.options.size());
  for (const auto& [task, efforts] : experience) {
    const std::optional<ComparedConditions> compared = comparedBy(asked, protocol.conditions.names);
    const std::optional<double> preference = compared ? preferenceOf(task, efforts, *compared) : std::nullopt;
    const bool isScale = asked.ends.size() == 2 || asked.favors.size() == 2;
    if (isScale && preference && (mentions(asked.name, task) || mentions(asked.question, task))) {
      const double felt = *preference + normal(random, 0, kSpread);
      const double strength = std::abs(felt) < kNoticed ? 0 : std::abs(felt) < kPlain ? 0.5 : 1;
      const double side = (felt > 0) == otherIsFirst(asked, protocol.conditions.names) ? -1 : 1;
      return static_cast<int>(std::lround((1 + side * strength) / 2 * (count - 1)));
    }
  }
  const bool matters = std::any_of(protocol.exclusions.begin(), protocol.exclusions.end(),
                                   [&](const ExclusionRule& rule) { return isAbout(rule, asked.name); });
  for (int option = 0; matters && option < count; ++option) {
    if (std::none_of(protocol.exclusions.begin(), protocol.exclusions.end(), [&](const ExclusionRule& rule) {
          return isAbout(rule, asked.name) && excludes(rule, storedOptions(asked)[static_cast<size_t>(option)]);
        })) {
      return option;
    }
  }
  return static_cast<int>(random.below(asked.options.size()));
}

QuestionEntry entryOf(const Protocol& protocol, const ProtocolForm& form, const QuestionItem& item,
                      const Experience& experience, Random& random) {
  const FormField& field = form.fields[static_cast<size_t>(item.field)];
  const QuestionKind& kind = questionKind(field.kind);
  return kind.value == QuestionValue::kOption
             ? QuestionEntry{{optionOf(protocol, form, item.field, experience, random)}}
             : kind.atRandom(field, random);
}

}  // namespace ocelli
