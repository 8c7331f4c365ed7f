// Words that charts share: for the descriptions of those who do not see them, and for what cannot be drawn.
#pragma once

#include <string>
#include <vector>

#include "analysis/plot/panel.h"
#include "oc_core/drawing/figure.h"

namespace ocelli {

/// "13.2 (11.9 to 14.8)", as far as it is known; "not known" where nothing is.
std::string intervalText(const Interval& interval, bool percent = false);

/// "a, b and c".
std::string listText(const std::vector<std::string>& items);

/// A figure of the given size that says only that there is nothing to show, and why.
Figure emptyFigure(const std::string& title, double widthMillimetres, const std::string& reason);

/// Whether it can be drawn on that scale.
bool isDrawable(double value, AxisScale scale);

}  // namespace ocelli
