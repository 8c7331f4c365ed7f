// The effects of the data-only subject (data_generator.h) as numbers: one for each that the model of a task names
// (study/tasks/generator_model.h).
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "study/protocol/protocol.h"
#include "study/tasks/generator_model.h"

namespace ocelli {

/// Of all tasks, those that are registered later included: the values of their rows, until they are set.
class GeneratorEffects {
 public:
  /// Throws InputError for a task or an effect that is unknown.
  double& at(const std::string& task, const std::string& effect);
  double at(const std::string& task, const std::string& effect) const;
  /// 0 where the model of the task has no such number.
  double valueOr0(const std::string& task, const std::string& effect) const;
  /// Of a task, in the order of its model. Throws InputError.
  std::vector<double> of(const std::string& task) const;
  /// By how much y of a condition, by its name, differs from the reference: what takes the place of "graph" there.
  void setCondition(const std::string& task, const std::string& condition, double effect);
  std::optional<double> ofCondition(const std::string& task, const std::string& condition) const;
  /// Those that were set, by name.
  std::map<std::string, double> ofConditions(const std::string& task) const;

  bool operator==(const GeneratorEffects& other) const;

 private:
  std::map<std::string, std::vector<double>> set_;                     ///< of tasks of which one was set
  std::map<std::string, std::map<std::string, double>> conditions_{};  ///< by task and condition
};

/// The sum of the fixed effects: of a subject and a case without effects of their own.
double fixedPart(const GeneratorEffects& effects, const GeneratedTrial& trial);

/// From a JSON file with an object for each task, such as {"find": {"graph": -0.3}}, or of several conditions
/// {"find": {"conditions": {"graph-low": -0.3, "graph-high": -0.1}}}; what is missing stays as it is by default. Throws
/// InputError.
GeneratorEffects readGeneratorEffects(const std::filesystem::path& file);

/// As JSON text with the same fields, for the record of a simulated subject: of the tasks of the protocol, and of those
/// that are always recorded.
std::string jsonText(const GeneratorEffects& effects, const Protocol& protocol);

}  // namespace ocelli
