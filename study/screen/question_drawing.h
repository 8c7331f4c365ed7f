// What is seen of one item of a form: options, a track with its mark, a box for what is typed (QuestionLook).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/outline/question_kinds.h"
#include "study/screen/study_canvas.h"

namespace ocelli {

/// Where the pieces of an item stand, from the top left of its answer.
class QuestionPlaces {
 public:
  /// In a column of this width. `inColumns` gives all options the width of the widest, so that those of several items
  /// stand below each other.
  QuestionPlaces(const StudyCanvas& canvas, const QuestionLook& look, double width, bool inColumns);

  double height() const { return height_; }
  /// Draws them at a place of the canvas. What the mouse does there, if anything. `name` tells items apart.
  std::optional<QuestionClick> draw(StudyCanvas& canvas, const QuestionLook& look, const std::string& name,
                                    const glm::dvec2& at) const;

 private:
  bool placeOnScale(const StudyCanvas& canvas, const QuestionLook& look, double width);
  void placeInRows(const StudyCanvas& canvas, const QuestionLook& look, double width, bool inColumns);
  void placeTrack(const StudyCanvas& canvas, const QuestionLook& look, double width);
  void placeBox(const StudyCanvas& canvas, const QuestionLook& look, double width);
  void drawEnds(StudyCanvas& canvas, const QuestionLook& look, const glm::dvec2& at) const;

  double width_;
  double height_ = 0;
  bool isScale_ = false;  ///< the ends stand beside the options
  std::vector<PixelRect> options_{};
  std::optional<double> endsTop_{};  ///< of ends that stand on a line of their own
  PixelRect track_{0, 0, 0, 0};      ///< what the mouse can touch of it
  PixelRect box_{0, 0, 0, 0};
};

/// How wide options are side by side on one line.
double optionsWidth(const StudyCanvas& canvas, const QuestionLook& look);

}  // namespace ocelli
