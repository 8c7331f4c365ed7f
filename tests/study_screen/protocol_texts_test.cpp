#include "study/screen/protocol_texts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oc_core/base/error.h"
#include "tests/study_screen/font_folder.h"

namespace ocelli {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

Protocol protocolWith(const std::function<void(Protocol&)>& change) {
  static const Protocol plain = readProtocol(OCELLI_SOURCE_DIR "/protocols/short.json");
  Protocol protocol = plain;
  change(protocol);
  return protocol;
}

std::string refusalOf(const Protocol& protocol) {
  try {
    requireDrawable(protocol);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(ProtocolTexts, theProtocolsThatComeWithItCanBeShown) {
  for (const char* name : {"short", "rosen2010", "rosen2010-balanced"}) {
    EXPECT_EQ(refusalOf(readProtocol(std::string(OCELLI_SOURCE_DIR "/protocols/") + name + ".json")), "") << name;
  }
}

TEST(ProtocolTexts, ideographsAreShownWhereAFontHasThem) {
  const Protocol protocol =
      protocolWith([](Protocol& p) { p.consent->paragraphs[1] = "请阅读说明。\n同意请按回车键。"; });
  EXPECT_EQ(refusalOf(protocol), "") << "install fonts-droid-fallback";
  const test::FontsOf europe(test::ownFontFolder());
  EXPECT_THAT(refusalOf(protocol),
              AllOf(HasSubstr("short.json: "), HasSubstr("U+8BF7 请"), HasSubstr("no font that is installed has it"),
                    HasSubstr("in \"consent\", \"paragraphs\" 2"), HasSubstr("fonts-droid-fallback")));
}

TEST(ProtocolTexts, everyTextThatSubjectsReadIsLookedAt) {
  const std::string hindi = "नम";
  const std::pair<std::function<void(Protocol&)>, const char*> cases[] = {
      {[&](Protocol& p) { p.consent->title = hindi; }, "\"consent\", \"title\""},
      {[&](Protocol& p) { p.demographics->introduction = hindi; }, "\"demographics\", \"introduction\""},
      {[&](Protocol& p) { p.demographics->fields[1].question = hindi; },
       "\"demographics\", \"fields\" 2, \"question\""},
      {[&](Protocol& p) { p.demographics->fields[0].options[2] = hindi; },
       "\"demographics\", \"fields\" 1, \"options\" 3"},
      {[&](Protocol& p) {
         p.survey->fields[0].ends = {"no", hindi};
       },
       "\"survey\", \"fields\" 1, \"ends\" 2"},
      {[&](Protocol& p) {
         p.welcome.push_back({hindi, {"x"}});
       },
       "\"title\""},
      {[&](Protocol& p) { p.blocks[0].title = hindi; }, "\"blocks\" 1"},
      {[&](Protocol& p) {
         p.blocks[1].instructions.push_back({"x", {hindi}});
       },
       "\"paragraphs\" 1"}};
  for (const auto& [change, where] : cases) {
    EXPECT_THAT(refusalOf(protocolWith(change)), AllOf(HasSubstr(where), HasSubstr("U+0928"), HasSubstr("joined")));
  }
  for (const auto& [change, where] : std::vector<std::pair<std::function<void(Protocol&)>, const char*>>{
           {[&](Protocol& p) {
              p.after.push_back({"own after", hindi, "", {}});
            },
            "\"after\" 1, \"title\""},
           {[&](Protocol& p) {
              p.blocks[0].after.push_back({"own after", "x", "", {}});
              p.blocks[0].after[0].fields.push_back({"a", "?", {"x", "y"}});
              p.blocks[0].after[0].fields[0].rows.push_back({"row", hindi});
            },
            "\"fields\" 1, \"rows\" 1"}}) {
    EXPECT_THAT(refusalOf(protocolWith(change)), HasSubstr(where));
  }
  // Not shown to them.
  EXPECT_EQ(refusalOf(protocolWith([&](Protocol& p) { p.description = hindi; })), "");
}

TEST(ProtocolTexts, everyLanguageOfTheCatalogueCanBeShown) {
  for (const SubjectCatalogue& language : subjectCatalogues()) {
    const Protocol protocol = protocolWith([&](Protocol& p) { p.texts = SubjectTexts(language.language); });
    EXPECT_EQ(refusalOf(protocol), "") << language.language << ": install fonts-dejavu-core and fonts-droid-fallback";
  }
}

TEST(ProtocolTexts, saysOfEachCharacterWhy) {
  const std::string refusal =
      refusalOf(protocolWith([](Protocol& p) { p.consent->paragraphs[0] = "\U0001f600 cafe\u0301 \u200fabc"; }));
  EXPECT_THAT(refusal, AllOf(HasSubstr("U+1F600"), HasSubstr("emoji"), HasSubstr("U+0301: it joins the letter before"),
                             HasSubstr("U+200F: it is a control"), Not(HasSubstr("U+0061"))));
}

}  // namespace
}  // namespace ocelli
