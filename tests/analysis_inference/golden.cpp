#include "tests/analysis_inference/golden.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>

namespace ocelli::test {
namespace {

std::map<std::string, std::vector<double>> readGolden() {
  std::ifstream file(GOLDEN_FILE);
  std::map<std::string, std::vector<double>> all;
  const nlohmann::json json = nlohmann::json::parse(file);
  for (const auto& [name, numbers] : json.items()) {
    for (const nlohmann::json& number : numbers) {
      all[name].push_back(number.is_null() ? std::numeric_limits<double>::quiet_NaN() : number.get<double>());
    }
  }
  return all;
}

}  // namespace

const std::vector<double>& golden(const std::string& name) {
  static const std::map<std::string, std::vector<double>> all = readGolden();
  return all.at(name);
}

std::vector<int> goldenLabels(const std::string& name) {
  std::vector<int> labels;
  for (const double number : golden(name)) {
    labels.push_back(static_cast<int>(number));
  }
  return labels;
}

std::vector<SurvivalTime> goldenTimes(const std::string& set) {
  const std::vector<double>& seconds = golden(set + "/time");
  const std::vector<double>& events = golden(set + (set == "veteran" ? "/status" : "/event"));
  std::vector<SurvivalTime> times;
  for (size_t i = 0; i < seconds.size(); ++i) {
    times.push_back({seconds[i], events[i] == 1});
  }
  return times;
}

std::vector<int> goldenClusters(const std::string& set) {
  return goldenLabels(set + (set == "lung" ? "/inst" : "/subject"));
}

SurvivalData goldenData(const std::string& set, const std::vector<std::string>& covariates) {
  SurvivalData data;
  data.times = goldenTimes(set);
  for (const std::string& name : covariates) {
    data.covariates.push_back({name, golden(set + "/" + name)});
  }
  return data;
}

void expectGolden(const std::vector<double>& actual, const std::string& name, double tolerance) {
  const std::vector<double>& expected = golden(name);
  ASSERT_EQ(actual.size(), expected.size()) << name;
  for (size_t i = 0; i < actual.size(); ++i) {
    if (std::isnan(expected[i])) {
      EXPECT_FALSE(std::isfinite(actual[i])) << name << " " << i;
    } else {
      EXPECT_NEAR(actual[i], expected[i], tolerance * std::max(1.0, std::abs(expected[i]))) << name << " " << i;
    }
  }
}

}  // namespace ocelli::test
