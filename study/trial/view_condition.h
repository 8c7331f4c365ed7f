// The view conditions of a study: 1 to kMaxConditions rows that the protocol names in its field "conditions". The first
// is the reference. A protocol without that field compares planar pinhole cameras with graph cameras
// (defaultConditions()). What a condition shows is said by study/task/scene_view.h. Factors, such as a camera and a
// height of the eye, describe conditions: each has a level of each factor.
//
// A study of two conditions is a pair: the reference and the other, whose effect against it is what is asked. Texts
// about a pair are written before the names are put in: they hold the marks kReferenceMark and kOtherMark, which become
// the labels where people read, and the names in cells, files and commands.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ocelli {

inline constexpr size_t kMaxConditions = 16;

/// The condition of a trial: its place in the list of the study, from 0. The first two have names of their own, which
/// are those of a pair; conditionAt() gives any.
enum class TrialView : uint8_t { kReference, kOther };
constexpr TrialView conditionAt(size_t index) {
  return static_cast<TrialView>(index);
}
constexpr size_t indexOfCondition(TrialView view) {
  return static_cast<size_t>(view);
}

/// Of a pair.
inline constexpr std::array kViews = {TrialView::kReference, TrialView::kOther};
constexpr TrialView otherThan(TrialView view) {
  return view == TrialView::kReference ? TrialView::kOther : TrialView::kReference;
}

/// What conditions, or cases, differ in: "camera", with the levels "pinhole" and "graph".
struct StudyFactor {
  std::string name;
  std::vector<std::string> levels;
  bool ofCases = false;  ///< each case has a level, or else each condition

  bool operator==(const StudyFactor&) const = default;
};
/// The level of each factor, by the factor's name.
using FactorLevels = std::map<std::string, std::string>;

struct ViewCondition {
  std::string name;                        ///< as databases, tables, plans and cells of reports have it: "gc"
  std::string label;                       ///< for readers, without an article: "graph camera"
  std::string description{};               ///< at its first mention; empty: the label
  std::vector<std::string> wordsOfEnds{};  ///< that stand for it in the ends of scales, in small letters
  FactorLevels levels{};                   ///< of each factor of conditions

  bool operator==(const ViewCondition&) const = default;
};

struct ViewConditions {
  std::vector<ViewCondition> list{};   ///< the reference first
  std::vector<StudyFactor> factors{};  ///< that conditions and cases have levels of

  size_t size() const { return list.size(); }
  /// Two conditions: effects are those of the other against the reference.
  bool isPair() const { return list.size() == kViews.size(); }
  /// All, in their order.
  std::vector<TrialView> all() const;
  /// Throws std::out_of_range for a condition that the study does not have.
  const ViewCondition& of(TrialView view) const { return list.at(indexOfCondition(view)); }
  const std::string& nameOf(TrialView view) const { return of(view).name; }
  const std::string& labelOf(TrialView view) const { return of(view).label; }
  /// Nothing where no condition has the name.
  std::optional<TrialView> viewNamed(std::string_view name) const;
  /// "ppc or gc", "a, b or c".
  std::string namesText(const char* lastWord = "or") const;
  /// What a column of views may hold: "must be ppc or gc".
  std::string mustBe() const;
  bool hasNamesOf(const ViewConditions& others) const;
  /// What is wrong with the names or labels, and of which condition it is; nothing where they can stand.
  struct Problem {
    size_t index = 0;
    const char* field = "";
    std::string what;
  };
  std::optional<Problem> problem() const;

  bool operator==(const ViewConditions&) const = default;
};

/// Of protocols without the field "conditions".
const ViewConditions& defaultConditions();

inline constexpr const char* kReferenceMark = "@reference@";
inline constexpr const char* kOtherMark = "@other@";
constexpr const char* markOf(TrialView view) {
  return view == TrialView::kReference ? kReferenceMark : kOtherMark;
}

/// The text with names in place of marks.
std::string withViewNames(std::string_view text, const ViewConditions& conditions);
/// The text with labels in place of marks; with a capital letter where one starts a sentence.
std::string withViewLabels(std::string_view text, const ViewConditions& conditions);

}  // namespace ocelli
