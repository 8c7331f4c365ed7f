// The kinds of questions that forms ask, a row each: what a protocol says of one, how it is filled in by keys and by
// the mouse, what is seen of it, and what is stored. Nothing outside of a kind's own file knows its name: forms,
// screens, simulated subjects, exports and analyses ask its row.
//
// Recipe for a new kind, two places and a line:
//   1. study/outline/NAME_question.cpp: a function that makes the row.
//   2. study/outline/question_kinds.cpp: that function, at the end of the table.
//   3. The name of the file in the CMakeLists.txt beside it.
// Then its fields in protocols/protocol.schema.json and a row of the table in docs/protocols.md. It is an example in
// tests/study_outline/question_examples.h, with which the tests of the contract run. A screen draws what QuestionLook
// can say: options, a track, a box; a kind that needs another piece adds it there and in study/screen/form_drawing.cpp.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "oc_core/base/input_event.h"
#include "oc_core/base/random.h"
#include "study/outline/form_field.h"

namespace ocelli {

/// What an answer is, for whoever tabulates it.
enum class QuestionValue : uint8_t {
  kOption,   ///< one of storedOptions()
  kOptions,  ///< some of them: a JSON array of texts, in the order of the protocol
  kText,     ///< in the subject's own words
  kNumber,   ///< a decimal number, with "." and without groups of digits
};
inline constexpr std::array kQuestionValues = {QuestionValue::kOption, QuestionValue::kOptions, QuestionValue::kText,
                                               QuestionValue::kNumber};
/// "option", "options", "text", "number".
const char* nameOf(QuestionValue value);

/// What has been filled in of one item of a question. Nothing is chosen, marked or typed at first.
struct QuestionEntry {
  std::vector<int> chosen{};       ///< options, ascending
  int cursor = 0;                  ///< the option that keys act on, where several can be chosen
  std::optional<double> number{};  ///< that is marked on a track
  std::string typed{};             ///< UTF-8

  bool isEmpty() const { return chosen.empty() && !number && typed.empty(); }
  bool operator==(const QuestionEntry&) const = default;
};

/// What is seen of an entry; empty pieces are not drawn.
struct QuestionLook {
  struct Option {
    std::string label;
    bool chosen = false;
    bool underCursor = false;
  };
  std::vector<Option> options{};
  bool severalOptions = false;      ///< square marks with ticks in place of round ones
  std::vector<std::string> ends{};  ///< of the options or the track; empty, or two
  struct Track {
    std::optional<double> share{};  ///< of the mark, from 0 to 1; nothing where there is none
    int steps = 1;                  ///< ticks are drawn between so many, where they are few
  };
  std::optional<Track> track{};
  struct Box {
    std::string text{};
    std::string unit{};
    bool isWide = false;  ///< for sentences
  };
  std::optional<Box> box{};
};

/// A key, or a character that is typed.
struct QuestionStroke {
  std::optional<Key> key{};
  char32_t character = 0;
};

/// A click: on an option, or on a track, at a share of it from its lower end.
struct QuestionClick {
  int option = -1;
  double share = 0;
};

/// What keeps an entry from being an answer: the id of a text (SubjectTexts) with the placeholders {least} and {most}.
struct QuestionProblem {
  const char* text = nullptr;
  std::string least{};
  std::string most{};
};

/// What nearly all functions of a row need.
struct QuestionKind {
  std::string name;         ///< in protocols; it stays for ever
  std::string description;  ///< for people: "one of several options"
  QuestionValue value = QuestionValue::kOption;

  /// The fields of its own. An analysis is lenient (ProtocolReading). Throws InputError naming the field.
  void (*read)(JsonFields& fields, FormField& field, ProtocolReading reading, const std::string& language) = nullptr;

  /// A key other than those that go from question to question (up, down, Tab, Enter). Where screens are laid out from
  /// the right to the left, kLeft and kRight have been exchanged: kRight goes on to the next option, or up.
  void (*press)(const FormField& field, QuestionEntry& entry, Key key) = nullptr;
  /// A character was typed. Kinds that are not typed ignore it.
  void (*type)(const FormField& field, QuestionEntry& entry, char32_t character) = nullptr;
  void (*click)(const FormField& field, QuestionEntry& entry, const QuestionClick& click) = nullptr;

  /// As the database holds it; nothing where the entry is empty or has a problem.
  std::optional<std::string> (*stored)(const FormField& field, const QuestionEntry& entry) = nullptr;
  /// Of an entry that is not empty.
  std::optional<QuestionProblem> (*problem)(const FormField& field, const QuestionEntry& entry) = nullptr;
  QuestionLook (*look)(const FormField& field, const QuestionEntry& entry) = nullptr;

  /// Any answer, for simulated subjects.
  QuestionEntry (*atRandom)(const FormField& field, Random& random) = nullptr;
  /// The next stroke on the way from an entry to another that the keys can reach; nothing where both are stored alike.
  std::optional<QuestionStroke> (*towards)(const FormField& field, const QuestionEntry& entry,
                                           const QuestionEntry& target) = nullptr;
};

/// In the order of the documentation.
const std::vector<QuestionKind>& questionKinds();
/// The row of a field's kind. A kind that this program does not know, which only an analysis can meet, is a text.
const QuestionKind& questionKind(std::string_view name);
bool isQuestionKind(std::string_view name);

/// One thing that is filled in and stored: a question, or a row of a matrix.
struct QuestionItem {
  int field = 0;      ///< of the form
  std::string name;   ///< of the answer in the database: that of the field, or "FIELD_ROW"
  std::string label;  ///< the question, or what the row says
};
std::vector<QuestionItem> itemsOf(const std::vector<FormField>& fields);

/// What is stored for each option: `values`, or the options themselves.
const std::vector<std::string>& storedOptions(const FormField& field);

}  // namespace ocelli
