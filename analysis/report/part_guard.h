// The second line of defence of a report: nothing that a data set holds may end it. What data cannot give is Estimable
// and says so by itself; should a part throw nevertheless, a note takes its place and everything else stands.
#pragma once

#include <functional>
#include <string>

#include "analysis/report/report_parts.h"

namespace ocelli {

/// Runs one part of the report: a section, a model, a table. What it throws becomes a note after what it has added so
/// far, and one of ReportDocument::failures.
void addPart(ReportWork& work, const std::string& what, const std::function<void()>& add);

/// Notes one of ReportDocument::failures, and returns the reason to show in its place.
std::string addFailure(ReportWork& work, const std::string& what, const std::string& failure);

/// The figure that `draw` makes; a note in its place where it throws or draws what is not finite.
void addFigure(ReportWork& work, const std::string& caption, const std::string& id,
               const std::function<Figure()>& draw);

}  // namespace ocelli
