// Writes a report with every kind of element into a folder: whoever changes a writer looks at it.
//
// Usage: report_gallery FOLDER
#include "analysis/report/html_report.h"
#include "analysis/report/json_report.h"
#include "analysis/report/pdf_report.h"
#include "analysis/report/report_folder.h"
#include "tests/analysis_report/sample_document.h"

int main(int argc, char** argv) {
  const ocelli::ReportDocument document = ocelli::sampleDocument();
  ocelli::writeReportFolder(argc > 1 ? argv[1] : "report_gallery", {{"report.html", ocelli::htmlReport(document)},
                                                                    {"report.pdf", ocelli::pdfReport(document)},
                                                                    {"report.json", ocelli::jsonReport(document)}});
}
