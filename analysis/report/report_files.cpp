#include "analysis/report/report_files.h"

#include <fmt/format.h>

#include "analysis/report/html_report.h"
#include "analysis/report/json_report.h"
#include "analysis/report/pdf_report.h"

namespace ocelli {

std::vector<ReportFile> reportFiles(const ReportDocument& document) {
  std::vector<ReportFile> files{
      {"index.html", htmlReport(document)}, {"report.pdf", pdfReport(document)}, {"report.json", jsonReport(document)}};
  const std::vector<ElementName> names = elementNames(document);
  for (size_t i = 0; i < document.elements.size(); ++i) {
    if (const auto* element = std::get_if<ReportFigure>(&document.elements[i])) {
      files.push_back({fmt::format("figures/{}.svg", names[i].id), svgText(element->figure)});
      files.push_back({fmt::format("figures/{}.pdf", names[i].id), pdfBytes(element->figure)});
    }
  }
  return files;
}

}  // namespace ocelli
