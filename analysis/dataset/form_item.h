// Questions of forms with their scales, as the protocol has them, and where answers stand on these.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/dataset/dataset.h"

namespace ocelli {

/// A question. Its options in order are its scale where they are numbers or have ends, or where the ends speak for the
/// views; else they are choices without an order. A question without options takes any text, or is not in the protocol.
struct FormItem {
  std::string form;
  std::string name;                        ///< "easier_find": as databases and tables write it
  std::string question{};                  ///< as subjects read it; empty where no protocol has it
  std::vector<std::string> options{};      ///< in the order of the protocol
  std::vector<std::string> ends{};         ///< what the first and the last option mean; empty, or two
  std::optional<TrialView> lastFavors{};   ///< the view that the last option speaks for, of a scale that compares two
  bool favorsFromWords = false;            ///< taken from the words of `ends`, as the protocol has no "favors"
  std::optional<TrialView> firstFavors{};  ///< the view that the first option speaks for

  bool isInProtocol() const { return !question.empty(); }
  bool isScale() const;
  bool comparesViews() const { return lastFavors.has_value(); }
  /// The question, or the name where there is none.
  const std::string& label() const { return question.empty() ? name : question; }

  int steps() const { return static_cast<int>(options.size()); }
  /// Of the options, from 1; nullopt for an answer that is not an option.
  std::optional<int> placeOf(const std::string& answer) const;
  /// Of the scale, as a place; between two options where their number is even.
  double middle() const { return (steps() + 1) / 2.0; }
  /// The number at a place between 1 and steps(): of options that are numbers at equal distances theirs, else the
  /// place.
  double numberAt(double place) const;
  /// "1 (plain view easier) to 7 (bent view easier)".
  std::string scaleText() const;

  bool operator==(const FormItem&) const = default;
};

/// By the words of the ends of a scale, where one has a word of one condition and the other of the other. For protocols
/// from before the field "favors".
std::optional<TrialView> viewFavoredByLastEnd(const std::vector<std::string>& ends, const ViewConditions& conditions);

/// The questions of all sources of a dataset.
class FormItems {
 public:
  explicit FormItems(const Dataset& data);

  /// The question of an answer; one without text and options where the protocol of its source does not have it.
  FormItem of(const FormAnswer& answer) const;
  /// Of the forms, by source in the order of its protocol.
  const std::vector<std::vector<FormItem>>& bySource() const { return bySource_; }

 private:
  std::vector<std::vector<FormItem>> bySource_{};
};

/// The last answer of each subject to a question, as some are asked in every session.
struct ItemAnswers {
  struct Answer {
    const FormAnswer* row = nullptr;
    int place = 0;  ///< FormItem::placeOf(); 0 where the item has no options
  };

  FormItem item;
  std::vector<Answer> answers{};                ///< by subject
  std::vector<const FormAnswer*> notOptions{};  ///< last answers that are none of the item's options
};

/// Of all questions with answers: those of the protocol in its order, then others by name. Where sources have different
/// questions of one name they stand apart. Pointers are into `data`.
std::vector<ItemAnswers> answersToForm(const Dataset& data, const std::string& form);

}  // namespace ocelli
