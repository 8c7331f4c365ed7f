#include "oc_core/shade/shade_page.h"

#include <fmt/format.h>

#include <cctype>
#include <string_view>

#include "oc_core/evaluation/error_image.h"
#include "oc_core/evaluation/evaluation_style.h"
#include "oc_core/page/html.h"

namespace ocelli {
namespace {

/// Pictures whole, not cut to squares.
constexpr std::string_view kShadeStyle = ".shown figure img { aspect-ratio: auto; }\n";

std::string swatch(const Rgb8& color, const std::string& text) {
  return fmt::format("<li><span class=\"swatch\" style=\"background: #{:02x}{:02x}{:02x}\"></span>{}</li>\n", color.x,
                     color.y, color.z, text);
}

std::string imageTag(const std::string& file, const glm::ivec2& size, const std::string& alternative) {
  return file.empty()
             ? ""
             : fmt::format(R"(<a href="{0}"><img src="{0}" width="{1}" height="{2}" loading="lazy" alt="{3}"></a>)",
                           htmlFromText(file), size.x, size.y, htmlFromText(alternative));
}

std::string tableOf(const ShadeReport& report) {
  std::string html =
      "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Figures\"><table><caption>Against the traced "
      "picture, on this machine.</caption>\n<thead><tr><th scope=\"col\">By</th>";
  for (const ShadeColumn& column : shadeColumns()) {
    html += fmt::format("<th scope=\"col\">{}</th>", htmlFromText(column.heading));
  }
  html += "</tr></thead>\n<tbody>\n";
  for (const ShadeFigures& row : report.rows) {
    html += "<tr><th scope=\"row\">" + htmlFromText(row.name) + "</th>";
    for (const ShadeColumn& column : shadeColumns()) {
      html += fmt::format("<td>{}</td>", textOf(column, row));
    }
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

}  // namespace

ShadeImages shadeImageNames(const ShadeFigures& row, size_t number) {
  std::string stem = fmt::format("{}-", number);
  for (const char c : row.name) {
    stem += std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_' ? c : '-';
  }
  const bool compares = row.hasDepth && row.name != kTraced;
  return {stem + ".png", compares ? stem + "-errors.png" : "", row.cost.nodes > 0 ? stem + "-steps.png" : ""};
}

std::string shadePage(const ShadeReport& report, const std::vector<ShadeImages>& images, uint32_t brightestSteps) {
  const size_t rays = report.rows.empty() ? 0 : report.rows.front().rays;
  const size_t castRays = report.rows.empty() ? 0 : report.rows.front().castRays;
  std::string html = pageBegin(report.effect + " in " + report.scene, {kEvaluationStyle, kShadeStyle});
  html += fmt::format(
      "<header>\n<h1>{} by depth images</h1>\n<p><code>{}</code></p>\n<p class=\"soft\">{} rays, one a pixel that "
      "sends "
      "one on in a picture of {} x {} pixels; {} of them first meet objects that depth images stand for. Reference "
      "images of {} x {} pixels, for a cell of {:.3g} units around what sends the rays; an environment map of {} x {}. "
      "Made by ocelli {}.</p>\n</header>\n<main>\n",
      report.effect == "refraction" ? "Refraction" : "Reflection", htmlFromText(report.scene), groupedDigits(rays),
      report.size.x, report.size.y, groupedDigits(castRays), report.referenceSize.x, report.referenceSize.y,
      static_cast<double>(report.cellSide), 2 * report.environmentHeight, report.environmentHeight,
      htmlFromText(report.version));
  html += "<section aria-labelledby=\"figures\">\n<h2 id=\"figures\">Figures</h2>\n" + tableOf(report) + "</section>\n";
  html +=
      "<section aria-labelledby=\"pictures\">\n<h2 id=\"pictures\">Pictures</h2>\n<ul class=\"legend\">\n" +
      swatch(kMissingColor, "missing: the ray meets no sample") +
      swatch(kFalseSkinColor, "off: the first hit is more than 1.5 footprints away from the traced one") +
      swatch(kWrongFrontColor, "false: a sample stands before the traced first hit") +
      fmt::format("</ul>\n<p>Steps: from dark blue for none over red to white for {} or more.</p>\n", brightestSteps) +
      "<div class=\"shown\">\n";
  for (size_t i = 0; i < report.rows.size(); ++i) {
    const ShadeFigures& row = report.rows[i];
    html += fmt::format("<article><h3>{}</h3>\n<figure>{}<div class=\"pair\">{}{}</div></figure></article>\n",
                        htmlFromText(row.name), imageTag(images[i].picture, report.size, row.name + ": the picture"),
                        imageTag(images[i].errors, report.size, row.name + ": where first hits are wrong"),
                        imageTag(images[i].steps, report.size, row.name + ": steps of each ray"));
  }
  html +=
      "</div>\n</section>\n<section aria-labelledby=\"meaning\">\n<h2 id=\"meaning\">What the figures "
      "mean</h2>\n<dl>\n";
  for (const ShadeColumn& column : shadeColumns()) {
    html += fmt::format("<dt>{}</dt><dd>{}.</dd>\n", htmlFromText(column.heading), htmlFromText(column.meaning));
  }
  html +=
      "<dt>Footprint</dt><dd>What a pixel of the reference view covers at the depth of a hit: depth / focal length in "
      "pixels.</dd>\n</dl>\n</section>\n";
  return html + "</main>\n" + pageEnd();
}

}  // namespace ocelli
