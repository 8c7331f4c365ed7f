// Processor time of mixed models: those of a study, and of a thousand subjects.
#include <fmt/format.h>

#include <ctime>

#include "analysis/models/binomial_mixed_model.h"
#include "analysis/models/linear_mixed_model.h"

namespace ocelli {
namespace {

struct Size {
  int subjects = 45;
  int trials = 24;  ///< of each subject
  int items = 24;
};

/// View, moving and session with the interaction of the first two; subjects with a slope of view, crossed with items.
Design designOf(const Size& size) {
  std::vector<std::string> subjects;
  std::vector<std::string> items;
  std::vector<std::string> views;
  std::vector<std::string> moving;
  std::vector<double> sessions;
  for (int subject = 0; subject < size.subjects; ++subject) {
    for (int trial = 0; trial < size.trials; ++trial) {
      const int item = (trial + 7 * subject) % size.items;
      subjects.push_back(fmt::format("s{:04}", subject));
      items.push_back(fmt::format("i{:03}", item));
      views.emplace_back((trial + subject) % 2 == 0 ? "ppc" : "gc");
      moving.emplace_back(item % 4 < 2 ? "no" : "yes");
      sessions.push_back(3 * trial / size.trials);
    }
  }
  FixedEffects fixed(static_cast<Eigen::Index>(subjects.size()));
  fixed.addIntercept();
  fixed.addFactor("view", views, {"ppc", "gc"}, Coding::kCentered);
  fixed.addFactor("moving", moving, {"no", "yes"}, Coding::kCentered);
  fixed.addNumber("session", sessions);
  fixed.addInteraction("view", "moving");
  RandomTerm bySubject = randomIntercepts("subject", subjects);
  addSlope(bySubject, "view", fixed);
  return makeDesign(fixed, {bySubject, randomIntercepts("item", items)});
}

/// Of the CPU: all of it is one thread.
template <class Work>
double millisecondsOf(const Work& work) {
  const std::clock_t start = std::clock();
  work();
  return 1000.0 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

void measure(const Size& size, int repeats) {
  Design design = designOf(size);
  RandomNumbers numbers(1);
  LinearMixedFit truth;
  truth.coefficients = Eigen::VectorXd::Constant(5, -0.3);
  truth.theta.resize(4);
  truth.theta << 0.6, 0.1, 0.3, 0.5;
  truth.residualDeviation = 0.5;
  const LinearMixedModel linear(design);
  const BinomialMixedModel binomial(design);
  BinomialMixedFit binomialTruth;
  binomialTruth.coefficients = truth.coefficients;
  binomialTruth.theta = truth.theta;
  double linearTime = 0;
  double binomialTime = 0;
  double restrictedTime = 0;
  int linearEvaluations = 0;
  int binomialEvaluations = 0;
  int failed = 0;
  for (int repeat = 0; repeat < repeats; ++repeat) {
    const Eigen::VectorXd response = linear.simulate(truth, numbers);
    linearTime += millisecondsOf([&] {
      const auto fit = linear.fit(response);
      failed += fit && fit->convergence.converged ? 0 : 1;
      linearEvaluations += fit ? fit->convergence.evaluations : 0;
    });
    const BinomialResponse answers = binomial.simulate(binomialTruth, Eigen::VectorXd::Ones(design.rows()), numbers);
    restrictedTime += millisecondsOf([&] { failed += binomial.fitRestricted(answers).isPossible() ? 0 : 1; });
    binomialTime += millisecondsOf([&] {
      const auto fit = binomial.fit(answers);
      failed += fit && fit->convergence.converged ? 0 : 1;
      binomialEvaluations += fit ? fit->convergence.evaluations : 0;
    });
  }
  fmt::print(
      "{:>5} subjects x {:>3} trials, {:>3} items: linear {:.1f} ms ({} evaluations), binomial {:.1f} ms ({}), "
      "restricted {:.1f} ms; {} did not converge\n",
      size.subjects, size.trials, size.items, linearTime / repeats, linearEvaluations / repeats, binomialTime / repeats,
      binomialEvaluations / repeats, restrictedTime / repeats, failed);
}

}  // namespace
}  // namespace ocelli

int main() {
  ocelli::measure({45, 24, 24}, 20);
  ocelli::measure({45, 40, 20}, 20);
  ocelli::measure({1000, 100, 100}, 1);
  return 0;
}
