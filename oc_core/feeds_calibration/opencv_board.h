// A board as OpenCV has it. For .cpp files of this room.
#pragma once

#include <opencv2/aruco/charuco.hpp>

#include "oc_core/feeds_calibration/calibration_board.h"

namespace ocelli {

/// In millimetres, from the top left corner, y down (OpenCV 4.6). The board must have markers.
cv::Ptr<cv::aruco::CharucoBoard> openCvBoard(const CalibrationBoard& board);

}  // namespace ocelli
