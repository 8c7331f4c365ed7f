// The pages that a session has of its own, besides those of the protocol, in its language.
#pragma once

#include <string>

#include "study/session/records.h"
#include "study/session/session_screen.h"

namespace ocelli {

PageScreen pageOf(const SubjectTexts& texts, const ProtocolPage& page);
PageScreen readyPage(const SubjectTexts& texts, const std::string& trialName, const std::string& blockTitle,
                     const SessionProgress& progress);
PageScreen feedbackPage(const SubjectTexts& texts, const TrialOutcome& outcome);
PageScreen breakPage(const SubjectTexts& texts, const SessionProgress& progress, double waitSeconds);
/// Practice did not succeed. People wait for the experimenter.
PageScreen callPage(const SubjectTexts& texts, SubjectKind kind);
PageScreen unwellPage(const SubjectTexts& texts);
/// The last one: one title, what to know, and that Enter closes it.
PageScreen lastPage(const SubjectTexts& texts, const std::string& title, const std::vector<std::string>& paragraphs);

}  // namespace ocelli
