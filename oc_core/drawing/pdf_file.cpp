#include "oc_core/drawing/pdf_file.h"

#include <cairo-pdf.h>
#include <cairo.h>
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "oc_core/base/utf8.h"
#include "oc_core/drawing/cairo_painter.h"

namespace ocelli {
namespace {

cairo_status_t writePdfBytes(void* closure, const unsigned char* data, unsigned int length) {
  appendBytes(closure, data, length);
  return CAIRO_STATUS_SUCCESS;
}

struct Place {
  int page;  ///< from 1
  PlotPoint at;
};
using Places = std::map<std::string, Place>;

Places placesOf(const PdfDocument& document) {
  Places places;
  int page = 0;
  for (const PdfPage& each : document.pages) {
    ++page;
    for (const PdfTarget& target : each.targets) {
      places.emplace(target.name, Place{page, target.at});
    }
  }
  return places;
}

std::string attributesOf(const Place& place) {
  return fmt::format("page={} pos=[{:.2f} {:.2f}]", place.page, place.at.x, place.at.y);
}

void setMetadata(cairo_surface_t* surface, const PdfDocument& document) {
  const auto set = [&](cairo_pdf_metadata_t key, const std::string& value) {
    if (!value.empty()) {
      cairo_pdf_surface_set_metadata(surface, key, cleanText(value).c_str());
    }
  };
  set(CAIRO_PDF_METADATA_TITLE, document.title);
  set(CAIRO_PDF_METADATA_AUTHOR, document.author);
  set(CAIRO_PDF_METADATA_SUBJECT, document.subject);
  set(CAIRO_PDF_METADATA_KEYWORDS, document.keywords);
  set(CAIRO_PDF_METADATA_CREATOR, "Ocelli");
  set(CAIRO_PDF_METADATA_CREATE_DATE, document.created);
}

void addBookmarks(cairo_surface_t* surface, const PdfDocument& document, const Places& places) {
  std::vector<int> parents{CAIRO_PDF_OUTLINE_ROOT};  // the last of each level
  for (const PdfBookmark& bookmark : document.bookmarks) {
    const auto place = places.find(bookmark.target);
    if (place == places.end()) {
      continue;
    }
    parents.resize(std::clamp<size_t>(static_cast<size_t>(std::max(bookmark.level, 1)), 1, parents.size()));
    parents.push_back(cairo_pdf_surface_add_outline(surface, parents.back(), cleanText(bookmark.title).c_str(),
                                                    attributesOf(place->second).c_str(), CAIRO_PDF_OUTLINE_FLAG_OPEN));
  }
}

}  // namespace

std::string pdfBytes(const PdfDocument& document) {
  const Places places = placesOf(document);
  return bytesOfSurface(
      [&](void* closure) {
        return cairo_pdf_surface_create_for_stream(writePdfBytes, closure, document.width, document.height);
      },
      [&](cairo_surface_t* surface, cairo_t* context) {
        setMetadata(surface, document);
        for (const PdfPage& page : document.pages) {
          paintDrawing(context, page.drawing);
          for (const PdfLink& link : page.links) {
            const auto place = places.find(link.target);
            if (place != places.end()) {
              const std::string attributes =
                  fmt::format("rect=[{:.2f} {:.2f} {:.2f} {:.2f}] {}", link.box.left, link.box.top, link.box.width(),
                              link.box.height(), attributesOf(place->second));
              cairo_tag_begin(context, CAIRO_TAG_LINK, attributes.c_str());
              cairo_tag_end(context, CAIRO_TAG_LINK);
            }
          }
          cairo_show_page(context);
        }
        addBookmarks(surface, document, places);
      });
}

}  // namespace ocelli
