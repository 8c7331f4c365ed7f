#include "study/outline/exclusion_rule.h"

#include <charconv>
#include <cmath>

#include "oc_core/base/json_fields.h"
#include "study/trial/trial_words.h"

namespace ocelli {
namespace {

constexpr ExclusionTest kTestsOfProtocols[] = {ExclusionTest::kAtLeast, ExclusionTest::kAtMost, ExclusionTest::kIs,
                                               ExclusionTest::kIsNot};

double numberOrNan(const std::string& text) {
  double number = 0;
  const char* end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, number);
  return read.ec == std::errc() && read.ptr == end ? number : std::nan("");
}

}  // namespace

const char* nameOf(ExclusionTest test) {
  switch (test) {
    case ExclusionTest::kAlways:
      return "always";
    case ExclusionTest::kIs:
      return "is";
    case ExclusionTest::kIsNot:
      return "is_not";
    case ExclusionTest::kAtLeast:
      return "at_least";
    case ExclusionTest::kAtMost:
      return "at_most";
  }
  return "";
}

std::optional<ExclusionTest> exclusionTestOf(std::string_view name) {
  return wordNamed(name, kExclusionTests);
}

std::optional<ExclusionKind> exclusionKindOf(std::string_view what) {
  if (what.starts_with(kFormPrefix) && what.size() > kFormPrefix.size()) {
    return ExclusionKind{kFormPrefix, ExclusionLevel::kSubject, ExclusionValue::kText, true};
  }
  for (const ExclusionKind& kind : kExclusionKinds) {
    if (kind.what == what) {
      return kind;
    }
  }
  return std::nullopt;
}

ExclusionRule readExclusionRule(JsonFields& fields, size_t maxReasonCharacters) {
  ExclusionRule rule;
  rule.what = fields.text("what");
  rule.test = fields.choiceOf("test", kTestsOfProtocols);
  const nlohmann::json& value = fields.value("value");
  if (!value.is_string() && !value.is_number()) {
    fields.fail("value", "must be a text or a number");
  }
  const std::optional<ExclusionKind> kind = exclusionKindOf(rule.what);
  const std::string text = value.is_string() ? value.get<std::string>() : value.dump();
  if (kind && (kind->value == ExclusionValue::kNumber || kind->value == ExclusionValue::kShare)) {
    rule.number = numberOrNan(text);
  } else {
    rule.text = text;
  }
  rule.reason = fields.shortText("reason", maxReasonCharacters);
  rule.ofProtocol = true;
  return rule;
}

}  // namespace ocelli
