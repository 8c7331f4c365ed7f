// The outline of a subject as a feed has seen it lately: how often each point of its body was filled. It is sharper
// than that of anybody (body_view.h), and tells whose cells are whose where bodies overlap in the image.
#pragma once

#include <array>
#include <cstddef>

namespace ocelli {

class SubjectShape {
 public:
  /// A cell at a height (a share of the body's) and beside its axis (metres) showed the body, or background. `side` is
  /// that of the cell, metres at the body.
  void add(float height, float beside, bool isFilled, float side);
  void add(const SubjectShape& other);
  /// What was seen until so many seconds ago counts for less.
  void forget(double seconds);
  /// How likely a point is filled, where `usual` is how likely anybody fills it.
  float shareAt(float height, float beside, float usual) const;

 private:
  static constexpr int kRows = 28;
  static constexpr int kColumns = 30;
  struct Point {
    float filled = 0;
    float all = 0;  ///< frames that saw all of it
  };

  static size_t indexOf(float height, float beside);

  std::array<Point, static_cast<size_t>(kRows) * kColumns> points_{};
};

}  // namespace ocelli
