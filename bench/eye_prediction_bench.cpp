// How far predicted eyes are off (display_driver/pacing/eye_predictor.h), for times ahead: over files of recorded heads
// where they are given, else over ways that are made up (head_paths.h), which is no evidence about people.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bench/bench_program.h"
#include "bench/head_paths.h"
#include "display_driver/pacing/eye_predictor.h"
#include "oc_core/base/json_fields.h"

namespace ocelli {
namespace {

struct Choice {
  std::vector<std::string> files;
  double rate = 60;
  double noise = 0.008;
  int threads = 1;
  std::vector<double> ahead{20, 40, 60, 80, 120};
  bool json = false;
};

struct Errors {
  double median = 0;
  double most = 0;  ///< that 95 % do not exceed
};

struct Path {
  std::vector<EyePose> told;   ///< by the tracker
  std::vector<EyePose> truth;  ///< the same times, or more
};

HostTime timeOf(double seconds) {
  return HostTime(std::chrono::duration_cast<HostTime::duration>(std::chrono::duration<double>(1000 + seconds)));
}

Errors errorsOf(const std::vector<Path>& paths, EyePrediction how, double aheadSeconds) {
  std::vector<double> off;
  for (const Path& path : paths) {
    EyePredictor predictor(how);
    for (const EyePose& pose : path.told) {
      predictor.add(timeOf(pose.seconds), pose.eye);
      const double seen = pose.seconds + aheadSeconds;
      // The first half second is for the filters to begin.
      if (pose.seconds > path.told.front().seconds + 0.5 && seen <= path.truth.back().seconds) {
        off.push_back(static_cast<double>(glm::distance(*predictor.at(timeOf(seen)), eyeAt(path.truth, seen))));
      }
    }
  }
  std::sort(off.begin(), off.end());
  return off.empty() ? Errors{} : Errors{off[off.size() / 2], off[off.size() * 95 / 100]};
}

std::vector<Path> pathsOf(const Choice& choice) {
  std::vector<Path> paths;
  for (const std::string& file : choice.files) {
    const std::vector<EyePose> poses = readEyePath(file);
    paths.push_back({poses, poses});
  }
  if (paths.empty()) {
    for (uint64_t seed = 11; seed <= 20; ++seed) {
      std::vector<EyePose> truth = madeUpHeadPath(seed, 10, choice.rate);
      paths.push_back({withTrackerNoise(truth, seed + 100, choice.noise), truth});
    }
  }
  return paths;
}

void measure(const Choice& choice) {
  const std::vector<Path> paths = pathsOf(choice);
  const std::vector<std::string> names = eyePredictionNames();
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const double ahead : choice.ahead) {
    for (size_t i = 0; i < names.size(); ++i) {
      const Errors errors = errorsOf(paths, static_cast<EyePrediction>(i), ahead / 1000);
      rows.push_back({{"ahead_ms", ahead},
                      {"prediction", names[i]},
                      {"median_radii", errors.median},
                      {"within_95_percent_radii", errors.most}});
    }
  }
  if (choice.json) {
    fmt::print("{}\n",
               textOfJson({{"paths", choice.files.empty() ? "10, made up" : fmt::format("{}, recorded", paths.size())},
                           {"rows", rows}},
                          2));
    return;
  }
  fmt::print("{} paths{}; display radii\nahead   prediction   median   95 % within\n", paths.size(),
             choice.files.empty() ? ", made up: no evidence about people" : "");
  for (const auto& row : rows) {
    fmt::print("{:3.0f} ms  {:10}  {:7.4f}   {:7.4f}\n", row["ahead_ms"].get<double>(),
               row["prediction"].get<std::string>(), row["median_radii"].get<double>(),
               row["within_95_percent_radii"].get<double>());
  }
}

}  // namespace
}  // namespace ocelli

int main(int argumentCount, char** arguments) {
  ocelli::Choice choice;
  CLI::App program("How far predicted eyes are off", "eye_prediction_bench");
  program.add_option("FILE", choice.files, "Recorded heads: .csv or .json, as `ocelli present --eyes` takes them");
  program.add_option("--rate", choice.rate, "Poses a second of made-up ways")->capture_default_str();
  program.add_option("--noise", choice.noise, "What their tracker is off by, display radii")->capture_default_str();
  program.add_option("--ahead", choice.ahead, "Milliseconds")->delimiter(',')->capture_default_str();
  program.add_flag("--json", choice.json, "Print the figures as JSON");
  return ocelli::runProgram(program, argumentCount, arguments, choice, ocelli::measure);
}
