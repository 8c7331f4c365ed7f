#include "study/screen/form_drawing.h"

#include <fmt/format.h>

#include <algorithm>

#include "study/screen/question_drawing.h"
#include "study/screen/study_pieces.h"

namespace ocelli {
namespace {

// Lengths at 1280 x 800.
constexpr double kCardPadding = 18;
constexpr double kCardGap = 16;
constexpr double kRowGap = 10;     ///< between the rows of a matrix
constexpr double kMinLabel = 320;  ///< of a row that has its options beside it

/// "! please answer", once the subject wanted to go on; or that the item may stay open.
std::string noteOf(const StudyCanvas& canvas, const FormScreen& screen, size_t index) {
  const SubjectTexts& texts = canvas.texts();
  if (const std::optional<QuestionProblem> problem = problemOf(screen, index); problem && screen.missing) {
    return "! " + texts.say(problem->text, {{"least", problem->least}, {"most", problem->most}});
  }
  return screen.fieldOf(index).required ? "" : texts.say("form_optional");
}

/// Room that a question leaves for what may be said beside it.
double noteWidth(const StudyCanvas& canvas, const FormField& field) {
  const QuestionKind& kind = questionKind(field.kind);
  double width = canvas.widthOf("! " + canvas.texts().say("form_open"), StudyText::kSmall);
  if (!field.required) {
    width = std::max(width, canvas.widthOf(canvas.texts().say("form_optional"), StudyText::kSmall));
  }
  QuestionEntry wrong;
  wrong.typed = "-";
  if (const std::optional<QuestionProblem> problem = kind.problem(field, wrong)) {
    width = std::max(
        width,
        canvas.widthOf("! " + canvas.texts().say(problem->text, {{"least", problem->least}, {"most", problem->most}}),
                       StudyText::kSmall));
  }
  return width + canvas.length(20);
}

double noteHeight(const StudyCanvas& canvas, const FormScreen& screen, size_t index) {
  return noteOf(canvas, screen, index).empty() ? 0 : canvas.lineHeight(StudyText::kSmall);
}

/// An item where it stands in the form.
struct ItemPlace {
  QuestionLook look;
  std::optional<double> headTop{};  ///< of the question above the first row of a matrix
  PixelRect card;                   ///< from the top of the form
  double labelTop = 0;
  double labelWidth = 0;
  glm::dvec2 answer{0};
  QuestionPlaces places;
};

class FormLayout {
 public:
  FormLayout(const StudyCanvas& canvas, const FormScreen& screen, double width) {
    const double pad = canvas.length(kCardPadding);
    const double inner = width - 2 * pad;
    for (size_t i = 0; i < screen.items.size(); ++i) {
      const FormField& field = screen.fieldOf(i);
      const QuestionLook look = questionKind(field.kind).look(field, screen.entries[i]);
      const bool isRow = !field.rows.empty();
      std::optional<double> headTop;
      if (isRow && (i == 0 || screen.items[i - 1].field != screen.items[i].field)) {
        headTop = height_;
        height_ += canvas.heightOf(field.question, StudyText::kStrong, width) + canvas.length(8);
      }
      // The rows of a matrix have their options beside the label where there is room for both.
      const double beside = optionsWidth(canvas, look) + endsWidth(canvas, look);
      const bool isBeside = isRow && beside + canvas.length(kMinLabel) <= inner;
      const double labelWidth =
          isBeside ? inner - beside - canvas.length(kCardPadding) : inner - noteWidth(canvas, field);
      const double label =
          canvas.heightOf(screen.items[i].label, isRow ? StudyText::kBody : StudyText::kStrong, labelWidth);
      ItemPlace place{
          look, headTop, {}, height_ + pad, labelWidth, {}, {canvas, look, isBeside ? beside : inner, isRow}};
      double bottom = 0;
      if (isBeside) {
        const double words = label + noteHeight(canvas, screen, i);
        const double tall = std::max(words, place.places.height());
        place.labelTop += (tall - words) / 2;
        place.answer = {width - pad - beside, height_ + pad + (tall - place.places.height()) / 2};
        bottom = height_ + pad + tall;
      } else {
        place.answer = {pad, height_ + pad + label + canvas.length(8)};
        bottom = place.answer.y + place.places.height();
      }
      place.card = {0, height_, width, bottom + pad - height_};
      const bool nextIsRow = isRow && i + 1 < screen.items.size() && screen.items[i + 1].field == screen.items[i].field;
      height_ = place.card.bottom() + canvas.length(nextIsRow ? kRowGap : kCardGap);
      items_.push_back(std::move(place));
    }
    height_ -= items_.empty() ? 0 : canvas.length(kCardGap);
  }

