#include "oc_core/shade/shade_page.h"

#include <fmt/format.h>

#include <cctype>
#include <string_view>

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
  return fmt::format(R"(<a href="{0}"><img src="{0}" width="{1}" height="{2}" loading="lazy" alt="{3}"></a>)",
                     htmlFromText(file), size.x, size.y, htmlFromText(alternative));
}

std::string tableOf(const ShadeReport& report) {
  std::string html =
      "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Figures\"><table><caption>Against the traced "
      "picture, on this machine.</caption>\n<thead><tr><th scope=\"col\">By</th>";
  const std::vector<size_t> shown = shownColumns(report);
  for (const size_t column : shown) {
    html += fmt::format("<th scope=\"col\">{}</th>", htmlFromText(report.effect.columns[column].heading));
  }
  html += "</tr></thead>\n<tbody>\n";
  for (const ShadedWay& way : report.ways) {
    html += "<tr><th scope=\"row\">" + htmlFromText(way.name) + "</th>";
    for (const size_t column : shown) {
      html += fmt::format("<td>{}</td>", textOf(report.effect.columns[column], way.figures[column]));
    }
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

}  // namespace

ShadeImages shadeImageNames(const ShadedWay& way, size_t number) {
  std::string stem = fmt::format("{}-", number);
  for (const char c : way.name) {
    stem += std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_' ? c : '-';
  }
  ShadeImages images{stem + ".png", {}};
  for (const ShadedMap& map : way.maps) {
    images.maps.push_back(fmt::format("{}-{}.png", stem, map.name));
  }
  return images;
}

std::string shadePage(const ShadeReport& report) {
  std::string html =
      pageBegin(std::string(report.effect.name) + " in " + report.scene, {kEvaluationStyle, kShadeStyle});
  html += fmt::format(
      "<header>\n<h1>{} by depth images</h1>\n<p><code>{}</code></p>\n<p class=\"soft\">Pictures of {} x {} pixels.",
      report.effect.title, htmlFromText(report.scene), report.size.x, report.size.y);
  for (const ShadeFact& fact : report.facts) {
    if (!fact.sentence.empty()) {
      html += " ";
      html += htmlFromText(fact.sentence);
    }
  }
  html += fmt::format(" Made by ocelli {}.</p>\n</header>\n<main>\n", htmlFromText(report.version));
  html += "<section aria-labelledby=\"figures\">\n<h2 id=\"figures\">Figures</h2>\n" + tableOf(report) + "</section>\n";
  html += "<section aria-labelledby=\"pictures\">\n<h2 id=\"pictures\">Pictures</h2>\n<ul class=\"legend\">\n";
  for (const ShadeLegend& entry : report.effect.legend) {
    html += swatch(entry.color, htmlFromText(entry.meaning));
  }
  html += fmt::format("</ul>\n<p>{}</p>\n<div class=\"shown\">\n", htmlFromText(report.effect.mapNote));
  for (size_t i = 0; i < report.ways.size(); ++i) {
    const ShadedWay& way = report.ways[i];
    const ShadeImages images = shadeImageNames(way, i);
    html += fmt::format("<article><h3>{}</h3>\n<figure>{}<div class=\"pair\">", htmlFromText(way.name),
                        imageTag(images.picture, report.size, way.name + ": the picture"));
    for (size_t map = 0; map < way.maps.size(); ++map) {
      html += imageTag(images.maps[map], report.size, way.name + ": " + way.maps[map].alternative);
    }
    html += "</div></figure></article>\n";
  }
  html +=
      "</div>\n</section>\n<section aria-labelledby=\"meaning\">\n<h2 id=\"meaning\">What the figures "
      "mean</h2>\n<dl>\n";
  for (const size_t column : shownColumns(report)) {
    html += fmt::format("<dt>{}</dt><dd>{}.</dd>\n", htmlFromText(report.effect.columns[column].heading),
                        htmlFromText(report.effect.columns[column].meaning));
  }
  for (const ShadeTerm& term : report.effect.terms) {
    html += fmt::format("<dt>{}</dt><dd>{}</dd>\n", htmlFromText(term.term), htmlFromText(term.meaning));
  }
  html += "</dl>\n</section>\n";
  return html + "</main>\n" + pageEnd();
}

}  // namespace ocelli
