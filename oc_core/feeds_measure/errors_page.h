// The page about an evaluation: errors by kind and walker, when they happened, seams, and pictures. HTML and CSS, no
// script, nothing from the network.
#pragma once

#include <filesystem>
#include <string>

#include "oc_core/feeds_measure/evaluate_feeds.h"

namespace ocelli {

/// `title` says what was evaluated. Names of pictures are relative to the page.
std::string errorsPage(const FeedsEvaluation& evaluation, const std::string& title);
/// Writes `folder`/index.html, where evaluation.pictures are. Throws WorkError where it cannot.
void writeErrorsPage(const FeedsEvaluation& evaluation, const std::string& title, const std::filesystem::path& folder);

}  // namespace ocelli
