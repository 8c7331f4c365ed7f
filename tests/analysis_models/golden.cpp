#include "tests/analysis_models/golden.h"

#include <fstream>

namespace ocelli {

GoldenData::GoldenData(const std::string& name) {
  std::ifstream file(OCELLI_GOLDEN_MODELS);
  json_ = nlohmann::json::parse(file).at(name);
}

std::vector<std::string> GoldenData::labels(const std::string& column) const {
  return json_.at("data").at(column).get<std::vector<std::string>>();
}

std::vector<double> GoldenData::numbers(const std::string& column) const {
  return json_.at("data").at(column).get<std::vector<double>>();
}

Eigen::VectorXd GoldenData::vector(const std::string& column) const {
  const std::vector<double> values = numbers(column);
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

std::vector<double> numbersOf(const nlohmann::json& json) {
  if (json.is_number()) {
    return {json.get<double>()};
  }
  std::vector<double> numbers;
  for (const nlohmann::json& each : json) {
    for (const double number : numbersOf(each)) {
      numbers.push_back(number);
    }
  }
  return numbers;
}

}  // namespace ocelli
