#include "analysis/inference/circular.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "analysis/base/distributions.h"
#include "analysis/inference/sample.h"
#include "analysis/inference/student.h"
#include "analysis/inference/wald.h"

namespace ocelli {
namespace {

constexpr size_t kMinSubjects = 3;
constexpr size_t kMinSubjectsOfHotelling = 4;
constexpr size_t kMinAngles = 5;

/// The components of each vector along a direction, and across it (anticlockwise of angles).
struct Components {
  std::vector<double> along;
  std::vector<double> across;
};

Components componentsAt(const std::vector<MeanVector>& vectors, double direction) {
  const double c = std::cos(direction);
  const double s = std::sin(direction);
  Components components;
  for (const MeanVector& vector : vectors) {
    components.along.push_back(vector.cosine * c + vector.sine * s);
    components.across.push_back(vector.sine * c - vector.cosine * s);
  }
  return components;
}

double covarianceOf(const std::vector<double>& a, const std::vector<double>& b) {
  const double meanA = momentsOf(a).mean;
  const double meanB = momentsOf(b).mean;
  double sum = 0;
  for (size_t i = 0; i < a.size(); ++i) {
    sum += (a[i] - meanA) * (b[i] - meanB);
  }
  return sum / static_cast<double>(a.size() - 1);
}

std::string tooFew(size_t count, size_t needed) {
  return fmt::format("there are {} subjects, and {} are needed", count, needed);
}

/// Fieller's interval of the direction around 0, where the mean vector is (length, 0).
Estimable<Estimate> directionOf(const Components& components, double direction, double length, double level) {
  const auto n = static_cast<double>(components.along.size());
  const double t = studentQuantile((1 + level) / 2, n - 1);
  const double square = t * t / n;
  const double along = square * momentsOf(components.along).variance;
  const double across = square * momentsOf(components.across).variance;
  const double both = square * covarianceOf(components.along, components.across);
  const double lead = length * length - along;
  if (!(lead > 0)) {
    return Estimable<Estimate>::impossible(
        "subjects do not agree so well that the mean vector is clear of the centre: any direction may be the mean");
  }
  // The tangents at which the mean across is as far from 0 as t lets it.
  const double root = std::sqrt(both * both + lead * across);
  Estimate estimate;
  estimate.value = direction;
  estimate.lower = direction + std::atan((-both - root) / lead);
  estimate.upper = direction + std::atan((-both + root) / lead);
  estimate.standardError = std::sqrt(across / square / n) / length;
  estimate.degreesOfFreedom = n - 1;
  return estimate;
}

void requirePairs(const std::vector<MeanVector>& first, const std::vector<MeanVector>& second, const char* function) {
  requireArgument(first.size() == second.size(), "the conditions have other numbers of subjects", function);
}

}  // namespace

double MeanVector::length() const {
  return std::hypot(cosine, sine);
}

double MeanVector::direction() const {
  return std::atan2(sine, cosine);
}

MeanVector meanVector(const std::vector<double>& angles) {
  requireArgument(!angles.empty(), "there are no angles", "meanVector");
  requireFinite(angles, "meanVector");
  std::vector<MeanVector> vectors;
  vectors.reserve(angles.size());
  for (const double angle : angles) {
    vectors.push_back({std::cos(angle), std::sin(angle)});
  }
  return meanVector(vectors);
}

MeanVector meanVector(const std::vector<MeanVector>& vectors) {
  requireArgument(!vectors.empty(), "there are no vectors", "meanVector");
  MeanVector mean;
  for (const MeanVector& vector : vectors) {
    mean.cosine += vector.cosine / static_cast<double>(vectors.size());
    mean.sine += vector.sine / static_cast<double>(vectors.size());
  }
  return mean;
}

double circularDeviation(double length) {
  return std::sqrt(-2 * std::log(std::min(length, 1.0)));
}

Estimable<CircularMean> circularMean(const std::vector<MeanVector>& subjects, double level) {
  using Result = Estimable<CircularMean>;
  if (subjects.size() < kMinSubjects) {
    return Result::impossible(tooFew(subjects.size(), kMinSubjects));
  }
  CircularMean result;
  result.mean = meanVector(subjects);
  const double length = result.mean.length();
  const double direction = result.mean.direction();
  const Components components = componentsAt(subjects, direction);
  if (momentsOf(components.along).variance == 0 && momentsOf(components.across).variance == 0) {
    return Result::impossible(fmt::format("all {} subjects have the same mean vector", subjects.size()));
  }
  result.direction = directionOf(components, direction, length, level);
  const Estimable<Estimate> along = studentMean(components.along, level);
  if (along) {
    Estimate cut = *along;
    cut.lower = std::max(cut.lower, 0.0);
    cut.upper = std::min(cut.upper, 1.0);
    cut.statistic = cut.pValue = kNotKnown;
    result.length = cut;
  } else {
    result.length = along;
  }
  return result;
}

Estimable<Estimate> directionDifference(const std::vector<MeanVector>& first, const std::vector<MeanVector>& second,
                                        double level) {
  using Result = Estimable<Estimate>;
  requirePairs(first, second, "directionDifference");
  if (first.size() < kMinSubjects) {
    return Result::impossible(tooFew(first.size(), kMinSubjects));
  }
  std::vector<double> differences(first.size(), 0.0);
  double turn = 0;
  for (const auto& [vectors, sign] : {std::pair(&first, -1.0), std::pair(&second, 1.0)}) {
    const MeanVector mean = meanVector(*vectors);
    const Components components = componentsAt(*vectors, mean.direction());
    if (!directionOf(components, mean.direction(), mean.length(), level)) {
      return Result::impossible("in one of the conditions the mean vector is not clear of the centre");
    }
    turn += sign * mean.direction();
    for (size_t i = 0; i < differences.size(); ++i) {
      differences[i] += sign * components.across[i] / mean.length();
    }
  }
  const SampleMoments moments = momentsOf(differences);
  if (moments.variance == 0) {
    return Result::impossible("all subjects differ by the same");
  }
  return waldEstimate(std::remainder(turn, 2 * std::numbers::pi), std::sqrt(moments.variance / moments.count), level,
                      moments.count - 1);
}

Estimable<Estimate> lengthDifference(const std::vector<MeanVector>& first, const std::vector<MeanVector>& second,
                                     double level) {
  requirePairs(first, second, "lengthDifference");
  if (first.size() < kMinSubjects) {
    return Estimable<Estimate>::impossible(tooFew(first.size(), kMinSubjects));
  }
  const Components before = componentsAt(first, meanVector(first).direction());
  const Components after = componentsAt(second, meanVector(second).direction());
  std::vector<double> differences;
  for (size_t i = 0; i < first.size(); ++i) {
    differences.push_back(differenceOf(before.along[i], after.along[i]));
  }
  return studentMean(differences, level);
}

Estimable<Estimate> hotellingDifference(const std::vector<MeanVector>& first, const std::vector<MeanVector>& second) {
  using Result = Estimable<Estimate>;
  requirePairs(first, second, "hotellingDifference");
  if (first.size() < kMinSubjectsOfHotelling) {
    return Result::impossible(tooFew(first.size(), kMinSubjectsOfHotelling));
  }
  std::vector<double> cosines;
  std::vector<double> sines;
  for (size_t i = 0; i < first.size(); ++i) {
    cosines.push_back(second[i].cosine - first[i].cosine);
    sines.push_back(second[i].sine - first[i].sine);
  }
  const SampleMoments x = momentsOf(cosines);
  const SampleMoments y = momentsOf(sines);
  const double both = covarianceOf(cosines, sines);
  const double determinant = x.variance * y.variance - both * both;
  if (!(determinant > 1e-12 * (x.variance + y.variance) * (x.variance + y.variance)) || x.variance + y.variance == 0) {
    return Result::impossible("the differences of subjects have no spread in some direction");
  }
  const double n = x.count;
  const double square =
      n * (y.variance * x.mean * x.mean - 2 * both * x.mean * y.mean + x.variance * y.mean * y.mean) / determinant;
  Estimate estimate;
  estimate.value = std::hypot(x.mean, y.mean);
  estimate.statistic = square * (n - 2) / (2 * (n - 1));
  estimate.degreesOfFreedom = n - 2;
  // F of 2 and d degrees of freedom has this tail.
  estimate.pValue = std::pow(1 + 2 * estimate.statistic / (n - 2), -(n - 2) / 2);
  return estimate;
}

Estimable<Estimate> rayleighTest(const std::vector<double>& angles) {
  if (angles.size() < kMinAngles) {
    return Estimable<Estimate>::impossible(
        fmt::format("there are {} directions, and {} are needed", angles.size(), kMinAngles));
  }
  const auto n = static_cast<double>(angles.size());
  Estimate estimate;
  estimate.value = meanVector(angles).length();
  estimate.statistic = n * estimate.value * estimate.value;
  estimate.pValue = std::min(1.0, std::exp(std::sqrt(1 + 4 * n + 4 * n * (n - estimate.statistic)) - (1 + 2 * n)));
  return estimate;
}

Estimable<Estimate> vTest(const std::vector<double>& angles, double expected) {
  if (angles.size() < kMinAngles) {
    return Estimable<Estimate>::impossible(
        fmt::format("there are {} directions, and {} are needed", angles.size(), kMinAngles));
  }
  const auto n = static_cast<double>(angles.size());
  const MeanVector mean = meanVector(angles);
  Estimate estimate;
  estimate.value = mean.length() * std::cos(mean.direction() - expected);
  const double z = estimate.value * std::sqrt(2 * n);
  estimate.statistic = z;
  const double first = (3 * z - std::pow(z, 3)) / (16 * n);
  const double second = (15 * z + 305 * std::pow(z, 3) - 125 * std::pow(z, 5) + 9 * std::pow(z, 7)) / (4608 * n * n);
  estimate.pValue = std::clamp(1 - normalProbability(z) + normalDensity(z) * (first + second), 0.0, 1.0);
  return estimate;
}

}  // namespace ocelli
