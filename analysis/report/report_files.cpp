#include "analysis/report/report_files.h"

#include <fmt/format.h>

#include "analysis/report/html_report.h"
#include "analysis/report/json_report.h"
#include "analysis/report/pdf_report.h"

namespace ocelli {

std::vector<ReportFile> reportFiles(const ReportDocument& document) {
  std::vector<ReportFile> files{{"index.html", htmlReport(document)},
                                {"supplement.html", htmlSupplement(document)},
                                {"report.pdf", pdfReport(document)},
                                {"report.json", jsonReport(document)}};
  const DocumentNames names = documentNames(document);
  const auto addFigures = [&](const std::vector<ReportElement>& part, const std::vector<ElementName>& named) {
    for (size_t i = 0; i < part.size(); ++i) {
      if (const auto* element = std::get_if<ReportFigure>(&part[i])) {
        files.push_back({fmt::format("figures/{}.svg", named[i].id), svgText(element->figure)});
        files.push_back({fmt::format("figures/{}.pdf", named[i].id), pdfBytes(element->figure)});
      }
    }
  };
  addFigures(document.elements, names.elements);
  addFigures(document.supplement, names.supplement);
  return files;
}

}  // namespace ocelli
