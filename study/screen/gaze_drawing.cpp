#include "study/screen/gaze_drawing.h"

#include <array>

#include "study/replay/gaze_trail.h"

namespace ocelli {
namespace {

constexpr GuiColor kEdge{0, 0, 0};
constexpr GuiColor kCore{255, 255, 255};

}  // namespace

void drawGazeMarks(StudyCanvas& canvas, std::span<const GazeMark> marks) {
  if (marks.empty()) {
    return;
  }
  const MirrorScope plain(canvas, false);  // places are those of the screen
  const double unit = gazeUnit(canvas.width());
  for (const auto& [color, thickness] : std::array{std::pair{kEdge, 3.0}, std::pair{kCore, 1.0}}) {
    for (size_t i = 1; i < marks.size(); ++i) {
      if (marks[i].joined) {
        const std::array points{marks[i - 1].place, marks[i].place};
        canvas.line(points, color, unit * (thickness + 2 * (1 - marks[i].age)));
      }
    }
    canvas.ring(marks.back().place, unit * kGazeRadius, color, unit * (thickness + 2));
  }
}

}  // namespace ocelli
