#include "study/trial/estimated_value.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

constexpr std::array kEstimateUnits{EstimateUnit{"m", "metres", false}, EstimateUnit{"degrees", "degrees", true}};

bool canHave(const EstimateUnit& unit, double value) {
  return std::isfinite(value) && (unit.isDirection ? value >= 0 && value < kDegreesOfTurn : value > 0);
}

std::string estimateMeasure(const EstimateUnit& unit) {
  return fmt::format("estimate_{}", unit.name);
}
std::string truthMeasure(const EstimateUnit& unit) {
  return fmt::format("truth_{}", unit.name);
}

}  // namespace

std::span<const EstimateUnit> estimateUnits() {
  return kEstimateUnits;
}

const EstimateUnit& estimateUnit(std::string_view name, const std::string& where) {
  std::string names;
  for (const EstimateUnit& unit : kEstimateUnits) {
    if (unit.name == name) {
      return unit;
    }
    names += fmt::format("{}{}", names.empty() ? "" : ", ", unit.name);
  }
  throw InputError(fmt::format("there is no unit \"{}\" of estimates", name), where,
                   fmt::format("the units are {}", names));
}

double wrappedDegrees(double degrees) {
  const double rest = std::remainder(degrees, kDegreesOfTurn);
  return rest <= -kDegreesOfTurn / 2 ? rest + kDegreesOfTurn : rest;
}

double withinTurn(double degrees) {
  const double rest = std::fmod(degrees, kDegreesOfTurn);
  const double turned = rest < 0 ? rest + kDegreesOfTurn : rest;
  return turned < kDegreesOfTurn ? turned : 0;
}

double EstimatedValue::signedError() const {
  return unit->isDirection ? wrappedDegrees(estimate - truth) : std::log(estimate / truth);
}

EstimatedValue estimateWithError(const EstimateUnit& unit, double truth, double error) {
  if (!unit.isDirection) {
    return {&unit, truth * std::exp(error), truth};
  }
  return {&unit, withinTurn(truth + wrappedDegrees(error)), truth};
}

std::map<std::string, double> measuresOf(const EstimatedValue& value) {
  return {{estimateMeasure(*value.unit), value.estimate}, {truthMeasure(*value.unit), value.truth}};
}

std::optional<EstimatedValue> estimatedValue(const std::map<std::string, double>& measures) {
  for (const EstimateUnit& unit : kEstimateUnits) {
    const auto estimate = measures.find(estimateMeasure(unit));
    const auto truth = measures.find(truthMeasure(unit));
    if (estimate != measures.end() && truth != measures.end() && canHave(unit, estimate->second) &&
        canHave(unit, truth->second)) {
      return EstimatedValue{&unit, estimate->second, truth->second};
    }
  }
  return std::nullopt;
}

std::string estimateText(double value) {
  return fmt::format("{}", std::round(value * 1e4) / 1e4);
}

}  // namespace ocelli
