#include "analysis/report/provenance_section.h"

#include <fmt/format.h>

#include <set>

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
  std::set<std::string> maps;
  for (const DataSource& source : analysis.data.sources) {
    facts.facts.push_back({"Source", source.path});
    if (!source.columnMap.empty() && maps.insert(source.columnMapSha256).second) {
      facts.facts.push_back({fmt::format("Map of columns {}", source.columnMap), source.columnMapSha256, true});
      facts.facts.push_back({"What the map says", source.columnMapText});
    }
    if (!source.protocolSha256.empty()) {
      facts.facts.push_back({fmt::format("Protocol {}", source.protocolName), source.protocolSha256, true});
    }
  }
  std::string views;
  for (const ViewCondition& condition : analysis.data.conditions.list) {
    views += fmt::format("{}{}: {}", views.empty() ? "" : "; ", condition.name, condition.label);
  }
  facts.facts.push_back({"Views in data and files", views, true});
  work.document.add(facts);
}

}  // namespace ocelli
