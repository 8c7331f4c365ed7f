// PDF files of drawings: pages with embedded fonts, bookmarks, links and metadata, written by Cairo.
#pragma once

#include <string>
#include <vector>

#include "oc_core/drawing/drawing.h"

namespace ocelli {

/// A place of a page that leads to the page where `target` is.
struct PdfLink {
  PlotBox box;
  std::string target;
};

/// A named place: what links and bookmarks lead to.
struct PdfTarget {
  std::string name;  ///< unique in the document
  PlotPoint at;
};

struct PdfPage {
  Drawing drawing;
  std::vector<PdfLink> links = {};
  std::vector<PdfTarget> targets = {};
};

struct PdfBookmark {
  std::string title;
  int level = 1;  ///< 1 is the outermost
  std::string target;
};

struct PdfDocument {
  std::string title;
  std::string author;
  std::string subject;
  std::string keywords;
  /// ISO 8601. Given, so that the same document gives the same bytes.
  std::string created = "2000-01-01T00:00:00Z";
  double width = 0;  ///< of every page, points
  double height = 0;
  std::vector<PdfPage> pages;
  std::vector<PdfBookmark> bookmarks;
};

/// Links and bookmarks whose target does not exist are left out. DrawingError where Cairo fails.
std::string pdfBytes(const PdfDocument& document);

}  // namespace ocelli
