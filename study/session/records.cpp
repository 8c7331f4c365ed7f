#include "study/session/records.h"

namespace ocelli {

const char* nameOf(SubjectKind kind) {
  switch (kind) {
    case SubjectKind::kPerson:
      return "person";
    case SubjectKind::kGenerator:
      return "simulated_generator";
    case SubjectKind::kObserver:
      return "simulated_observer";
  }
  return "";
}

std::optional<SubjectKind> subjectKindFromName(std::string_view name) {
  for (const SubjectKind kind : {SubjectKind::kPerson, SubjectKind::kGenerator, SubjectKind::kObserver}) {
    if (nameOf(kind) == name) {
      return kind;
    }
  }
  return std::nullopt;
}

const char* nameOf(TrialEnding ending) {
  switch (ending) {
    case TrialEnding::kCompleted:
      return "completed";
    case TrialEnding::kRedone:
      return "redone";
    case TrialEnding::kAborted:
      return "aborted";
  }
  return "";
}

const char* nameOf(SessionEnding ending) {
  switch (ending) {
    case SessionEnding::kCompleted:
      return "completed";
    case SessionEnding::kUnwell:
      return "unwell";
    case SessionEnding::kAborted:
      return "aborted";
    case SessionEnding::kDeclined:
      return "declined";
    case SessionEnding::kFailed:
      return "failed";
  }
  return "";
}

}  // namespace ocelli
