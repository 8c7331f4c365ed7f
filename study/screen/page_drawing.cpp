#include "study/screen/page_drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "study/screen/study_pieces.h"

namespace ocelli {
namespace {

constexpr double kTextWidth = 780;  // at 1280 x 800, as all lengths here: some 60 letters

double paragraphsHeight(const StudyCanvas& canvas, const std::vector<std::string>& paragraphs, StudyText text,
                        double width) {
  double height = 0;
  for (const std::string& paragraph : paragraphs) {
    height += canvas.heightOf(paragraph, text, width) + 0.6 * canvas.lineHeight(text);
  }
  return height;
}

/// The keys that show the rest of a long text.
void drawScrollHint(StudyCanvas& canvas, double left, double middle, GuiColor background) {
  const double gap = canvas.length(10);
  double x = drawKeyCap(canvas, left, middle, "PageUp", background);
  x = drawKeyCap(canvas, x + gap, middle, "PageDown", background);
  canvas.writeLine({StudyText::kSmall, kStudyTextDim, background},
                   {x + gap, middle - canvas.look().textPixels(StudyText::kSmall) / 2},
                   canvas.texts().say("show_rest"));
}

/// Paragraphs in a column; where they are too long for it, as far as they are scrolled, with a bar beside them.
void writeParagraphs(StudyCanvas& canvas, PixelRect column, const std::vector<std::string>& paragraphs,
                     GuiColor background, TextAlign align, PageScroll& scroll) {
  const bool fits = paragraphsHeight(canvas, paragraphs, StudyText::kBody, column.width) <= column.height + 1;
  const StudyText text = fits ? StudyText::kBody : StudyText::kSmall;
  const double height = paragraphsHeight(canvas, paragraphs, text, column.width);
  if (height > column.height + 1) {
    const double line = canvas.lineHeight(StudyText::kSmall) + canvas.length(14);
    column.height -= line;
    drawScrollHint(canvas, column.left, column.bottom() + line - canvas.lineHeight(StudyText::kSmall) / 2, background);
  }
  scroll.most = std::max(0.0, height - column.height - 1);
  scroll.move(0);
  canvas.beginClip(column);
  double y = column.top - scroll.offset;
  for (const std::string& paragraph : paragraphs) {
    y = canvas.write({text, kStudyText, background, align}, {column.left, y, column.width, 0}, paragraph) +
        0.6 * canvas.lineHeight(text);
  }
  canvas.endClip();
  if (scroll.most > 0) {
    const PixelRect bar{column.right() + canvas.length(14), column.top, canvas.length(8), column.height};
    canvas.fill(bar, kStudyField, canvas.length(4));
    const double share = column.height / (column.height + scroll.most);
    const double top = bar.top + (bar.height * (1 - share)) * scroll.offset / scroll.most;
    canvas.fill({bar.left, top, bar.width, bar.height * share}, kStudyAccent, canvas.length(4));
  }
}

PixelRect buttonPlace(const StudyCanvas& canvas, const PixelRect& footer, double right, const ButtonLook& look) {
  const double height = canvas.length(58);
  const double width = buttonWidth(canvas, look);
  return {right - width, footer.center().y - height / 2, width, height};
}

/// One segment a block, filled as far as the session is.
void drawProgress(StudyCanvas& canvas, const PixelRect& place, const SessionProgress& progress) {
  const double share = progress.trials > 0 ? static_cast<double>(progress.trialsDone) / progress.trials : 0;
  const double height = canvas.length(16);
  const PixelRect bar{place.left, place.top, place.width, height};
  canvas.fill(bar, kStudyField, height / 2);
  if (share > 0) {
    canvas.fill({bar.left, bar.top, std::max(height, bar.width * share), height}, kStudyAccent, height / 2);
  }
  const std::string done =
      canvas.texts().say(progress.blocks > 1 ? "progress_part" : "progress",
                         {{"done", fmt::format("{}", progress.trialsDone)},
                          {"total", fmt::format("{}", progress.trials)},
                          {"part", fmt::format("{}", std::min(progress.block + 1, progress.blocks))},
                          {"parts", fmt::format("{}", progress.blocks)}});
  canvas.writeLine({StudyText::kSmall, kStudyTextDim, kStudyBackground, TextAlign::kCenter},
                   {place.center().x, bar.bottom() + canvas.length(14)}, done);
}
double progressHeight(const StudyCanvas& canvas) {
  return canvas.length(30) + canvas.lineHeight(StudyText::kSmall) + canvas.length(24);
}

/// A ring that empties while one waits.
void drawCountdown(StudyCanvas& canvas, const glm::dvec2& center, double seconds) {
  const double radius = canvas.length(62);
  canvas.ring(center, radius, kStudyField, canvas.length(9));
  canvas.arc(center, radius, std::fmod(std::ceil(seconds), 60) / 60, kStudyAccent, canvas.length(9));
  const auto left = static_cast<int>(std::ceil(seconds));
  canvas.writeLine({StudyText::kTitle, kStudyText, kStudyBackground, TextAlign::kCenter},
                   {center.x, center.y - canvas.look().textPixels(StudyText::kTitle) / 2},
                   left < 60 ? fmt::format("{}", left) : fmt::format("{}:{:02}", left / 60, left % 60));
}
double countdownHeight(const StudyCanvas& canvas) {
  return canvas.length(2 * 62 + 44);
}

/// Text on the left, an image on the right.
void drawIllustrated(StudyCanvas& canvas, const PageScreen& page, const PixelRect& area, InstructionImages& images,
                     PageScroll& scroll) {
  const double margin = canvas.length(56);
  const double gap = canvas.length(40);
  const double inner = area.width - 2 * margin;
  const double imageWidth = std::floor((inner - gap) * 0.58);
  const PixelRect text{margin, area.top, inner - gap - imageWidth, area.height};
  double y = canvas.write({StudyText::kTitle}, text, page.title) + canvas.length(16);
  writeParagraphs(canvas, {text.left, y, text.width, text.bottom() - y}, page.paragraphs, kStudyBackground,
                  TextAlign::kLeft, scroll);
  const double imageHeight = std::floor(std::min(area.height, imageWidth * 0.72));
  images.draw(canvas, page,
              {std::round(text.right() + gap), std::round(area.center().y - imageHeight / 2), imageWidth, imageHeight});
}

/// All of it in one column, in the middle of the screen.
void drawCentered(StudyCanvas& canvas, const PageScreen& page, const PixelRect& area, PageScroll& scroll) {
  const double width = std::min(area.width - canvas.length(112), canvas.length(kTextWidth));
  const double left = area.center().x - width / 2;
  // Few words stand in the middle; more of them are read from the left.
  const bool few = page.paragraphs.size() <= 2 && page.title.size() < 40;
  const TextAlign align = few ? TextAlign::kCenter : TextAlign::kLeft;
  const double verdict = page.good ? canvas.length(150) : 0;
  const double countdown = page.waitSeconds > 0 ? countdownHeight(canvas) : 0;
  const double progress = page.progress ? progressHeight(canvas) : 0;
  const double title = canvas.heightOf(page.title, StudyText::kTitle, width) + canvas.length(18);
  const double text = paragraphsHeight(canvas, page.paragraphs, StudyText::kBody, width);
  const double others = verdict + countdown + progress + title;
  const double shownText = std::min(text, area.height - others);
  double y = area.top + std::max(0.0, (area.height - others - shownText) / 2);
  if (page.good) {
    drawVerdict(canvas, {area.center().x, y + canvas.length(58)}, canvas.length(54), *page.good);
    y += verdict;
  }
  y = canvas.write({StudyText::kTitle, kStudyText, kStudyBackground, align}, {left, y, width, 0}, page.title) +
      canvas.length(18);
  writeParagraphs(canvas, {left, y, width, shownText}, page.paragraphs, kStudyBackground, align, scroll);
  y += shownText;
  if (page.waitSeconds > 0) {
    drawCountdown(canvas, {area.center().x, y + canvas.length(20 + 62)}, page.waitSeconds);
    y += countdown;
  }
  if (page.progress) {
    drawProgress(canvas, {left, y + canvas.length(24), width, 0}, *page.progress);
  }
}

PixelRect areaAbove(const StudyCanvas& canvas, const PixelRect& footer) {
  const double top = canvas.length(56);
  return {0, top, static_cast<double>(canvas.width()), footer.top - canvas.length(32) - top};
}

}  // namespace

void PageScroll::move(double pixels) {
  offset = std::clamp(offset + pixels, 0.0, most);
}

PageClick drawPage(StudyCanvas& canvas, const PageScreen& page, InstructionImages& images, PageScroll& scroll) {
  const PixelRect footer = drawFooter(canvas);
  const PixelRect area = areaAbove(canvas, footer);
  if (page.image.empty() && !page.example) {
    drawCentered(canvas, page, area, scroll);
  } else {
    drawIllustrated(canvas, page, area, images, scroll);
  }
  PageClick click;
  double right = footer.right() - canvas.length(36);
  bool primary = true;
  for (const PageChoice& choice : pageChoices(page.action)) {
    const bool enabled = page.waitSeconds <= 0;
    const ButtonLook look{choice.label, choice.key ? std::string(nameOf(*choice.key)) : "", primary, primary && enabled,
                          enabled};
    const PixelRect place = buttonPlace(canvas, footer, right, look);
    if (drawButton(canvas, choice.label, place, look)) {
      click.key = choice.key;
      click.action = choice.key ? std::nullopt : std::optional(FormAction{FormAction::Kind::kGoOn});
    }
    right = place.left - canvas.length(24);
    primary = false;
  }
  return click;
}

PageClick drawConsent(StudyCanvas& canvas, const ConsentScreen& consent, PageScroll& scroll) {
  const PixelRect footer = drawFooter(canvas);
  const PixelRect area = areaAbove(canvas, footer);
  const double width = std::min(area.width - canvas.length(112), canvas.length(kTextWidth + 120));
  const double left = area.center().x - width / 2;
  const double y =
      canvas.write({StudyText::kTitle}, {left, area.top, width, 0}, consent.text.title) + canvas.length(12);
  const double pad = canvas.length(32);
  const PixelRect card{left, y, width, area.bottom() - y};
  canvas.fill(card, kStudyCard, canvas.length(12));
  writeParagraphs(canvas, {card.left + pad, card.top + pad, card.width - 2 * pad, card.height - 2 * pad},
                  consent.text.paragraphs, kStudyCard, TextAlign::kLeft, scroll);
  const ButtonLook agree{canvas.texts().say("agree"), "Enter", true, true};
  const ButtonLook decline{canvas.texts().say("do_not_agree"), "Escape", false};
  const PixelRect agreePlace = buttonPlace(canvas, footer, footer.right() - canvas.length(36), agree);
  const PixelRect declinePlace = buttonPlace(canvas, footer, agreePlace.left - canvas.length(24), decline);
  PageClick click;
  if (drawButton(canvas, "decline", declinePlace, decline)) {
    click.action = FormAction{FormAction::Kind::kDecline};
  }
  if (drawButton(canvas, "agree", agreePlace, agree)) {
    click.action = FormAction{FormAction::Kind::kGoOn};
  }
  return click;
}

void drawPause(StudyCanvas& canvas, const PauseScreen& pause) {
  const PixelRect footer = drawFooter(canvas);
  const PixelRect area = areaAbove(canvas, footer);
  const double width = std::min(area.width - canvas.length(112), canvas.length(kTextWidth));
  const double left = area.center().x - width / 2;
  const double text = canvas.heightOf(pause.reason, StudyText::kBody, width);
  double y = area.center().y - (canvas.length(130) + canvas.lineHeight(StudyText::kTitle) + text) / 2;
  const double radius = canvas.length(54);
  canvas.disc({area.center().x, y + radius}, radius, kStudyField);
  drawPauseSign(canvas, {area.center().x, y + radius}, radius * 0.8, kStudyText);
  y += canvas.length(130);
  y = canvas.write({StudyText::kTitle, kStudyText, kStudyBackground, TextAlign::kCenter}, {left, y, width, 0},
                   canvas.texts().say("paused")) +
      canvas.length(14);
  canvas.write({StudyText::kBody, kStudyText, kStudyBackground, TextAlign::kCenter}, {left, y, width, 0}, pause.reason);
}

}  // namespace ocelli
