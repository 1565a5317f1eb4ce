// SPDX-License-Identifier: Apache-2.0
// The JSON parser against RFC 8259: what is JSON is read, exactly, and what is not is refused.
#include "spec/language/document.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "spec/language/input_error.h"
#include "spec/language/json_text.h"

namespace {

using namespace toolcomp::spec;
using document::Kind;
using document::Node;
using document::parse_json;

std::string error(std::string_view text) {
  try {
    parse_json(text, "j");
  } catch (const InputError& e) {
    return e.what();
  }
  return "no error";
}

TEST(Json, ValuesKeepTextOrderAndPosition) {
  const Node root = parse_json(" {\"b\": [1.50, -0, 1e5],\n  \"a\": {\"x\": null, \"y\": true}, \"\": false}", "j");
  ASSERT_EQ(root.members.size(), 3U);
  EXPECT_EQ(root.members[0].name, "b");
  const Node& list = root.members[0].value;
  EXPECT_EQ(list.items[0].text, "1.50");
  EXPECT_EQ(list.items[1].text, "-0");
  EXPECT_EQ(list.items[2].text, "1e5");
  EXPECT_EQ(list.items[1].at.line, 1U);
  EXPECT_EQ(list.items[1].at.column, 15U);
  const Node* a = root.find("a");
  ASSERT_NE(a, nullptr);
  EXPECT_EQ(a->at.line, 2U);
  EXPECT_EQ(a->at.column, 8U);
  EXPECT_EQ(a->find("x")->kind, Kind::null);
  EXPECT_TRUE(a->find("y")->boolean);
  EXPECT_EQ(root.find("z"), nullptr);
  EXPECT_EQ(root.find("")->kind, Kind::boolean);
}

TEST(Json, Numbers) {
  for (const char* text : {"0", "-0", "12", "1.0", "-1.25e+10", "1E5", "0.0e-0", "123456789012345678901234567890"})
    EXPECT_EQ(parse_json(text, "j").text, text);
  for (const char* text : {"-", "+1", "01", "-01", "1.", ".5", "1e", "1e+", "0x1", "NaN", "Infinity", "1a"})
    EXPECT_NE(error(text), "no error") << text;
}

TEST(Json, Strings) {
  EXPECT_EQ(parse_json(R"("\"\\\/\b\f\n\r\t")", "j").text, "\"\\/\b\f\n\r\t");
  EXPECT_EQ(parse_json(R"("\u0041\u00e4\u20AC\ud83d\ude00")", "j").text, "A\xC3\xA4\xE2\x82\xAC\xF0\x9F\x98\x80");
  EXPECT_EQ(parse_json(R"("\u0000")", "j").text, std::string(1, '\0'));
  for (const char* text : {"\"", R"("\)", R"("\x")", R"("\u12")", R"("\u12G4")", R"("\ud83d")", R"("\ude00")",
                           R"("\ud83dA")", R"("\ud83d\u0041")", "\"\n\"", "\"\x01\"", "'a'"})
    EXPECT_NE(error(text), "no error") << text;
}

// RFC 3629, section 3 and 4.
TEST(Json, Utf8) {
  for (const char* text : {"\xC2\x80", "\xDF\xBF", "\xE0\xA0\x80", "\xED\x9F\xBF", "\xEE\x80\x80", "\xEF\xBF\xBF",
                           "\xF0\x90\x80\x80", "\xF4\x8F\xBF\xBF"})
    EXPECT_EQ(utf8_length(text), std::string_view(text).size());
  EXPECT_EQ(utf8_length(""), 0U);
  for (const char* text : {"\x80", "\xC1\xBF", "\xC2", "\xC2\x41", "\xE0\x9F\xBF", "\xED\xA0\x80", "\xE1\x80",
                           "\xF0\x8F\xBF\xBF", "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\xFF"}) {
    EXPECT_EQ(utf8_length(text), 0U);
    EXPECT_NE(error("\"" + std::string(text) + "\""), "no error");
  }
}

TEST(Json, ErrorsHaveTheirPosition) {
  EXPECT_EQ(error("[1,\n 2 3]"), "j:2:4: expected , or ] in an array");
  EXPECT_EQ(error("{\"a\" 1}"), "j:1:6: expected : after a name");
  EXPECT_EQ(error("{\"a\":1,}"), "j:1:8: expected a name in double quotes");
  EXPECT_EQ(error("{\"a\":1 \"b\":2}"), "j:1:8: expected , or } in an object");
  EXPECT_EQ(error("[1,]"), "j:1:4: expected a JSON value");
  EXPECT_EQ(error("tru"), "j:1:1: expected a JSON value");
  EXPECT_EQ(error("1 2"), "j:1:3: unexpected text after the end of the JSON value");
  EXPECT_EQ(error("{\"a\":1,\"b\":2,\"a\":3}"), "j:1:14: \"a\" is given twice");
  EXPECT_EQ(error("\"\xFF\""), "j:1:2: a string that is not UTF-8");
}

TEST(Json, NestingIsBounded) {
  const auto nested = [](int depth) {
    return std::string(static_cast<std::size_t>(depth), '[') + std::string(static_cast<std::size_t>(depth), ']');
  };
  EXPECT_EQ(error(nested(document::kMaxDepth + 1)), "no error");
  EXPECT_EQ(error(nested(document::kMaxDepth + 2)), "j:1:66: nested too deep");
  EXPECT_EQ(error(nested(1'000'000)), "j:1:66: nested too deep");
}

TEST(Json, WrittenStringsReadBack) {
  std::string all;
  for (int c = 0; c < 0x80; ++c) all += static_cast<char>(c);
  std::string text;
  append_json_string(text, all);
  EXPECT_EQ(parse_json(text, "j").text, all);
  std::string broken;
  append_json_string(broken, "a\xFF\xC3");
  EXPECT_EQ(broken, "\"a\xEF\xBF\xBD\xEF\xBF\xBD\"");
}

}  // namespace
