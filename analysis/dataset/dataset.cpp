#include "analysis/dataset/dataset.h"

#include <algorithm>

#include "analysis/dataset/row_digest.h"

namespace ocelli {

const char* describe(OtherAttempt::Why why) {
  switch (why) {
    case OtherAttempt::Why::kPractice:
      return "practice";
    case OtherAttempt::Why::kRedone:
      return "redone by the experimenter";
    case OtherAttempt::Why::kAborted:
      return "aborted";
    case OtherAttempt::Why::kNotEnded:
      return "not ended: it runs, or the program was killed";
    case OtherAttempt::Why::kRepeated:
      return "a later attempt was completed";
  }
  return "";
}

OtherAttempt::Why whyNotCounted(bool practice, std::optional<TrialEnding> ending) {
  using Why = OtherAttempt::Why;
  if (practice) {
    return Why::kPractice;
  }
  return !ending                           ? Why::kNotEnded
         : ending == TrialEnding::kRedone  ? Why::kRedone
         : ending == TrialEnding::kAborted ? Why::kAborted
                                           : Why::kRepeated;
}

bool Dataset::isSimulated() const {
  return std::any_of(subjects.begin(), subjects.end(), [](const Subject& subject) { return subject.simulated; });
}

bool Dataset::subjectsAreKnown() const {
  return std::all_of(sources.begin(), sources.end(), [](const DataSource& source) { return source.subjectsAreKnown; });
}

const Subject* Dataset::findSubject(const std::string& id) const {
  const auto found = std::find_if(subjects.begin(), subjects.end(), [&](const Subject& s) { return s.id == id; });
  return found == subjects.end() ? nullptr : &*found;
}

std::string dataHash(const Dataset& data) {
  std::vector<Digest> rows;
  rows.reserve(data.trials.size() + data.answers.size() + data.sessions.size() + data.subjects.size());
  for (const Trial& trial : data.trials) {
    rows.push_back(trial.digest);
  }
  for (const FormAnswer& answer : data.answers) {
    rows.push_back(RowBytes("answer")
                       .text(answer.subject)
                       .integer(answer.session)
                       .text(answer.form)
                       .text(answer.field)
                       .text(answer.answer)
                       .integer(answer.simulated ? 1 : 0)
                       .digest());
  }
  for (const Session& session : data.sessions) {
    rows.push_back(RowBytes("session")
                       .text(session.subject)
                       .integer(session.number)
                       .text(session.ending ? nameOf(*session.ending) : "")
                       .integer(session.completedTrials)
                       .integer(session.runs)
                       .integer(session.forced ? 1 : 0)
                       .digest());
  }
  for (const Subject& subject : data.subjects) {
    rows.push_back(RowBytes("subject")
                       .text(subject.id)
                       .text(nameOf(subject.kind))
                       .integer(subject.slot)
                       .text(subject.createdUtc)
                       .digest());
  }
  return hexadecimal(sha256OfRows(std::move(rows)));
}

}  // namespace ocelli
