#include "study/trial/trial_words.h"

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

const char* nameOf(TimingVerdict verdict) {
  switch (verdict) {
    case TimingVerdict::kGood:
      return "good";
    case TimingVerdict::kDroppedFrames:
      return "dropped_frames";
    case TimingVerdict::kEarlyFrames:
      return "early_frames";
    case TimingVerdict::kUnstableRefresh:
      return "unstable_refresh";
    case TimingVerdict::kSimulatedClock:
      return "simulated_clock";
  }
  return "";
}

const char* nameOf(ExposureRule rule) {
  switch (rule) {
    case ExposureRule::kClock:
      return "clock";
    case ExposureRule::kFrames:
      return "frames";
  }
  return "";
}

}  // namespace ocelli
