#include "tests/analysis_models/sample_models.h"

#include <fmt/format.h>

#include <string>

namespace ocelli {
namespace {

struct Row {
  int subject;
  int item;
  int round;
};

std::vector<Row> rowsOf(const SampleSize& size) {
  std::vector<Row> rows;
  for (int subject = 0; subject < size.subjects; ++subject) {
    for (int round = 0; round < size.rounds; ++round) {
      for (int item = 0; item < size.items; ++item) {
        rows.push_back({subject, item, round});
      }
    }
  }
  return rows;
}

template <class Value>
auto columnOf(const SampleSize& size, const Value& value) {
  std::vector<decltype(value(Row{}))> column;
  for (const Row& row : rowsOf(size)) {
    column.push_back(value(row));
  }
  return column;
}

}  // namespace

FixedEffects sampleFixedEffects(const SampleSize& size, double sessionScale) {
  FixedEffects fixed(static_cast<Eigen::Index>(rowsOf(size).size()));
  fixed.addIntercept();
  const auto views = columnOf(
      size, [](const Row& row) { return std::string((row.subject + row.item + row.round) % 2 == 0 ? "ppc" : "gc"); });
  fixed.addFactor("view", views, {"ppc", "gc"}, Coding::kCentered);
  fixed.addNumber("moving", columnOf(size, [&](const Row& row) { return row.item < size.items / 2 ? -0.5 : 0.5; }));
  fixed.addNumber("session",
                  columnOf(size, [&](const Row& row) { return sessionScale * ((3 * row.item + row.round) % 4); }));
  return fixed;
}

std::vector<RandomTerm> sampleRandomTerms(const SampleSize& size, const FixedEffects& fixed, bool correlated) {
  RandomTerm subjects =
      randomIntercepts("subject", columnOf(size, [](const Row& row) { return fmt::format("s{:02}", row.subject); }));
  addSlope(subjects, "view", fixed);
  subjects.correlated = correlated;
  return {subjects,
          randomIntercepts("item", columnOf(size, [](const Row& row) { return fmt::format("i{:02}", row.item); }))};
}

Design sampleDesign(const SampleSize& size) {
  const FixedEffects fixed = sampleFixedEffects(size);
  return makeDesign(fixed, sampleRandomTerms(size, fixed));
}

LinearMixedFit sampleLinearTruth() {
  LinearMixedFit truth;
  truth.coefficients.resize(4);
  truth.coefficients << 2.6, -0.4, 0.3, -0.1;
  truth.theta.resize(4);
  truth.theta << 0.6, 0.15, 0.5, 0.6;
  truth.residualDeviation = 0.5;
  return truth;
}

BinomialMixedFit sampleBinomialTruth() {
  BinomialMixedFit truth;
  truth.coefficients.resize(4);
  truth.coefficients << 0.4, 1.2, -0.6, 0.1;
  truth.theta.resize(4);
  truth.theta << 0.8, -0.2, 0.5, 0.5;
  return truth;
}

}  // namespace ocelli
