#include "display_driver/selftest/selftest_page.h"

#include <fmt/format.h>

#include "display_driver/selftest/selftest_style.h"
#include "oc_core/page/html.h"

namespace ocelli {
namespace {

std::string fact(const std::string& name, const std::string& value) {
  return "<div><dt>" + name + "</dt><dd>" + htmlFromText(value) + "</dd></div>\n";
}

std::string profileFacts(const DisplayProfile& profile) {
  std::string html = "<dl class=\"facts\">\n";
  html += fact("Profile", profile.name);
  html +=
      fact("Screen", fmt::format("{} x {}, {:.4g} x {:.4g} mm", profile.width, profile.height,
                                 2000 * profile.radiusMetres, 2000 * profile.radiusMetres * profile.halfHeightRadii));
  html += fact("Slices", fmt::format("{} a half turn{}", profile.slicesPerHalfTurn,
                                     profile.secondHalfTurn == SecondHalfTurn::kOwn ? ", others in the second" : ""));
  html += fact("Rotation",
               fmt::format("{:g} rpm, {:.3g} refreshes a second", profile.rotationsPerMinute, profile.refreshHertz()));
  html += fact("Colour", fmt::format("{} bit{} a channel, channels {}", profile.colorBitsPerChannel,
                                     profile.colorBitsPerChannel == 1 ? "" : "s",
                                     profile.channelTiming == ChannelTiming::kTogether ? "together" : "in turn"));
  html += fact("Seen from", fmt::format("{:.3g} m", profile.viewingDistanceMetres));
  return html + "</dl>\n";
}

std::string checkBoxes(const TestPattern& pattern) {
  std::string html = "<h3>Check</h3>\n<ul class=\"checks\">\n";
  for (const std::string& look : pattern.lookFor) {
    html += "<li><label><input type=\"checkbox\"><span>" + htmlFromText(look) + "</span></label></li>\n";
  }
  return html + "</ul>\n";
}

std::string wrongFigure(const WrongLook& wrong, const SelftestImage& image) {
  return image.file.empty() ? ""
                            : fmt::format("<img src=\"{}\" width=\"{}\" height=\"{}\" alt=\"{}, for example: {}\">",
                                          htmlFromText(image.file), image.width, image.height,
                                          htmlFromText(wrong.looks), htmlFromText(image.place));
}

std::string wrongTable(const SelftestSection& section) {
  const TestPattern& pattern = *section.pattern;
  std::string html = fmt::format(
      "<h3 id=\"wrong-{0}\">When it looks wrong</h3>\n<div class=\"scroll\" tabindex=\"0\" role=\"region\" "
      "aria-labelledby=\"wrong-{0}\"><table>\n<thead><tr><th scope=\"col\">What you see</th><th scope=\"col\">What it "
      "means</th><th scope=\"col\">What to do</th></tr></thead>\n<tbody>\n",
      pattern.name);
  for (size_t i = 0; i < pattern.wrong.size(); ++i) {
    const WrongLook& wrong = pattern.wrong[i];
    const SelftestImage& image = section.wrong[i];
    html += fmt::format("<tr><th scope=\"row\">{}{}</th><td>{}</td><td>{}</td></tr>\n", wrongFigure(wrong, image),
                        htmlFromText(wrong.looks), htmlFromText(wrong.means), htmlFromText(wrong.adjust));
  }
  return html + "</tbody></table></div>\n";
}

std::string patternSection(const SelftestSection& section, size_t number, const DisplayProfile& profile) {
  const TestPattern& pattern = *section.pattern;
  std::string html = fmt::format(
      "<section aria-labelledby=\"{0}\">\n<h2 id=\"{0}\">{1}. {2}</h2>\n<p>{3} <span class=\"soft\">Show <a "
      "href=\"{4}\"><code>{4}</code></a>.</span></p>\n",
      pattern.name, number, htmlFromText(pattern.title), htmlFromText(pattern.shows), htmlFromText(section.volumeFile));
  html += section.images.empty() ? "" : "<div class=\"images\">\n";
  for (const SelftestImage& image : section.images) {
    html += fmt::format(
        "<figure><a href=\"{0}\"><img src=\"{0}\" width=\"{1}\" height=\"{2}\" alt=\"{3}, as it should look: "
        "{4}\"></a><figcaption>{4}</figcaption></figure>\n",
        htmlFromText(image.file), image.width, image.height, htmlFromText(pattern.title), htmlFromText(image.place));
  }
  html += (section.images.empty() ? "" : "</div>\n") + checkBoxes(pattern);
  for (const std::string& figure : pattern.figures(profile)) {
    html += "<p class=\"soft\">" + htmlFromText(figure) + "</p>\n";
  }
  html += fmt::format(
      "<div class=\"notes\"><label for=\"notes-{0}\">Notes</label><input id=\"notes-{0}\" "
      "type=\"text\" autocomplete=\"off\"></div>\n",
      pattern.name);
  return html + wrongTable(section) + "</section>\n";
}

}  // namespace

std::string selftestPage(const std::vector<SelftestSection>& sections, const DisplayProfile& profile,
                         const std::string& version) {
  std::string html = pageBegin("Self-test of a volumetric display", {kSelftestStyle}) +
                     "<header>\n<h1>Self-test of a volumetric display</h1>\n";
  html +=
      "<p>Show one pattern after the other, compare what you see with the images, and tick what is right. Each "
      "pattern "
      "takes for granted that those before it are right: when one looks wrong, put it right before you go on, and then "
      "look at those before it again.</p>\n"
      "<p>A pattern is a volume, shown as any other: <code>ocelli present dark.svol --device usb</code>.</p>\n"
      "<p>The images show a display that is right, as the eye sees it from the viewing distance. Light that is "
      "inside "
      "shines through: you see near and far parts at once. A display with a flat screen is dark where you look along "
      "it; "
      "the images leave that out, so that the pattern is seen whole. The front is where the viewer stands, at +z; "
      "the "
      "right is his, at +x, where slice 0 begins; the screen turns clockwise seen from above.</p>\n";
  html += profileFacts(profile);
  html +=
      "<div class=\"session\"><label>Display <input type=\"text\" autocomplete=\"off\"></label><label>Tested by <input "
      "type=\"text\" autocomplete=\"off\"></label><label>On <input type=\"text\" autocomplete=\"off\"></label></div>\n"
      "<nav aria-label=\"Patterns\"><ol class=\"order\">\n";
  for (const SelftestSection& section : sections) {
    html +=
        fmt::format("<li><a href=\"#{}\">{}</a></li>\n", section.pattern->name, htmlFromText(section.pattern->title));
  }
  html += "</ol></nav>\n</header>\n<main>\n";
  for (size_t i = 0; i < sections.size(); ++i) {
    html += patternSection(sections[i], i + 1, profile);
  }
  return html + "</main>\n<footer><p class=\"soft\">Made by ocelli " + htmlFromText(version) +
         ". Ticks and notes stay on this page until you close it: print it to keep "
         "them.</p></footer>\n" +
         pageEnd();
}

}  // namespace ocelli
