#include "study/screen/form_drawing.h"

#include <fmt/format.h>

#include <algorithm>

#include "study/screen/study_pieces.h"

namespace ocelli {
namespace {

// Lengths at 1280 x 800.
constexpr double kCardPadding = 18;
constexpr double kCardGap = 16;
constexpr double kOptionGap = 12;

/// Where the options of a field stand, relative to the top left of its options.
struct OptionPlaces {
  std::vector<PixelRect> places;
  double height = 0;
};

double optionHeight(const StudyCanvas& canvas) {
  return canvas.look().textPixels(StudyText::kBody) + canvas.length(20);
}

/// Mark, label, and the digit that chooses it.
double optionWidth(const StudyCanvas& canvas, const std::string& label) {
  return canvas.length(14 + 20 + 10 + 18) + canvas.widthOf(label, StudyText::kBody);
}

/// In rows, from the left.
OptionPlaces placeOptions(const StudyCanvas& canvas, const FormField& field, double width) {
  OptionPlaces options;
  const double gap = canvas.length(kOptionGap);
  const double height = optionHeight(canvas);
  double x = 0;
  double y = 0;
  for (const std::string& label : field.options) {
    const double own = std::min(optionWidth(canvas, label), width);
    if (x > 0 && x + own > width) {
      x = 0;
      y += height + gap;
    }
    options.places.push_back({x, y, own, height});
    x += own + gap;
  }
  options.height = y + height;
  return options;
}

/// Options of a scale, side by side between what its ends mean; empty where they do not fit on a line.
OptionPlaces placeScale(const StudyCanvas& canvas, const FormField& field, double width) {
  const double gap = canvas.length(kOptionGap);
  double widest = 0;
  for (const std::string& label : field.options) {
    widest = std::max(widest, optionWidth(canvas, label));
  }
  const double left = canvas.widthOf(field.ends[0], StudyText::kBody) + canvas.length(18);
  const double right = canvas.widthOf(field.ends[1], StudyText::kBody) + canvas.length(18);
  const auto count = static_cast<double>(field.options.size());
  if (left + count * widest + (count - 1) * gap + right > width) {
    return {};
  }
  OptionPlaces options;
  for (size_t i = 0; i < field.options.size(); ++i) {
    options.places.push_back({left + static_cast<double>(i) * (widest + gap), 0, widest, optionHeight(canvas)});
  }
  options.height = optionHeight(canvas);
  return options;
}

bool drawOption(StudyCanvas& canvas, const std::string& name, const PixelRect& place, const std::string& label,
                bool chosen) {
  const Touch touch = canvas.touch(name, place);
  const double rounding = canvas.length(9);
  const GuiColor background = chosen ? kStudyAccentDeep : (touch.hovered ? kStudyFieldHovered : kStudyField);
  canvas.fill(place, background, rounding);
  canvas.outline(place, chosen ? kStudyAccent : kStudyLine, canvas.length(chosen ? 2 : 1.5), rounding);
  const glm::dvec2 mark(place.left + canvas.length(24), place.center().y);
  canvas.ring(mark, canvas.length(10), chosen ? kStudyAccent : kStudyTextDim, canvas.length(2));
  if (chosen) {
    canvas.disc(mark, canvas.length(5.5), kStudyAccent);
  }
  canvas.writeLine({StudyText::kBody, kStudyText, background},
                   {place.left + canvas.length(44), mark.y - canvas.look().textPixels(StudyText::kBody) / 2}, label);
  return touch.clicked;
}

/// A field where it stands in the form.
struct FieldPlace {
  PixelRect card;  ///< from the top of the form
  OptionPlaces options;
  bool isScale = false;
  double optionsTop = 0;
  double endsTop = 0;  ///< of a scale whose ends stand below it
};

class FormLayout {
 public:
  FormLayout(const StudyCanvas& canvas, const ProtocolForm& form, double width) {
    const double pad = canvas.length(kCardPadding);
    const double inner = width - 2 * pad;
    for (const FormField& field : form.fields) {
      FieldPlace place;
      const double question = canvas.heightOf(field.question, StudyText::kStrong, inner) + canvas.length(8);
      place.optionsTop = height_ + pad + question;
      if (field.ends.size() == 2) {
        place.options = placeScale(canvas, field, inner);
        place.isScale = !place.options.places.empty();
      }
      if (!place.isScale) {
        place.options = placeOptions(canvas, field, inner);
      }
      double bottom = place.optionsTop + place.options.height;
      if (field.ends.size() == 2 && !place.isScale) {
        place.endsTop = bottom + canvas.length(6);
        bottom = place.endsTop + canvas.lineHeight(StudyText::kSmall);
      }
      place.card = {0, height_, width, bottom + pad - height_};
      height_ = place.card.bottom() + canvas.length(kCardGap);
      fields_.push_back(std::move(place));
    }
    height_ -= fields_.empty() ? 0 : canvas.length(kCardGap);
  }

  const std::vector<FieldPlace>& fields() const { return fields_; }
  double height() const { return height_; }

