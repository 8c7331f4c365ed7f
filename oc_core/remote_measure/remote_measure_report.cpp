#include "oc_core/remote_measure/remote_measure_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "oc_core/base/csv.h"
#include "oc_core/base/json_document.h"
#include "oc_core/camera/view.h"

namespace ocelli {
namespace {

using Json = nlohmann::ordered_json;

std::string sizeText(double bytes) {
  return bytes >= 1e5 ? fmt::format("{:.2f} MB", bytes / 1e6) : fmt::format("{:.1f} KB", bytes / 1e3);
}

/// A number of an error, "-" where none is known.
std::string errorText(const PictureErrors& errors, double value, int digits) {
  return errors.flips.empty() ? "-" : fmt::format("{:.{}f}", value, digits);
}

std::string firstText(const ModeFigures& row) {
  return row.firstPictureSeconds ? fmt::format("{:.2f}", *row.firstPictureSeconds) : "-";
}

std::string stallText(const StallFigures& stalls) {
  return stalls.count == 0 ? "none" : fmt::format("{:.2f} s, {}x", stalls.longestSeconds, stalls.count);
}

Json numberOrNull(double value, bool known = true) {
  return known && std::isfinite(value) ? Json(value) : Json();
}

Json errorsJson(const PictureErrors& errors) {
  if (errors.flips.empty()) {
    return {};
  }
  return {{"flip_mean", errors.meanFlip()},
          {"flip_95", errors.flip95()},
          {"psnr_db", numberOrNull(errors.psnrDecibels())},
          {"frames", errors.flips.size()}};
}

Json stallsJson(const StallFigures& stalls) {
  return {{"longest_seconds", stalls.longestSeconds}, {"count", stalls.count}, {"total_seconds", stalls.totalSeconds}};
}

/// The rows of the general pinhole, which others are compared with.
bool isOurs(const ModeFigures& row) {
  return row.mode == "gpc";
}

std::string equalTable(const RemoteMeasurement& measurement) {
  std::string text;
  for (const ModeFigures& row : measurement.rows) {
    if (!isOurs(row) || row.shown.flips.empty()) {
      continue;
    }
    for (const StreamCurve& curve : measurement.curves) {
      const std::optional<double> bytes = bytesOfEqualStream(measurement, curve.mode, row);
      text += fmt::format(
          "{:<17} gpc {:>9} at FLIP {:.4f}; {} of that error, without latency: {}\n", row.link.name(),
          sizeText(static_cast<double>(row.bytes)), row.pictureFlip(), curve.mode,
          bytes ? fmt::format("{} ({:.3f} of it)", sizeText(*bytes), static_cast<double>(row.bytes) / *bytes)
                : "beyond its curve");
    }
  }
  return text.empty() ? text : "\nbytes at equal error over the path, since the first picture of gpc\n" + text;
}

}  // namespace

std::string remoteMeasureTable(const RemoteMeasureOptions& options, const RemoteMeasurement& measurement) {
  std::string text = fmt::format("{} frames of {}x{} at {:g} a second, path \"{}\"; one of {} is judged\n\n",
                                 options.path.views.size(), options.screen.x, options.screen.y,
                                 options.path.framesPerSecond, options.path.name, options.every);
  text +=
      fmt::format("{:<18} {:<18} {:>9} {:>6} {:>7} {:>7} {:>7} {:>8} {:>8} {:>8} {:>7} {:>8} {:>6}  {:<13} {:<13}\n",
                  "mode", "link", "bytes", "images", "first s", "views/s", "lag ms", "FLIP", "FLIP 95", "no delay",
                  "PSNR dB", "covered", "dec ms", "stalls", "while covered");
  for (const ModeFigures& row : measurement.rows) {
    text += fmt::format(
        "{:<18} {:<18} {:>9} {:>6} {:>7} {:>7.1f} {:>7.0f} {:>8} {:>8} {:>8} {:>7} {:>7.1f}% {:>6}  {:<13} {:<13}\n",
        row.name(), row.link.name(), sizeText(static_cast<double>(row.bytes)), row.images, firstText(row),
        row.viewsPerSecond, 1e3 * row.meanLagSeconds, errorText(row.shown, row.shown.meanFlip(), 4),
        errorText(row.shown, row.shown.flip95(), 4), errorText(row.withoutLatency, row.withoutLatency.meanFlip(), 4),
        errorText(row.shown, row.shown.psnrDecibels(), 2), 100 * row.covered,
        row.clientDecodeSeconds > 0 ? fmt::format("{:.0f}", 1e3 * row.clientDecodeSeconds) : "-", stallText(row.stalls),
        stallText(row.coveredStalls));
  }
  text += equalTable(measurement);
  for (const ModeFigures& row : measurement.rows) {
    if (isOurs(row) && row.clientFrameSeconds > 0) {
      text += fmt::format("\nthe client draws a picture in {:.1f} ms: {:.0f} a second\n", row.clientFrameSeconds * 1e3,
                          1 / row.clientFrameSeconds);
      break;
    }
  }
  for (const std::string& why : measurement.leftOut) {
    text += "left out: " + why + "\n";
  }
  return text;
}

std::string remoteMeasureCsv(const RemoteMeasurement& measurement) {
  std::string text =
      "mode,variant,bytes_per_second,round_trip_seconds,bytes,images,first_picture_seconds,views_per_second,"
      "mean_lag_seconds,client_frame_seconds,client_decode_seconds,flip_mean,flip_95,psnr_db,flip_mean_without_latency,"
      "covered,stall_longest_seconds,"
      "stalls,stall_total_seconds,covered_stall_longest_seconds,covered_stalls\n";
  for (const ModeFigures& row : measurement.rows) {
    const auto number = [](double value, bool known = true) {
      return known && std::isfinite(value) ? fmt::format("{}", value) : std::string();
    };
    const bool isJudged = !row.shown.flips.empty();
    text += fmt::format(
        "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", csvText(row.mode), csvText(row.variant),
        row.link.bytesPerSecond, row.link.roundTripSeconds, row.bytes, row.images,
        number(row.firstPictureSeconds.value_or(0), row.firstPictureSeconds.has_value()), row.viewsPerSecond,
        row.meanLagSeconds, number(row.clientFrameSeconds, row.clientFrameSeconds > 0),
        number(row.clientDecodeSeconds, row.clientDecodeSeconds > 0), number(row.shown.meanFlip(), isJudged),
        number(row.shown.flip95(), isJudged), number(row.shown.psnrDecibels(), isJudged),
        number(row.withoutLatency.meanFlip(), !row.withoutLatency.flips.empty()), row.covered,
        row.stalls.longestSeconds, row.stalls.count, row.stalls.totalSeconds, row.coveredStalls.longestSeconds,
        row.coveredStalls.count);
  }
  return text;
}

std::string remoteMeasureJson(const RemoteMeasureOptions& options, const RemoteMeasurement& measurement) {
  Json json;
  json["scene"] = options.scene;
  json["path"] = {{"name", options.path.name},
                  {"frames", options.path.views.size()},
                  {"frames_per_second", options.path.framesPerSecond},
                  {"first_view", Json::parse(jsonText(options.path.views.front()))}};
  json["size"] = {options.screen.x, options.screen.y};
  json["settings"] = Json::parse(jsonText(options.settings));
  json["judged_every"] = options.every;
  json["truth_samples"] = options.truthSamples;
  json["server_seconds"] = options.serverSeconds ? Json(*options.serverSeconds) : Json();
  json["client_seconds"] = options.clientSeconds ? Json(*options.clientSeconds) : Json();
  json["decode_seconds"] = options.decodeSeconds ? Json(*options.decodeSeconds) : Json();
  json["peer_seconds"] = options.peerSeconds;
  json["stream_rate_factor"] = options.streamFactor;
  json["plain_size"] = numberOrNull(measurement.equalSize, measurement.equalSize > 0);
  json["modes"] = Json::array();
  for (const ModeFigures& row : measurement.rows) {
    Json each{
        {"mode", row.mode},
        {"variant", row.variant},
        {"link", {{"bytes_per_second", row.link.bytesPerSecond}, {"round_trip_seconds", row.link.roundTripSeconds}}},
        {"bytes", row.bytes},
        {"images", row.images},
        {"first_picture_seconds",
         numberOrNull(row.firstPictureSeconds.value_or(0), row.firstPictureSeconds.has_value())},
        {"views_per_second", row.viewsPerSecond},
        {"mean_lag_seconds", row.meanLagSeconds},
        {"client_decode_seconds", numberOrNull(row.clientDecodeSeconds, row.clientDecodeSeconds > 0)},
        {"client_frame_seconds", numberOrNull(row.clientFrameSeconds, row.clientFrameSeconds > 0)},
        {"covered", row.covered},
        {"stalls", stallsJson(row.stalls)},
        {"stalls_while_covered", stallsJson(row.coveredStalls)},
        {"errors", errorsJson(row.shown)},
        {"judged_before_the_first_picture", row.blackFrames},
        {"flip_mean_since_the_first_picture",
         numberOrNull(row.pictureFlip(), row.shown.flips.size() > row.blackFrames)},
        {"errors_without_latency", errorsJson(row.withoutLatency)}};
    if (isOurs(row)) {
      Json equal = Json::object();
      for (const StreamCurve& curve : measurement.curves) {
        const std::optional<double> bytes = bytesOfEqualStream(measurement, curve.mode, row);
        equal[curve.mode] = numberOrNull(bytes.value_or(0), bytes.has_value());
      }
      each["bytes_of_equal_streams"] = equal;
    }
    each["flip_of_frames"] = Json::array();
    for (size_t i = 0; i < row.judged.size(); ++i) {
      each["flip_of_frames"].push_back({row.judged[i], row.shown.flips[i]});
    }
    json["modes"].push_back(each);
  }
  json["stream_curves"] = Json::array();
  for (const StreamCurve& curve : measurement.curves) {
    Json points = Json::array();
    for (const RatePoint& point : curve.points) {
      points.push_back({{"rate_factor", point.rateFactor}, {"bytes", point.bytes}, {"flip_mean", point.flip}});
    }
    json["stream_curves"].push_back({{"mode", curve.mode}, {"points", points}});
  }
  json["left_out"] = measurement.leftOut;
  return textOfJson(json, 2) + "\n";
}

}  // namespace ocelli
