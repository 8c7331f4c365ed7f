#include "analysis/report/provenance_section.h"

#include <fmt/format.h>

namespace ocelli {

void addProvenance(ReportWork& work, const std::string& version) {
  const AnalysisData& analysis = work.analysis;
  const InSupplement supplement(work.document);
  addHeading(work.document, 2, "Provenance", "provenance");
  ReportFacts facts;
  facts.facts = {{"Program", fmt::format("Ocelli {}", version)},
                 {"Plan", describe(analysis.plan)},
                 {"Seed", std::to_string(analysis.plan.seed)},
                 {"SHA-256 of the data", analysis.dataSha256, true}};
  for (const DataSource& source : analysis.data.sources) {
    facts.facts.push_back({"Source", source.path});
    if (!source.protocolSha256.empty()) {
      facts.facts.push_back({fmt::format("Protocol {}", source.protocolName), source.protocolSha256, true});
    }
  }
  const auto& [reference, other] = analysis.data.conditions.list;
  facts.facts.push_back({"Views in data and files",
                         fmt::format("{}: {}; {}: {}", reference.name, reference.label, other.name, other.label),
                         true});
  work.document.add(facts);
}

}  // namespace ocelli
