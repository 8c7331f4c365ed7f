// The figures of an evaluation as CSV (RFC 4180, with single line feeds): the names of the columns in the first line.
#pragma once

#include <string>
#include <vector>

#include "oc_core/evaluation/evaluation.h"

namespace ocelli {

/// One line a representation. A figure that was not measured is empty; the PSNR of equal images is "inf".
std::string evaluationCsv(const EvaluationOptions& options, const std::vector<RepresentationFigures>& figures);

/// One line a representation, edge of a cube and viewpoint on it, corner to corner; corners of three edges come three
/// times. No lines for other cells.
std::string sequencesCsv(const EvaluationOptions& options, const std::vector<RepresentationFigures>& figures);

/// One line a representation and distance.
std::string offsetsCsv(const EvaluationOptions& options, const std::vector<RepresentationFigures>& figures);

}  // namespace ocelli
