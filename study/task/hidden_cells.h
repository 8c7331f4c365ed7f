// Where something can stand in a maze that nobody sees from the start, in any condition of a study, by how far it is to
// walk there: for searches whose places are drawn and not chosen.
#pragma once

#include <vector>

#include "study/task/eye_camera.h"

namespace ocelli {

struct SightSetting {
  EyeCamera camera;   ///< with the conditions of the study
  WalkerPose start;   ///< where one looks from
  Landmark object{};  ///< what stands there; its cell does not matter
};

/// The cells in which no view shows a pixel of the object, on a screen of 1024 x 640 pixels: nearest first, by the
/// cells that one walks through, then row by row. Without the cell of the start, and those to which no way leads.
std::vector<MazeCell> hiddenCells(const Maze& maze, const SightSetting& setting);

/// Those of band `band` (from 0) of `bands` of equal size, to within one.
std::vector<MazeCell> cellsOfBand(const std::vector<MazeCell>& nearestFirst, int band, int bands);

}  // namespace ocelli
