#include "study/screen/protocol_texts.h"

#include <fmt/format.h>

#include <algorithm>

#include "oc_core/base/error.h"
#include "study/screen/bidi_text.h"
#include "study/screen/drawable_text.h"

namespace ocelli {
namespace {

void add(std::vector<ScreenText>& texts, const std::string& where, const std::string& text) {
  texts.push_back({where, text});
}

void add(std::vector<ScreenText>& texts, const std::string& where, const std::vector<std::string>& list) {
  for (size_t i = 0; i < list.size(); ++i) {
    add(texts, fmt::format("{} {}", where, i + 1), list[i]);
  }
}

void add(std::vector<ScreenText>& texts, const std::string& where, const ProtocolPage& page) {
  add(texts, where + ", \"title\"", page.title);
  add(texts, where + ", \"paragraphs\"", page.paragraphs);
}

void add(std::vector<ScreenText>& texts, const std::string& where, const std::vector<ProtocolPage>& pages) {
  for (size_t i = 0; i < pages.size(); ++i) {
    add(texts, fmt::format("{} {}", where, i + 1), pages[i]);
  }
}

void add(std::vector<ScreenText>& texts, const std::string& where, const ProtocolForm& form) {
  add(texts, where + ", \"title\"", form.title);
  add(texts, where + ", \"introduction\"", form.introduction);
  for (size_t i = 0; i < form.fields.size(); ++i) {
    const FormField& field = form.fields[i];
    const std::string here = fmt::format("{}, \"fields\" {}", where, i + 1);
    add(texts, here + ", \"question\"", field.question);
    add(texts, here + ", \"options\"", field.options);
    add(texts, here + ", \"ends\"", field.ends);
    add(texts, here + ", \"unit\"", field.unit);
    for (size_t row = 0; row < field.rows.size(); ++row) {
      add(texts, fmt::format("{}, \"rows\" {}", here, row + 1), field.rows[row].label);
    }
  }
}

void add(std::vector<ScreenText>& texts, const std::string& where, const std::vector<ProtocolForm>& forms) {
  for (size_t i = 0; i < forms.size(); ++i) {
    add(texts, fmt::format("{} {}", where, i + 1), forms[i]);
  }
}

}  // namespace

std::vector<ScreenText> textsOf(const Protocol& protocol) {
  std::vector<ScreenText> texts;
  if (protocol.consent) {
    add(texts, "\"consent\"", *protocol.consent);
  }
  if (protocol.demographics) {
    add(texts, "\"demographics\"", *protocol.demographics);
  }
  add(texts, "\"before\"", protocol.before);
  add(texts, "\"welcome\"", protocol.welcome);
  for (size_t i = 0; i < protocol.blocks.size(); ++i) {
    const ProtocolBlock& block = protocol.blocks[i];
    const std::string here = fmt::format("\"blocks\" {} ({})", i + 1, block.name);
    add(texts, here + ", \"title\"", block.title);
    add(texts, here + ", \"instructions\"", block.instructions);
    add(texts, here + ", \"after\"", block.after);
  }
  add(texts, "\"after\"", protocol.after);
  if (protocol.survey) {
    add(texts, "\"survey\"", *protocol.survey);
  }
  for (const auto& [id, text] : protocol.texts.catalogue().texts) {
    add(texts, fmt::format("the texts of the language \"{}\"", protocol.texts.catalogue().language), text);
  }
  return texts;
}

std::set<char32_t> glyphsOf(const Protocol& protocol) {
  std::set<char32_t> all;
  for (const ScreenText& each : textsOf(protocol)) {
    all.merge(shapedGlyphsOf(each.text));
  }
  return all;
}

void requireDrawable(const Protocol& protocol) {
  constexpr size_t kMaxFields = 8;
  const std::vector<UndrawableCharacters> undrawable = undrawableOf(glyphsOf(protocol));
  if (undrawable.empty()) {
    return;
  }
  std::string problems;
  for (const UndrawableCharacters& each : undrawable) {
    problems += fmt::format("{}: {}\n", namesOf(each.characters), each.reason);
  }
  std::string fields;
  size_t count = 0;
  for (const ScreenText& each : textsOf(protocol)) {
    const std::set<char32_t> glyphs = shapedGlyphsOf(each.text);
    const bool isOne = std::ranges::any_of(undrawable, [&](const UndrawableCharacters& some) {
      return std::ranges::any_of(some.characters, [&](char32_t character) { return glyphs.contains(character); });
    });
    if (isOne && ++count <= kMaxFields) {
      fields += "in " + each.where + "\n";
    }
  }
  if (count > kMaxFields) {
    fields += fmt::format("and in {} more\n", count - kMaxFields);
  }
  throw InputError(
      "the screens of this computer cannot show all characters of the texts",
      protocol.file.empty() ? protocol.name : protocol.file.string(),
      "write these texts without them; where a font is missing install it: fonts-droid-fallback has ideographs "
      "and kana, fonts-noto-cjk Hangul too",
      problems + fields);
}

}  // namespace ocelli
