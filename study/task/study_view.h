// The two ways of seeing that a study compares (chapter 7): planar pinhole cameras and graph cameras.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace ocelli {

enum class StudyView : uint8_t { kPinhole, kGraph };
inline constexpr std::array<StudyView, 2> kStudyViews{StudyView::kPinhole, StudyView::kGraph};

/// "ppc", "gc": as protocols, databases and exports write it.
constexpr std::string_view nameOf(StudyView view) {
  return view == StudyView::kPinhole ? "ppc" : "gc";
}
constexpr std::optional<StudyView> studyViewFromName(std::string_view name) {
  for (const StudyView view : kStudyViews) {
    if (nameOf(view) == name) {
      return view;
    }
  }
  return std::nullopt;
}
constexpr StudyView otherThan(StudyView view) {
  return view == StudyView::kPinhole ? StudyView::kGraph : StudyView::kPinhole;
}

}  // namespace ocelli