  const std::vector<ItemPlace>& items() const { return items_; }
  double height() const { return height_; }

 private:
  static double endsWidth(const StudyCanvas& canvas, const QuestionLook& look) {
    double width = 0;
    for (const std::string& end : look.ends) {
      width += canvas.widthOf(end, StudyText::kBody) + canvas.length(18);
    }
    return width;
  }

  std::vector<ItemPlace> items_;
  double height_ = 0;
};

PixelRect shifted(const PixelRect& rect, double left, double top) {
  return {rect.left + left, rect.top + top, rect.width, rect.height};
}

/// What is wrong with an item, once the subject wanted to go on; or that it may stay open.
void drawNote(StudyCanvas& canvas, const FormScreen& screen, size_t index, const glm::dvec2& topRight, bool below) {
  const std::string text = noteOf(canvas, screen, index);
  const bool isWrong = screen.missing && problemOf(screen, index);
  canvas.writeLine({StudyText::kSmall, isWrong ? kStudyBad : kStudyTextDim, kStudyCard,
                    below ? TextAlign::kLeft : TextAlign::kRight},
                   topRight, text);
}

/// What was clicked.
std::optional<QuestionClick> drawItem(StudyCanvas& canvas, const FormScreen& screen, size_t index,
                                      const ItemPlace& place, double left, double top) {
  const FormField& field = screen.fieldOf(index);
  const bool isWrong = screen.missing && problemOf(screen, index);
  const PixelRect card = shifted(place.card, left, top);
  const double pad = canvas.length(kCardPadding);
  if (place.headTop) {
    canvas.write({StudyText::kStrong}, {card.left, top + *place.headTop, card.width, 0}, field.question);
  }
  canvas.fill(card, kStudyCard, canvas.length(12));
  if (isWrong) {
    canvas.outline(card, kStudyBad, canvas.length(2), canvas.length(12));
  }
  if (screen.focus == static_cast<int>(index)) {
    drawFocusRing(canvas, card, canvas.length(12));
  }
  const double below =
      canvas.write({field.rows.empty() ? StudyText::kStrong : StudyText::kBody, kStudyText, kStudyCard},
                   {card.left + pad, top + place.labelTop, place.labelWidth, 0}, screen.items[index].label);
  if (!noteOf(canvas, screen, index).empty()) {
    const bool isBeside = place.answer.x > pad;
    drawNote(canvas, screen, index,
             isBeside ? glm::dvec2(card.left + pad, below) : glm::dvec2(card.right() - pad, card.top + pad), isBeside);
  }
  return place.places.draw(canvas, place.look, fmt::format("item {}", index),
                           {left + place.answer.x, top + place.answer.y});
}

/// What the keys do here.
void drawKeys(StudyCanvas& canvas, const FormScreen& screen, const PixelRect& footer, double right) {
  struct Hint {
    const char* key;
    const char* text;
  };
  std::vector<Hint> hints{{"Enter", "hint_next"}};
  const auto focus = static_cast<size_t>(std::max(screen.focus, 0));
  if (focus < screen.items.size()) {
    const FormField& field = screen.fieldOf(focus);
    const QuestionLook look = questionKind(field.kind).look(field, screen.entries[focus]);
    if (look.severalOptions) {
      hints.push_back({"Space", "hint_switch"});
    }
    if (look.box) {
      hints.push_back({"Backspace", "hint_erase"});
    } else {
      hints.push_back({"Left/Right", look.severalOptions || look.track ? "hint_move" : "hint_choose"});
    }
  } else {
    hints.push_back({"Left/Right", "hint_choose"});
  }
  hints.push_back({"Up/Down", "hint_question"});
  const double gap = canvas.length(10);
  const double middle = footer.center().y;
  // What there is no room for, beside the key that ends the session, is left out.
  const double least = footer.left + unwellWidth(canvas) + canvas.length(24);
  double x = right;
  for (const Hint& hint : hints) {
    const std::string text = canvas.texts().say(hint.text);
    x -= canvas.widthOf(text, StudyText::kSmall) + gap + keyCapWidth(canvas, hint.key);
    if (x < least) {
      return;
    }
    const double at = drawKeyCap(canvas, x, middle, hint.key, kStudyCard) + gap;
    canvas.writeLine({StudyText::kSmall, kStudyTextDim, kStudyCard},
                     {at, middle - canvas.look().textPixels(StudyText::kSmall) / 2}, text);
    x -= 2 * gap;
  }
}

}  // namespace

std::optional<FormAction> drawForm(StudyCanvas& canvas, const FormScreen& screen, PageScroll& scroll) {
  const ProtocolForm& form = *screen.form;
  const PixelRect footer = drawFooter(canvas);
  const double width = std::min(canvas.width() - canvas.length(112), canvas.length(1040));
  const double left = std::round((canvas.width() - width) / 2);
  const FormLayout layout(canvas, screen, width);
  const double room = canvas.length(8);  // for the ring around a card
  // Short forms stand in the middle, long ones use all there is.
  const double head =
      canvas.heightOf(form.title, StudyText::kTitle, width) +
      (form.introduction.empty() ? 0 : canvas.heightOf(form.introduction, StudyText::kBody, width) + canvas.length(4)) +
      canvas.length(6) + 2 * room;
  const double spare = footer.top - canvas.length(14) - canvas.length(36) - head - layout.height();
  const double top = canvas.length(36) + std::round(std::max(0.0, spare) * 0.35);
  double y = canvas.write({StudyText::kTitle}, {left, top, width, 0}, form.title);
  if (!form.introduction.empty()) {
    y = canvas.write({StudyText::kBody, kStudyTextDim}, {left, y + canvas.length(4), width, 0}, form.introduction);
  }
  const PixelRect area{left - room, y + canvas.length(6), width + 2 * room, footer.top - y - canvas.length(14)};
  scroll.most = std::max(0.0, layout.height() + 2 * room - area.height);
  if (screen.focus >= 0 && static_cast<size_t>(screen.focus) < layout.items().size()) {
    const PixelRect& card = layout.items()[static_cast<size_t>(screen.focus)].card;
    scroll.offset = std::clamp(scroll.offset, card.bottom() + 2 * room - area.height, card.top);
  }
  scroll.move(0);

  std::optional<FormAction> action;
  canvas.beginClip(area);
  for (size_t i = 0; i < layout.items().size(); ++i) {
    if (const auto click = drawItem(canvas, screen, i, layout.items()[i], left, area.top + room - scroll.offset)) {
      action = FormAction{FormAction::Kind::kClick, static_cast<int>(i), *click};
    }
  }
  canvas.endClip();
  if (scroll.most > 0) {
    const double share = area.height / (area.height + scroll.most);
    const PixelRect bar{area.right() + canvas.length(8), area.top, canvas.length(8), area.height};
    canvas.fill(bar, kStudyField, canvas.length(4));
    canvas.fill(
        {bar.left, bar.top + bar.height * (1 - share) * scroll.offset / scroll.most, bar.width, bar.height * share},
        kStudyAccent, canvas.length(4));
  }

  const ButtonLook look{canvas.texts().say("form_go_on"), "Enter", true,
                        screen.focus == static_cast<int>(screen.items.size())};
  const double height = canvas.length(58);
  const double buttonLeft = footer.right() - canvas.length(36) - buttonWidth(canvas, look);
  const PixelRect place{buttonLeft, footer.center().y - height / 2, buttonWidth(canvas, look), height};
  if (drawButton(canvas, "go on", place, look)) {
    action = FormAction{FormAction::Kind::kGoOn};
  }
  drawKeys(canvas, screen, footer, buttonLeft - canvas.length(28));
  return action;
}

}  // namespace ocelli
