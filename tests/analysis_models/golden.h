// Data sets and what R's lme4 and lmerTest say of them: golden.json, written by golden.R.
#pragma once

#include <Eigen/Core>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace ocelli {

class GoldenData {
 public:
  explicit GoldenData(const std::string& name);

  std::vector<std::string> labels(const std::string& column) const;
  std::vector<double> numbers(const std::string& column) const;
  Eigen::VectorXd vector(const std::string& column) const;
  /// What R says of one model of the data.
  const nlohmann::json& model(const std::string& name) const { return json_.at(name); }

 private:
  nlohmann::json json_;
};

/// A number or an array of them, which R writes alike where there is one.
std::vector<double> numbersOf(const nlohmann::json& json);

}  // namespace ocelli
