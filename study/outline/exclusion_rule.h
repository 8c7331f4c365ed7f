// Rules about who and what an analysis leaves out. Protocols and plans of analyses have them; a study only stores its
// own.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace ocelli {

class JsonFields;

enum class ExclusionTest : uint8_t {
  kAlways,  ///< what is told needs no value
  kIs,
  kIsNot,
  kAtLeast,
  kAtMost,
};
inline constexpr std::array kExclusionTests{ExclusionTest::kAlways, ExclusionTest::kIs, ExclusionTest::kIsNot,
                                            ExclusionTest::kAtLeast, ExclusionTest::kAtMost};
const char* nameOf(ExclusionTest test);
/// The test of that name.
std::optional<ExclusionTest> exclusionTestOf(std::string_view name);
constexpr bool comparesNumbers(ExclusionTest test) {
  return test == ExclusionTest::kAtLeast || test == ExclusionTest::kAtMost;
}

/// What is left out.
struct ExclusionRule {
  std::string what;  ///< a row of kExclusionKinds, or "form:FIELD"
  ExclusionTest test = ExclusionTest::kAlways;
  std::string text{};       ///< of kIs and kIsNot
  double number = 0;        ///< of kAtLeast and kAtMost
  std::string reason;       ///< for the log: "impaired vision"
  bool ofProtocol = false;  ///< the protocol has the rule
};

/// What a rule leaves out, and what its value is.
enum class ExclusionLevel : uint8_t { kSubject, kSession, kTrial };
enum class ExclusionValue : uint8_t { kNone, kText, kNumber, kShare };

struct ExclusionKind {
  std::string_view what;
  ExclusionLevel level;
  ExclusionValue value;
  bool inProtocols;  ///< or in plans of analyses alone
};
inline constexpr ExclusionKind kExclusionKinds[] = {
    {"subject", ExclusionLevel::kSubject, ExclusionValue::kText, false},  // an id
    {"ending", ExclusionLevel::kSubject, ExclusionValue::kText, true},    // of any session: kSessionEndings
    {"sessions_completed", ExclusionLevel::kSubject, ExclusionValue::kNumber, true},
    {"timeout_share", ExclusionLevel::kSubject, ExclusionValue::kShare, true},
    {"dropped_share", ExclusionLevel::kSubject, ExclusionValue::kShare, true},  // of all its frames
    // Not reached in a block that has practice.
    {"practice_criterion", ExclusionLevel::kSubject, ExclusionValue::kNone, false},
    {"incomplete_session", ExclusionLevel::kSession, ExclusionValue::kNone, false},
    {"forced_session", ExclusionLevel::kSession, ExclusionValue::kNone, false},
    {"timing_verdict", ExclusionLevel::kTrial, ExclusionValue::kText, false},  // kTimingVerdicts
    {"trial_dropped_share", ExclusionLevel::kTrial, ExclusionValue::kShare, false},
};
/// Of the answer to a field of a form: "form:vision".
inline constexpr std::string_view kFormPrefix = "form:";
/// The row of `what`; one of the level of subjects for "form:FIELD"; nothing where there is none.
std::optional<ExclusionKind> exclusionKindOf(std::string_view what);

/// A rule of a protocol: the fields "what", "test", "value" and "reason". The value may be written as a text or as a
/// number: a number that is none is NaN. Throws InputError naming the field where one is missing or mistyped; whether
/// the rule makes sense is for the caller to check.
ExclusionRule readExclusionRule(JsonFields& fields, size_t maxReasonCharacters);

}  // namespace ocelli
