// 1,000 studies with known effects, and 1,000 without: how often 95 % intervals of the report hold the truth, and how
// often a true null is rejected. With --case-views: how often where cases differ in the effect of the view.
//
//   simulated_studies_bench protocols/rosen2010.json
//   simulated_studies_bench protocols/rosen2010.json --case-views --design small --only find-time
#include <ctime>

#include "bench/bench_program.h"
#include "bench/case_view_errors.h"
#include "bench/study_coverage.h"

namespace ocelli {
namespace {

struct Choice {
  std::string protocol;
  std::vector<std::string> only{};
  std::string design;
  int threads = 0;
  bool caseViews = false;
  CoverageRun run{};

  bool namesDesign(const std::string& name) const { return design.empty() || name == design; }
  bool names(const std::string& name) const {
    return only.empty() || std::find(only.begin(), only.end(), name) != only.end();
  }
};

std::string shareText(const Share& share) {
  if (share.trials == 0) {
    return "-";
  }
  const Estimate estimate = wilsonShare(share);
  return fmt::format("{:.1f} ({:.1f}-{:.1f})", 100 * estimate.value, 100 * estimate.lower, 100 * estimate.upper);
}

void print(const CoverageResult& result, const char* studies) {
  fmt::print("  {}: {} studies, {} impossible, {} singular, {} not converged\n", studies, result.studies,
             result.impossible, result.singular, result.unconverged);
  for (const TermCoverage& term : result.terms) {
    fmt::print(
        "    {:<16} truth {:>7.4f}  covered {:<18} p < 0.05 {:<18} bias {:>8.4f}  sd {:.4f}  se/sd {:.3f}  mean "
        "covered {:.1f}\n",
        term.name, term.truth, shareText(term.covered), shareText(term.rejected), term.meanError, term.deviation,
        term.standardError / term.deviation, 100.0 * term.coveredMean.successes / std::max(1, term.coveredMean.trials));
  }
}

/// Of studies without an effect of the view, or with one at the bound of equivalence.
void measureCaseViews(const Choice& choice, const Protocol& protocol) {
  fmt::print("{:<8}{:<18}{:>10}  {:<18}{:<18}{:>9}{:>11}{:>8}\n", "design", "model", "deviation", "p < 0.05",
             "one-sided", "se / sd", "impossible", "warned");
  for (const ErrorScenario& scenario : errorScenarios()) {
    if (choice.names(scenario.model) && choice.namesDesign(scenario.design.name)) {
      const ErrorRates rates = errorRatesOf(scenario, protocol, choice.run);
      fmt::print("{:<8}{:<18}{:>10}  {:<18}{:<18}{:>9.3f}{:>11}{:>8}\n", scenario.design.name, scenario.model,
                 scenario.ofItemViews, shareText(rates.rejected), shareText(rates.oneSided),
                 rates.standardError / rates.deviation, rates.impossible, rates.warned);
      std::fflush(stdout);
    }
  }
}

void measure(const Choice& choice) {
  const Protocol protocol = readProtocol(choice.protocol);
  if (choice.caseViews) {
    measureCaseViews(choice, protocol);
    return;
  }
  for (const CoverageScenario& scenario : coverageScenarios()) {
    if (!choice.names(scenario.name)) {
      continue;
    }
    const PlannedModel model = modelOf(scenario);
    fmt::print("{} (model {}): {}\n", scenario.name, model.name, scenario.what);
    const std::clock_t start = std::clock();
    for (const bool null : {false, true}) {
      const SimulatedStudy study = studyOf(scenario, protocol, null);
      const CoverageRun run{choice.run.studies, choice.run.seed + (null ? 1 : 0)};
      print(coverageOf(model, study, reportedTruths(scenario, study), run), null ? "null" : "effects");
    }
    fmt::print("  {:.0f} s of the CPU\n", static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace ocelli

int main(int argumentCount, char** arguments) {
  CLI::App program("How often the report's intervals hold the truth, over simulated studies",
                   "simulated_studies_bench");
  ocelli::Choice choice;
  program.add_option("protocol", choice.protocol, "Whose schedule the studies have")->required();
  program.add_option("--studies", choice.run.studies, "With effects, and as many without")
      ->check(CLI::Range(2, 1000000))
      ->capture_default_str();
  program.add_option("--seed", choice.run.seed, "All that is random comes of it")->capture_default_str();
  program.add_option("--only", choice.only, "Names of scenarios; with --case-views, of models of the default plan")
      ->delimiter(',');
  program.add_flag("--case-views", choice.caseViews,
                   "How often true nulls are rejected where cases differ in the effect of the view");
  program.add_option("--design", choice.design, "With --case-views: one design alone")
      ->check(CLI::IsMember({"small", "2010"}));
  program.add_option("--threads", choice.threads, "0 stands for all cores")->check(CLI::Range(0, 1024));
  return ocelli::runProgram(program, argumentCount, arguments, choice, ocelli::measure);
}
