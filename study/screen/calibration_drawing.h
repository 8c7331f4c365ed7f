// The screens of the calibration (calibration.h), and the loop that shows them before a session.
#pragma once

#include <functional>

#include "oc_core/window/gl_window.h"
#include "study/screen/calibration.h"
#include "study/screen/study_canvas.h"

namespace ocelli {

/// Draws the step that the calibration is at, `seconds` as in CalibrationSteps; a click on a button acts on it.
void drawCalibration(StudyCanvas& canvas, CalibrationSteps& steps, double seconds);

/// Until all is measured. On the main thread, which must not hold the window's context. Throws WorkError where Escape
/// or F10 is pressed, the window is closed, or `interrupted` says so.
ScreenCalibration runCalibration(GlWindow& window, const CalibrationWishes& wishes, const CalibratedScreen& screen,
                                 const SubjectTexts& texts, const std::function<bool()>& interrupted);

}  // namespace ocelli
