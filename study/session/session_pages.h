// The pages that a session has of its own, besides those of the protocol.
#pragma once

#include <string>

#include "study/session/records.h"
#include "study/session/session_screen.h"

namespace ocelli {

PageScreen pageOf(const ProtocolPage& page);
PageScreen readyPage(const std::string& trialName, const std::string& blockTitle, const SessionProgress& progress);
PageScreen feedbackPage(const TrialOutcome& outcome);
PageScreen breakPage(const SessionProgress& progress, double waitSeconds);
/// Practice did not succeed. People wait for the experimenter.
PageScreen callPage(SubjectKind kind);
PageScreen unwellPage();
/// The last one: one title, what to know, and that Enter closes it.
PageScreen lastPage(const std::string& title, const std::vector<std::string>& paragraphs);

}  // namespace ocelli
