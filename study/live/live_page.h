// The experimenter's page: HTML that asks for the status each second and shows it. Nothing in it comes from elsewhere.
#pragma once

#include <string>

namespace ocelli {

/// The page; it asks for "live.js", and that for "status.json".
std::string livePage();
std::string liveScript();

}  // namespace ocelli
