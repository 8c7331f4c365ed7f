// The two view conditions that a study compares. The protocol names them in its field "conditions"; the first is the
// reference, and effects are those of the other against it. A protocol without that field compares planar pinhole
// cameras with graph cameras (defaultConditions()). What a condition shows is said by study/task/scene_view.h.
//
// Texts are written before the names are put in: they hold the marks kReferenceMark and kOtherMark, which become the
// labels where people read, and the names in cells, files and commands.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ocelli {

/// The condition of a trial.
enum class TrialView : uint8_t { kReference, kOther };
inline constexpr std::array kViews = {TrialView::kReference, TrialView::kOther};
constexpr TrialView otherThan(TrialView view) {
  return view == TrialView::kReference ? TrialView::kOther : TrialView::kReference;
}

struct ViewCondition {
  std::string name;                        ///< as databases, tables, plans and cells of reports have it: "gc"
  std::string label;                       ///< for readers, without an article: "graph camera"
  std::string description{};               ///< at its first mention; empty: the label
  std::vector<std::string> wordsOfEnds{};  ///< that stand for it in the ends of scales, in small letters

  bool operator==(const ViewCondition&) const = default;
};

struct ViewConditions {
  std::array<ViewCondition, 2> list;  ///< the reference, the other

  const ViewCondition& of(TrialView view) const { return list[static_cast<size_t>(view)]; }
  const std::string& nameOf(TrialView view) const { return of(view).name; }
  const std::string& labelOf(TrialView view) const { return of(view).label; }
  /// Nothing where no condition has the name.
  std::optional<TrialView> viewNamed(std::string_view name) const;
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
