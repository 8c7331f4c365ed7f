// What P. Rosen, Improved 3-D Scene Sampling by Camera Model Design (Purdue, 2010), reports in section 7.4.
#pragma once

#include <optional>
#include <string>

#include "analysis/dataset/trial.h"

namespace ocelli {

struct PublishedPair {
  std::optional<double> pinhole{};
  std::optional<double> graph{};

  /// The text compares pinholes, the reference, with graph cameras.
  const std::optional<double>& of(TrialView view) const { return view == TrialView::kReference ? pinhole : graph; }
};

/// Section 7.4.2: mean seconds of searches that ended in time, all subjects.
PublishedPair publishedFindSeconds(bool moving);
/// The text's own "improvement" of these, percent.
double publishedFindImprovement(bool moving);
/// Section 7.4.2: percent of searches whose time ran out. Of stationary objects the text gives "exactly 33 (6.35%)" for
/// either view.
PublishedPair publishedTimeouts(bool moving);
/// Table 7.1: seconds, subjects with three sessions.
PublishedPair publishedTable71(bool moving, int session);
/// The text about Table 7.1: percent by which the graph camera is faster; stationary objects alone.
std::optional<double> publishedImprovement71(bool moving, int session);
/// Figure 7.5 is an image; the text tells that the graph camera was faster by 90.7 % in case 3 of stationary objects.
std::optional<double> publishedImprovement75(bool moving, int caseNumber);
/// Section 7.4.3: percent of counts that are right.
PublishedPair publishedCounts(bool moving);
/// Table 7.2, left: by exposure; stationary objects alone.
PublishedPair publishedTable72(bool moving, double exposureSeconds);
/// Table 7.2, right.
PublishedPair publishedTable72(bool moving, bool duplicateColors);
/// Table 7.3: percent of counts that are right, subjects with three sessions.
PublishedPair publishedTable73(bool moving, int session);
/// Section 7.4.4: percent of paths that are right; session 0: all subjects, else those with three sessions.
PublishedPair publishedPaths(int session);
/// Section 7.4.5: mean answers, 1 for the pinhole to 5 for the graph camera, of a question as the protocol rosen2010
/// names it.
std::optional<double> publishedSurvey(const std::string& field);

}  // namespace ocelli
