#include "study/outline/psychometric_shape.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

constexpr std::array kPsychometricShapes{
    PsychometricShape{"weibull", [](double z) { return -std::expm1(-std::exp(z)); }, "1 - 1/e"},
    PsychometricShape{"logistic", [](double z) { return 1 / (1 + std::exp(-z)); }, "a half"},
};

}  // namespace

std::span<const PsychometricShape> psychometricShapes() {
  return kPsychometricShapes;
}

std::string psychometricShapeNames() {
  std::string names;
  for (const PsychometricShape& shape : kPsychometricShapes) {
    names += fmt::format("{}{}", names.empty() ? "" : ", ", shape.name);
  }
  return names;
}

const PsychometricShape& psychometricShape(std::string_view name, const std::string& where) {
  for (const PsychometricShape& shape : kPsychometricShapes) {
    if (shape.name == name) {
      return shape;
    }
  }
  throw InputError(fmt::format("there is no psychometric function \"{}\"", name), where,
                   fmt::format("the functions are {}", psychometricShapeNames()));
}

}  // namespace ocelli
