#include "oc_core/drawing/figure.h"

#include <cairo-svg.h>
#include <cairo.h>
#include <fmt/format.h>

#include <cmath>
#include <map>

#include "oc_core/drawing/cairo_painter.h"
#include "oc_core/drawing/pdf_file.h"
#include "oc_core/page/html.h"

namespace ocelli {
namespace {

cairo_status_t writeBytes(void* closure, const unsigned char* data, unsigned int length) {
  appendBytes(closure, data, length);
  return CAIRO_STATUS_SUCCESS;
}

std::string cairoSvg(const Figure& figure) {
  return bytesOfSurface(
      [&](void* closure) {
        return cairo_svg_surface_create_for_stream(writeBytes, closure, figure.width, figure.height);
      },
      [&](cairo_surface_t*, cairo_t* context) { paintDrawing(context, figure.drawing); });
}

/// Cairo's ids count on through the program ("surface5"), and start anew in each figure ("glyph0-1"): they become the
/// prefix and a number each, in the order in which they come.
class IdNames {
 public:
  explicit IdNames(std::string prefix) : prefix_(std::move(prefix)) {}

  std::string of(const std::string& id) {
    return fmt::format("{}{}", prefix_, numbers_.try_emplace(id, numbers_.size()).first->second);
  }

 private:
  std::string prefix_;
  std::map<std::string, size_t> numbers_;
};

/// Cairo's text with other ids. `start` is where its content starts.
std::string renamed(const std::string& svg, size_t start, const std::string& idPrefix) {
  IdNames names(idPrefix);
  std::string out;
  size_t at = start;
  while (at < svg.size()) {
    bool found = false;
    for (const auto& [before, end] :
         {std::pair<std::string_view, char>{" id=\"", '"'}, {"=\"#", '"'}, {"url(#", ')'}}) {
      if (svg.compare(at, before.size(), before) == 0) {
        const size_t from = at + before.size();
        const size_t to = svg.find(end, from);
        out += fmt::format("{}{}", before, names.of(svg.substr(from, to - from)));
        at = to;
        found = true;
        break;
      }
    }
    if (!found) {
      out += svg[at++];
    }
  }
  return out;
}

/// `namespaces` are attributes of the root.
std::string describedSvg(const Figure& figure, const std::string& idPrefix, const std::string& namespaces) {
  const std::string svg = cairoSvg(figure);
  const size_t root = svg.find('>', svg.find("<svg"));
  return fmt::format(
      "<svg {}width=\"{:.2f}pt\" height=\"{:.2f}pt\" viewBox=\"0 0 {:.2f} {:.2f}\" role=\"img\" "
      "aria-labelledby=\"{}title {}desc\">\n<title id=\"{}title\">{}</title>\n<desc id=\"{}desc\">{}</desc>{}",
      namespaces, figure.width, figure.height, figure.width, figure.height, idPrefix, idPrefix, idPrefix,
      htmlFromText(figure.title), idPrefix, htmlFromText(figure.description), renamed(svg, root + 1, idPrefix));
}

}  // namespace

std::string svgText(const Figure& figure) {
  return fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n{}",
                     describedSvg(figure, "f-",
                                  "xmlns=\"http://www.w3.org/2000/svg\" "
                                  "xmlns:xlink=\"http://www.w3.org/1999/xlink\" "));
}

std::string inlineSvgText(const Figure& figure, const std::string& idPrefix) {
  return describedSvg(figure, idPrefix, "");
}

std::string pdfBytes(const Figure& figure) {
  PdfDocument document;
  document.title = figure.title;
  document.subject = figure.description;
  document.width = figure.width;
  document.height = figure.height;
  document.pages.push_back({figure.drawing, {}});
  return pdfBytes(document);
}

std::string pngBytes(const Figure& figure, double pixelsPerInch) {
  const CairoSurface surface =
      paintedSurface(figure.drawing, figure.width, figure.height, pixelsPerInch / kPointsPerInch);
  std::string bytes;
  checkCairo(cairo_surface_write_to_png_stream(surface.get(), writeBytes, &bytes));
  return bytes;
}

Pixels pixelsOf(const Figure& figure) {
  return pixelsOf(paintedSurface(figure.drawing, figure.width, figure.height, 1).get());
}

}  // namespace ocelli
