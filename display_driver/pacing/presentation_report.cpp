#include "display_driver/pacing/presentation_report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"

namespace ocelli {
namespace {

double hertz(const TimeLineSummary& summary) {
  return summary.seconds > 0 ? static_cast<double>(summary.refreshes - 1) / summary.seconds : 0;
}

std::string spreadText(const char* name, const Spread& spread) {
  return spread.count == 0 ? ""
                           : fmt::format("  {}: median {:.1f} ms, 95 % within {:.1f} ms, worst {:.1f} ms\n", name,
                                         spread.median, spread.within95, spread.worst);
}

nlohmann::ordered_json spreadJson(const Spread& spread) {
  if (spread.count == 0) {
    return nullptr;
  }
  return {{"median_ms", spread.median}, {"within_95_percent_ms", spread.within95}, {"worst_ms", spread.worst}};
}

nlohmann::ordered_json predictionJson(const PredictionErrors& errors) {
  if (errors.count == 0) {
    return nullptr;
  }
  return {{"predictions", errors.count},
          {"ahead_ms", 1000 * errors.aheadSeconds},
          {"median_radii", errors.median},
          {"within_95_percent_radii", errors.most},
          {"last_known_median_radii", errors.medianLast},
          {"last_known_within_95_percent_radii", errors.mostLast}};
}

double milliseconds(StageTimes::Duration time) {
  return std::chrono::duration<double, std::milli>(time).count();
}

/// "source_late" for "source late"
std::string fieldName(RefreshOutcome outcome) {
  std::string name = nameOf(outcome);
  for (char& c : name) {
    c = c == ' ' ? '_' : c;
  }
  return name;
}

}  // namespace

void requireFrames(const PresentationReport& report, const std::string& device) {
  if (report.summary.framesShown > 0 || report.telemetry.framesShown > 0) {
    return;
  }
  const bool absent = report.absent || report.summary.count(RefreshOutcome::kNotConnected) > 0;
  const std::string& why = report.telemetry.lastProblem;
  throw WorkError("no frame was ever shown" + (why.empty() ? "" : ": " + why), device,
                  absent ? "see with ocelli device info whether the display is there"
                         : "give it more seconds, or a link that carries more");
}

std::string missText(const RefreshRecord& record, HostTime start) {
  std::string text = fmt::format("refresh {} at {:.3f} s: {}", record.refresh,
                                 std::chrono::duration<double>(record.due - start).count(), nameOf(record.outcome));
  const auto after = [&](const char* what, HostTime time) {
    if (time != HostTime{}) {
      text +=
          fmt::format(", {} {:+.1f} ms", what, std::chrono::duration<double, std::milli>(time - record.due).count());
    }
  };
  after("made", record.makingEnded);
  after("arrived", record.arrived);
  after("shown", record.shown);
  return text + (record.problem.empty() ? "" : ": " + record.problem);
}

std::string statusText(uint64_t refreshes, uint64_t misses) {
  return fmt::format("{} refreshes, {} missed", refreshes, misses);
}

std::string reportText(const PresentationReport& report) {
  const TimeLineSummary& summary = report.summary;
  std::string text =
      fmt::format("{} refreshes in {:.1f} s at {:.2f} Hz on {} ({}): {} shown in time, {} unchanged, {} missed",
                  summary.refreshes, summary.seconds, hertz(summary), report.device.kind, report.profile,
                  summary.count(RefreshOutcome::kShown), summary.count(RefreshOutcome::kUnchanged), summary.misses);
  std::string why;
  for (size_t i = 0; i < kRefreshOutcomes; ++i) {
    const auto outcome = static_cast<RefreshOutcome>(i);
    if (isMiss(outcome) && summary.count(outcome) > 0) {
      why += fmt::format("{}{} {}", why.empty() ? "" : ", ", nameOf(outcome), summary.count(outcome));
    }
  }
  text += (why.empty() ? "" : " (" + why + ")") + "\n";
  text += spreadText("making", summary.making);
  for (const EyesSource::Stage& stage : report.stages) {
    if (!stage.times.empty()) {
      text += fmt::format("    {}: median {:.1f} ms\n", stage.name, milliseconds(stage.times.median()));
    }
  }
  text += spreadText("submitting", summary.submitting);
  text += spreadText("sending", summary.sending);
  text += spreadText("from making to light", summary.latency);
  if (summary.smallerImages > 0) {
    text += fmt::format(
        "  smaller images: {} of {} frames, as time ran short; of the pixels each way {:.0f} % in the median, {:.0f} % "
        "at "
        "least\n",
        summary.smallerImages, summary.framesShown, 100 * summary.medianImageScale, 100 * summary.leastImageScale);
  }
  if (const PredictionErrors& errors = report.prediction; errors.count > 0) {
    text += fmt::format(
        "  eyes foreseen by {:.0f} ms: off by {:.4f} radii in the median, {:.4f} at most in 95 %; the last one known "
        "by "
        "{:.4f} and {:.4f}\n",
        1000 * errors.aheadSeconds, errors.median, errors.most, errors.medianLast, errors.mostLast);
  }
  if (report.starts && report.starts->cold > 1) {
    text += fmt::format("  images started cold: {} of {}, the others from what the last one knew\n",
                        report.starts->cold, report.starts->images);
  }
  if (report.malformedEyes > 0) {
    text += fmt::format("  eyes: {} line{} could not be used; the first: {}\n", report.malformedEyes,
                        report.malformedEyes == 1 ? "" : "s", report.firstMalformedEye);
  }
  if (report.telemetry.framesLost > 0 || report.telemetry.reconnections > 0) {
    text += fmt::format("  the device: {} frames lost, {} reconnections\n", report.telemetry.framesLost,
                        report.telemetry.reconnections);
  }
  if (!report.telemetry.lastProblem.empty()) {
    text += "  the last problem: " + report.telemetry.lastProblem + "\n";
  }
  return text;
}

std::string reportJson(const PresentationReport& report) {
  const TimeLineSummary& summary = report.summary;
  nlohmann::ordered_json outcomes;
  for (size_t i = 0; i < kRefreshOutcomes; ++i) {
    const auto outcome = static_cast<RefreshOutcome>(i);
    outcomes[fieldName(outcome)] = summary.count(outcome);
  }
  nlohmann::ordered_json stages = nlohmann::ordered_json::object();
  for (const EyesSource::Stage& stage : report.stages) {
    if (!stage.times.empty()) {
      stages[stage.name] = milliseconds(stage.times.median());
    }
  }
  const Telemetry& telemetry = report.telemetry;
  const nlohmann::ordered_json json = {
      {"device", report.device.kind},
      {"name", report.device.name},
      {"serial", report.device.serial},
      {"link", report.device.link},
      {"profile", report.profile},
      {"refreshes", summary.refreshes},
      {"seconds", summary.seconds},
      {"hertz", hertz(summary)},
      {"misses", summary.misses},
      {"outcomes", outcomes},
      {"frames_shown", summary.framesShown},
      {"cold_starts", report.starts ? nlohmann::ordered_json(report.starts->cold) : nlohmann::ordered_json()},
      {"smaller_images", summary.smallerImages},
      {"smallest_image_scale", summary.leastImageScale},
      {"median_image_scale", summary.medianImageScale},
      {"making", spreadJson(summary.making)},
      {"making_stages_ms", stages},
      {"submitting", spreadJson(summary.submitting)},
      {"sending", spreadJson(summary.sending)},
      {"latency", spreadJson(summary.latency)},
      {"foreseen_eyes", predictionJson(report.prediction)},
      {"eyes_left_out", report.eyesLeftOut},
      {"malformed_eyes", report.malformedEyes},
      {"first_malformed_eye", report.firstMalformedEye},
      {"frames_submitted", telemetry.framesSubmitted},
      {"frames_arrived", telemetry.framesArrived},
      {"frames_dropped", telemetry.framesDropped},
      {"frames_lost", telemetry.framesLost},
      {"underruns", telemetry.underruns},
      {"reconnections", telemetry.reconnections},
      {"bytes_sent", telemetry.bytesSent}};
  return textOfJson(json, 2) + "\n";
}

std::string reportText(const DeviceLogPlayed& played) {
  return fmt::format("{} frames submitted and {} presented in {:.1f} s: {} shown, {} dropped, {} lost\n",
                     played.submitted, played.presented, played.seconds, played.shown, played.dropped, played.lost);
}

std::string reportJson(const DeviceLogPlayed& played) {
  const nlohmann::ordered_json json = {{"frames_submitted", played.submitted},
                                       {"frames_presented", played.presented},
                                       {"frames_shown", played.shown},
                                       {"frames_dropped", played.dropped},
                                       {"frames_lost", played.lost},
                                       {"seconds", played.seconds},
                                       {"whole", played.ending == RecordingEnding::kFinished}};
  return textOfJson(json, 2) + "\n";
}

}  // namespace ocelli
