#include "analysis/dataset/form_item.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "analysis/dataset/protocol_facts.h"
#include "oc_core/base/number_text.h"

namespace ocelli {
namespace {

/// First number and step of options that are numbers at equal distances.
struct EvenNumbers {
  double first = 1;
  double step = 1;
};

std::optional<EvenNumbers> evenNumbers(const std::vector<std::string>& options) {
  std::vector<double> numbers;
  for (const std::string& option : options) {
    if (const std::optional<double> number = numberOfAnswer(option)) {
      numbers.push_back(*number);
    }
  }
  if (numbers.size() != options.size() || numbers.size() < 2) {
    return std::nullopt;
  }
  const EvenNumbers even{numbers[0], numbers[1] - numbers[0]};
  for (size_t i = 0; i < numbers.size(); ++i) {
    // Of decimal fractions, such as 0.1, to rounding.
    if (even.step == 0 || std::abs(numbers[i] - even.first - even.step * static_cast<double>(i)) >
                              1e-9 * std::max(1.0, std::abs(numbers[i]))) {
      return std::nullopt;
    }
  }
  return even;
}

std::vector<std::string> wordsOf(const std::string& text) {
  std::vector<std::string> words(1);
  for (const char c : text) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
      words.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    } else if (!words.back().empty()) {
      words.emplace_back();
    }
  }
  return words;
}

bool hasAnyOf(const std::string& text, const std::vector<std::string>& names) {
  const std::vector<std::string> words = wordsOf(text);
  return std::any_of(words.begin(), words.end(), [&](const std::string& word) {
    return std::find(names.begin(), names.end(), word) != names.end();
  });
}

/// The one view that a text names.
std::optional<TrialView> viewInWords(const std::string& text, const ViewConditions& conditions) {
  const bool reference = hasAnyOf(text, conditions.of(TrialView::kReference).wordsOfEnds);
  const bool other = hasAnyOf(text, conditions.of(TrialView::kOther).wordsOfEnds);
  return reference == other ? std::nullopt : std::optional(other ? TrialView::kOther : TrialView::kReference);
}

}  // namespace

std::optional<double> numberOfAnswer(const std::string& answer) {
  return numberFromText<double>(answer);
}

std::vector<std::string> choicesOfAnswer(const std::string& answer) {
  const nlohmann::json list = nlohmann::json::parse(answer, nullptr, false);
  std::vector<std::string> choices;
  for (size_t i = 0; list.is_array() && i < list.size(); ++i) {
    if (list[i].is_string()) {
      choices.push_back(list[i].get<std::string>());
    }
  }
  return choices;
}

bool FormItem::isScale() const {
  return options.size() >= 2 && (ends.size() == 2 || lastFavors || evenNumbers(options));
}

std::optional<int> FormItem::placeOf(const std::string& answer) const {
  const auto found = std::find(options.begin(), options.end(), answer);
  return found == options.end() ? std::nullopt : std::optional<int>(static_cast<int>(found - options.begin()) + 1);
}

double FormItem::numberAt(double place) const {
  const std::optional<EvenNumbers> even = evenNumbers(options);
  return even ? even->first + even->step * (place - 1) : place;
}

std::string FormItem::scaleText() const {
  const bool numbers = evenNumbers(options).has_value();
  const auto end = [&](const std::string& option, int place, size_t which) {
    const std::string shown = numbers ? option : fmt::format("{}", place);
    const std::string meaning = ends.size() == 2 ? ends[which] : numbers ? "" : option;
    return meaning.empty() ? shown : fmt::format("{} ({})", shown, meaning);
  };
  return options.empty() ? std::string(value == QuestionValue::kNumber    ? "a number"
                                       : value == QuestionValue::kOptions ? "several choices"
                                                                          : "any text")
                         : fmt::format("{} to {}", end(options.front(), 1, 0), end(options.back(), steps(), 1));
}

std::optional<TrialView> viewFavoredByLastEnd(const std::vector<std::string>& ends, const ViewConditions& conditions) {
  if (ends.size() != 2 || !conditions.isPair()) {
    return std::nullopt;
  }
  const std::optional<TrialView> first = viewInWords(ends[0], conditions);
  const std::optional<TrialView> last = viewInWords(ends[1], conditions);
  return first && last && *first != *last ? last : std::nullopt;
}

FormItems::FormItems(const Dataset& data) {
  for (const DataSource& source : data.sources) {
    bySource_.push_back(source.protocolText.empty() ? std::vector<FormItem>{}
                                                    : protocolFacts(source.protocolText, source.path).items);
  }
}

FormItem FormItems::of(const FormAnswer& answer) const {
  const auto source = static_cast<size_t>(answer.source);
  if (source < bySource_.size()) {
    for (const FormItem& item : bySource_[source]) {
      if (item.form == answer.form && item.name == answer.field) {
        return item;
      }
    }
  }
  return {answer.form, answer.field};
}

std::vector<ItemAnswers> answersToForm(const Dataset& data, const std::string& form) {
  const FormItems known(data);
  std::vector<ItemAnswers> all;
  for (const std::vector<FormItem>& items : known.bySource()) {
    for (const FormItem& item : items) {
      if (item.form == form &&
          std::none_of(all.begin(), all.end(), [&](const ItemAnswers& each) { return each.item == item; })) {
        all.push_back({item});
      }
    }
  }
  const size_t ofProtocols = all.size();
  // The last row of each subject, by item.
  std::vector<std::map<std::string, const FormAnswer*>> last(all.size());
  for (const FormAnswer& answer : data.answers) {
    if (answer.form != form) {
      continue;
    }
    const FormItem item = known.of(answer);
    if (answer.answer.empty() && item.mayStayOpen) {
      continue;
    }
    auto found = std::find_if(all.begin(), all.end(), [&](const ItemAnswers& each) { return each.item == item; });
    if (found == all.end()) {
      found = all.insert(all.end(), {item});
      last.emplace_back();
    }
    const FormAnswer*& row = last[static_cast<size_t>(found - all.begin())][answer.subject];
    row = row == nullptr || row->session <= answer.session ? &answer : row;
  }
  for (size_t i = 0; i < all.size(); ++i) {
    for (const auto& [subject, row] : last[i]) {
      const FormItem& item = all[i].item;
      if ((item.value == QuestionValue::kNumber && !numberOfAnswer(row->answer)) ||
          (item.value == QuestionValue::kOptions && choicesOfAnswer(row->answer).empty())) {
        all[i].notOptions.push_back(row);
        continue;
      }
      const std::optional<int> place = all[i].item.placeOf(row->answer);
      if (place || all[i].item.options.empty()) {
        all[i].answers.push_back({row, place.value_or(0)});
      } else {
        all[i].notOptions.push_back(row);
      }
    }
  }
  std::sort(all.begin() + static_cast<std::ptrdiff_t>(ofProtocols), all.end(),
            [](const ItemAnswers& a, const ItemAnswers& b) { return a.item.name < b.item.name; });
  std::erase_if(all, [](const ItemAnswers& each) { return each.answers.empty() && each.notOptions.empty(); });
  return all;
}

}  // namespace ocelli