 private:
  std::vector<FieldPlace> fields_;
  double height_ = 0;
};

PixelRect shifted(const PixelRect& rect, double left, double top) {
  return {rect.left + left, rect.top + top, rect.width, rect.height};
}

/// The option that was clicked.
std::optional<int> drawField(StudyCanvas& canvas, const FormScreen& screen, size_t index, const FieldPlace& place,
                             double left, double top) {
  const FormField& field = screen.form->fields[index];
  const bool focused = screen.focus == static_cast<int>(index);
  const bool isOpen = screen.missing && !screen.chosen[index];
  const PixelRect card = shifted(place.card, left, top);
  const double pad = canvas.length(kCardPadding);
  canvas.fill(card, kStudyCard, canvas.length(12));
  if (isOpen) {
    canvas.outline(card, kStudyBad, canvas.length(2), canvas.length(12));
  }
  if (focused) {
    drawFocusRing(canvas, card, canvas.length(12));
  }
  canvas.write({StudyText::kStrong, kStudyText, kStudyCard}, {card.left + pad, card.top + pad, card.width - 2 * pad, 0},
               field.question);
  if (isOpen) {
    const std::string text = "! please answer";
    canvas.writeLine({StudyText::kSmall, kStudyBad, kStudyCard, TextAlign::kRight},
                     {card.right() - pad, card.top + pad}, text);
  }
  std::optional<int> clicked;
  for (size_t i = 0; i < field.options.size(); ++i) {
    const PixelRect option = shifted(place.options.places[i], card.left + pad, top + place.optionsTop);
    const bool chosen = screen.chosen[index] == static_cast<int>(i);
    if (drawOption(canvas, fmt::format("{} {}", index, i), option, field.options[i], chosen)) {
      clicked = static_cast<int>(i);
    }
  }
  if (field.ends.size() == 2) {
    const double right = card.left + pad + place.options.places.back().right() + canvas.length(18);
    const double y =
        place.isScale ? top + place.optionsTop + (optionHeight(canvas) - canvas.look().textPixels(StudyText::kBody)) / 2
                      : top + place.endsTop;
    const StudyText text = place.isScale ? StudyText::kBody : StudyText::kSmall;
    canvas.writeLine({text, kStudyTextDim, kStudyCard}, {card.left + pad, y}, field.ends[0]);
    if (place.isScale) {
      canvas.writeLine({text, kStudyTextDim, kStudyCard}, {right, y}, field.ends[1]);
    } else {
      canvas.writeLine({text, kStudyTextDim, kStudyCard, TextAlign::kRight}, {card.right() - pad, y}, field.ends[1]);
    }
  }
  return clicked;
}

/// What the keys do here.
void drawKeys(StudyCanvas& canvas, const PixelRect& footer, double right) {
  struct Hint {
    const char* key;
    const char* text;
  };
  const double gap = canvas.length(10);
  const double middle = footer.center().y;
  double x = right;
  for (const Hint& hint : {Hint{"Enter", "next"}, Hint{"Left/Right", "choose"}, Hint{"Up/Down", "question"}}) {
    x -= canvas.widthOf(hint.text, StudyText::kSmall) + gap + keyCapWidth(canvas, hint.key);
    const double text = drawKeyCap(canvas, x, middle, hint.key, kStudyCard) + gap;
    canvas.writeLine({StudyText::kSmall, kStudyTextDim, kStudyCard},
                     {text, middle - canvas.look().textPixels(StudyText::kSmall) / 2}, hint.text);
    x -= 2 * gap;
  }
}

}  // namespace

std::optional<FormAction> drawForm(StudyCanvas& canvas, const FormScreen& screen, PageScroll& scroll) {
  const ProtocolForm& form = *screen.form;
  const PixelRect footer = drawFooter(canvas);
  const double width = std::min(canvas.width() - canvas.length(112), canvas.length(1040));
  const double left = std::round((canvas.width() - width) / 2);
  const FormLayout layout(canvas, form, width);
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
  if (screen.focus >= 0 && static_cast<size_t>(screen.focus) < layout.fields().size()) {
    const PixelRect& card = layout.fields()[static_cast<size_t>(screen.focus)].card;
    scroll.offset = std::clamp(scroll.offset, card.bottom() + 2 * room - area.height, card.top);
  }
  scroll.move(0);

  std::optional<FormAction> action;
  canvas.beginClip(area);
  for (size_t i = 0; i < layout.fields().size(); ++i) {
    if (const auto option = drawField(canvas, screen, i, layout.fields()[i], left, area.top + room - scroll.offset)) {
      action = FormAction{FormAction::Kind::kChoose, static_cast<int>(i), *option};
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

  const ButtonLook look{"Go on", "Enter", true, screen.focus == static_cast<int>(form.fields.size())};
  const double height = canvas.length(58);
  const double buttonLeft = footer.right() - canvas.length(36) - buttonWidth(canvas, look);
  const PixelRect place{buttonLeft, footer.center().y - height / 2, buttonWidth(canvas, look), height};
  if (drawButton(canvas, "go on", place, look)) {
    action = FormAction{FormAction::Kind::kGoOn};
  }
  drawKeys(canvas, footer, buttonLeft - canvas.length(28));
  return action;
}

}  // namespace ocelli
