#include "study/subject/generator_effects.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/json_fields.h"
#include "study/tasks/task_registry.h"

namespace ocelli {
namespace {

constexpr double kLargestEffect = 20;  // more makes every answer the same
constexpr const char* kWhereEffects = "effects of the generator";

size_t indexOf(const TaskKind& kind, const std::string& effect) {
  if (const std::optional<size_t> index = kind.generator.indexOf(effect)) {
    return *index;
  }
  std::string names;
  for (const GeneratorEffect& each : kind.generator.effects) {
    names += fmt::format("{}{}", names.empty() ? "" : ", ", each.name);
  }
  throw InputError(fmt::format("the task {} has no effect \"{}\"", kind.name, effect), kWhereEffects,
                   fmt::format("its effects are {}", names));
}

std::vector<double> valuesOfRow(const TaskKind& kind) {
  std::vector<double> values;
  for (const GeneratorEffect& effect : kind.generator.effects) {
    values.push_back(effect.value);
  }
  return values;
}

bool isDeviation(const GeneratorEffect& effect) {
  return effect.covariate == nullptr;
}

}  // namespace

std::vector<double> GeneratorEffects::of(const std::string& task) const {
  const TaskKind& kind = taskKind(task, kWhereEffects);
  const auto set = set_.find(kind.name);
  return set == set_.end() ? valuesOfRow(kind) : set->second;
}

double& GeneratorEffects::at(const std::string& task, const std::string& effect) {
  const TaskKind& kind = taskKind(task, kWhereEffects);
  const size_t index = indexOf(kind, effect);
  return set_.try_emplace(kind.name, valuesOfRow(kind)).first->second[index];
}

double GeneratorEffects::at(const std::string& task, const std::string& effect) const {
  return of(task)[indexOf(taskKind(task, kWhereEffects), effect)];
}

double GeneratorEffects::valueOr0(const std::string& task, const std::string& effect) const {
  const std::optional<size_t> index = taskKind(task, kWhereEffects).generator.indexOf(effect);
  return index ? of(task)[*index] : 0;
}

void GeneratorEffects::setCondition(const std::string& task, const std::string& condition, double effect) {
  conditions_[taskKind(task, kWhereEffects).name][condition] = effect;
}

std::map<std::string, double> GeneratorEffects::ofConditions(const std::string& task) const {
  const auto ofTask = conditions_.find(task);
  return ofTask == conditions_.end() ? std::map<std::string, double>{} : ofTask->second;
}

std::optional<double> GeneratorEffects::ofCondition(const std::string& task, const std::string& condition) const {
  const auto ofTask = conditions_.find(task);
  if (ofTask == conditions_.end() || !ofTask->second.contains(condition)) {
    return std::nullopt;
  }
  return ofTask->second.at(condition);
}

bool GeneratorEffects::operator==(const GeneratorEffects& other) const {
  const Rows<TaskKind> kinds = taskKinds();
  return conditions_ == other.conditions_ && std::all_of(kinds.begin(), kinds.end(), [&](const TaskKind& kind) {
           return of(kind.name) == other.of(kind.name);
         });
}

double fixedPart(const GeneratorEffects& effects, const GeneratedTrial& trial) {
  const std::vector<GeneratorEffect>& model = taskKind(trial.task, kWhereEffects).generator.effects;
  const std::vector<double> values = effects.of(trial.task);
  double sum = 0;
  for (size_t i = 0; i < model.size(); ++i) {
    if (isDeviation(model[i])) {
      continue;
    }
    const bool isOfCondition = model[i].name == std::string_view(kGraphEffect);
    const std::optional<double> set = isOfCondition ? effects.ofCondition(trial.task, trial.condition) : std::nullopt;
    sum += set.value_or(values[i]) * model[i].covariate(trial);
  }
  return sum;
}

GeneratorEffects readGeneratorEffects(const std::filesystem::path& file) {
  return readAs("docs/simulated_subjects.md", [&] {
    const JsonDocument document(readFile(file, kMaxTextBytes), file.string());
    JsonFields fields(document);
    GeneratorEffects effects;
    for (const TaskKind& kind : taskKinds()) {
      if (!fields.has(kind.name)) {
        continue;
      }
      JsonFields inner = fields.inner(kind.name);
      for (const GeneratorEffect& effect : kind.generator.effects) {
        double& value = effects.at(kind.name, effect.name);
        value = inner.number(effect.name, isDeviation(effect) ? 0 : -kLargestEffect, kLargestEffect, value);
      }
      if (inner.has("conditions")) {
        JsonFields conditions = inner.inner("conditions");
        for (const auto& [name, value] : inner.value("conditions").items()) {
          effects.setCondition(kind.name, name, conditions.number(name, -kLargestEffect, kLargestEffect));
        }
      }
      inner.rejectUnknown();
    }
    fields.rejectUnknown();
    return effects;
  });
}

std::string jsonText(const GeneratorEffects& effects, const Protocol& protocol) {
  nlohmann::ordered_json json;
  for (const TaskKind& kind : taskKinds()) {
    const bool isInProtocol = std::any_of(protocol.blocks.begin(), protocol.blocks.end(),
                                          [&](const ProtocolBlock& block) { return block.taskName == kind.name; });
    if (!isInProtocol && !kind.generator.recordedAlways) {
      continue;
    }
    for (const GeneratorEffect& effect : kind.generator.effects) {
      json[kind.name][effect.name] = effects.at(kind.name, effect.name);
    }
    for (const auto& [name, value] : effects.ofConditions(kind.name)) {
      json[kind.name]["conditions"][name] = value;
    }
  }
  return json.dump();
}

}  // namespace ocelli
