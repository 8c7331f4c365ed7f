// The page of a comparison of ways to show foci: pictures side by side, their sampling rates, and figures.
#pragma once

#include <string>

#include "oc_core/focus/focus_comparison.h"

namespace ocelli {

struct FocusPage {
  std::string scene;    ///< as the user named it
  std::string camera;   ///< the same
  std::string version;  ///< of the program
  int runs = 1;
};

/// File names of the images of a way, beside the page.
struct FocusImages {
  std::string picture;
  std::string rates;
  std::string kept;
};
FocusImages focusImageNames(const FocusWay& way);

/// HTML without scripts, and without anything from the network.
std::string focusPage(const FocusPage& page, const FocusComparison& comparison, const GpcLayout& layout);

/// The figures as a table of text; "-" where there is none.
std::string focusTable(const FocusComparison& comparison);

}  // namespace ocelli
