#include "oc_core/focus/focus_page.h"

#include <fmt/format.h>

#include <cmath>
#include <string_view>

#include "oc_core/page/html.h"

namespace ocelli {
namespace {

constexpr std::string_view kFocusStyle = R"css(figure img { aspect-ratio: auto; object-fit: contain; }
.ways { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(30rem, 100%), 1fr)); gap: 1.5rem; }
.ways h3 { margin: 0; }
.ways p { margin: 0 0 .4rem; min-height: 3.2em; }
.pair { display: grid; grid-template-columns: 1fr 1fr; gap: .5rem; margin-top: .5rem; }
.legend { padding: 0; margin: .5rem 0 1rem; list-style: none; display: flex; flex-wrap: wrap; gap: .3rem 1.2rem; }
.swatch { display: inline-block; width: 1.1em; height: 1.1em; margin-right: .45em; vertical-align: -.2em;
  border: 1px solid var(--soft); border-radius: 3px; print-color-adjust: exact; -webkit-print-color-adjust: exact; }
dt { font-weight: 600; margin-top: .75rem; }
dd { margin: .1rem 0 0; max-width: 52rem; }
@media print { .ways { grid-template-columns: 1fr 1fr; } article, table { break-inside: avoid; } }
)css";

std::string swatch(const Rgb8& color, const std::string& text) {
  return fmt::format("<li><span class=\"swatch\" style=\"background: #{:02x}{:02x}{:02x}\"></span>{}</li>\n", color.x,
                     color.y, color.z, text);
}

std::string imageTag(const std::string& file, const glm::ivec2& size, const std::string& alternative) {
  return fmt::format(R"(<a href="{0}"><img src="{0}" width="{1}" height="{2}" alt="{3}"></a>)", htmlFromText(file),
                     size.x, size.y, htmlFromText(alternative));
}

std::string textOf(const FocusColumn& column, const FocusResult& result) {
  const std::optional<double> value = column.value(result);
  return value ? column.text(*value) : "-";
}

std::string tableHtml(const FocusComparison& comparison, int runs) {
  std::string html = fmt::format(
      "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Figures\"><table><caption>On this machine; "
      "times "
      "are the least of {} drawings, in turn.</caption>\n<thead><tr><th scope=\"col\"></th>",
      runs);
  for (const FocusResult& result : comparison.results) {
    html += fmt::format("<th scope=\"col\">{}</th>", htmlFromText(result.way->title));
  }
  html += "</tr></thead>\n<tbody>\n";
  for (const FocusColumn& column : focusColumns()) {
    html += fmt::format("<tr><th scope=\"row\">{}</th>", htmlFromText(column.heading));
    for (const FocusResult& result : comparison.results) {
      html += "<td>" + textOf(column, result) + "</td>";
    }
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

std::string legendHtml(const RateRange& range) {
  constexpr int kSwatches = 5;
  std::string html = "<ul class=\"legend\">\n";
  for (int i = 0; i < kSwatches; ++i) {
    const double rate = range.least * std::pow(range.greatest / range.least, static_cast<double>(i) / (kSwatches - 1));
    html += swatch(rateColor(rate, range), fmt::format("{:.2f}", rate));
  }
  return html + swatch(kHiddenColor, "not shown") + "</ul>\n";
}

std::string fociText(const GpcLayout& layout) {
  std::string text;
  for (const GpcRegion& each : layout.regions) {
    text += fmt::format("{}{:.3g}x", text.empty() ? "" : ", ", each.zoom);
  }
  return fmt::format("{} {}: {}", layout.regions.size(), layout.regions.size() == 1 ? "focus" : "foci", text);
}

}  // namespace

FocusImages focusImageNames(const FocusWay& way) {
  const std::string name = way.name;
  return {name + ".png", name + "-rates.png", name + "-kept.png"};
}

std::string focusPage(const FocusPage& page, const FocusComparison& comparison, const GpcLayout& layout) {
  std::string html = pageBegin("Focus in its context: " + page.scene, {kFocusStyle});
  html += fmt::format(
      "<header>\n<h1>Focus in its context</h1>\n<p><code>{}</code> by <code>{}</code></p>\n<p class=\"soft\">{}; the "
      "same "
      "places in focus, shown in the same places and as large, by each way. Pictures of {} x {} pixels, drawn along "
      "their "
      "rays. Made by ocelli {}.</p>\n</header>\n<main>\n",
      htmlFromText(page.scene), htmlFromText(page.camera), fociText(layout), comparison.size.x, comparison.size.y,
      htmlFromText(page.version));
  html +=
      "<section aria-labelledby=\"pictures\">\n<h2 id=\"pictures\">Pictures</h2>\n<p>Below each picture: on the left "
      "its sampling rate; on the right the plain view, in the colours of the rate at which the picture shows it. "
      "Samples for each one of the plain view, in the direction that has fewest:</p>\n";
  html += legendHtml(comparison.range) + "<div class=\"ways\">\n";
  for (const FocusResult& result : comparison.results) {
    const FocusImages images = focusImageNames(*result.way);
    const std::string title = result.way->title;
    html += fmt::format(
        "<article><h3>{}</h3>\n<p class=\"soft\">{}.</p>\n<figure>{}<div "
        "class=\"pair\">{}{}</div></figure></article>\n",
        htmlFromText(title), htmlFromText(result.way->description),
        imageTag(images.picture, comparison.size, title + ": the picture"),
        imageTag(images.rates, comparison.size, title + ": sampling rates of the picture"),
        imageTag(images.kept, comparison.size, title + ": what the picture keeps of the plain view"));
  }
  html += "</div>\n</section>\n<section aria-labelledby=\"figures\">\n<h2 id=\"figures\">Figures</h2>\n" +
          tableHtml(comparison, page.runs) +
          "</section>\n<section aria-labelledby=\"meaning\">\n<h2 id=\"meaning\">What the figures mean</h2>\n<dl>\n";
  for (const FocusColumn& column : focusColumns()) {
    html += fmt::format("<dt>{}</dt><dd>{}.</dd>\n", htmlFromText(column.heading), htmlFromText(column.meaning));
  }
  return html + "</dl>\n</section>\n</main>\n" + pageEnd();
}

std::string focusTable(const FocusComparison& comparison) {
  std::string text = fmt::format("{:<24}", "");
  for (const FocusResult& result : comparison.results) {
    text += fmt::format(" {:>10}", result.way->name);
  }
  text += "\n";
  for (const FocusColumn& column : focusColumns()) {
    text += fmt::format("{:<24}", column.heading);
    for (const FocusResult& result : comparison.results) {
      text += fmt::format(" {:>10}", textOf(column, result));
    }
    text += "\n";
  }
  return text;
}

}  // namespace ocelli
