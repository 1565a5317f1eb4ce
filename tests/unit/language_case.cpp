// SPDX-License-Identifier: Apache-2.0
// Cases and replies: everything survives a round trip, everything malformed is refused with its position.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

#include "spec/language/case_format.h"
#include "spec/language/event_format.h"
#include "spec/language/input_error.h"
#include "spec/language/number_text.h"

namespace {

using namespace toolcomp::spec;
using namespace std::string_view_literals;

std::string error(std::string_view text) {
  try {
    read_case(text, "c.json");
  } catch (const InputError& e) {
    return e.what();
  }
  return "no error";
}

// A case around one expected event.
std::string with_event(std::string_view event) {
  return R"({"case":1,"setup":{},"program":"","expect":[)" + std::string(event) + "]}";
}
std::string event_error(std::string_view event) {
  const std::string message = error(with_event(event));
  const std::size_t start = message.find(": ");
  return start == std::string::npos ? message : message.substr(start + 2);
}

constexpr std::string_view kCase = R"json({
  "case": 1,
  "id": "fanuc.tool-length-offset.0001",
  "section": "fanuc/tool-length-offset",
  "comment": "an \"example\"",
  "flags": ["near-90","tie"],
  "dialect": "fanuc",
  "setup": {"control":"fanuc","units":"mm","axes":["X","Y","Z","B"],"increment":"IS-B","cutter_compensation":"C","block_skip":false,"offsets":{"memory":"A","count":400,"H":{"1":"-4.0"}}},
  "program": "G43 Z1. H1\nG02 X10. R5.\n(ä)",
  "samples": 4,
  "source": {"generator":"hand","version":"1.0.0","seed":"17"},
  "expect": [
    {"kind":"move","line":1,"n":30,"type":"rapid","cause":"start-up","programmed":{"X":0,"Y":-1.50,"Z":1},"point":{"X":0,"Y":0,"Z":1},"axes":{"X":0,"Y":0,"Z":-3,"B":90},"machine":{"Z":-103},"tool_axis":[0,{"v":"0.6","r":"1e-15","q":"3/5"},{"v":"0.8","r":"0"}],"feed":1000},
    {"kind":"move","line":2,"type":"arc","cause":"programmed","programmed":{"X":10},"center":{"X":5,"Y":0},"plane":"XY","direction":"cw","sweep":180,"radius":[5,5.5],"feed":"1."},
    {"kind":"sample","line":2,"t":"1/4","point":{"X":1},"axes":{"X":1},"tool_axis":[0,0,1]},
    {"kind":"setting","name":"H1.wear","value":{"v":"-0.25","q":"-1/4"},"line":3},
    {"kind":"warning","number":"PS9999","line":3},
    {"kind":"undecided","line":4,"clause":"some.clause","permitted":["positive","tie"]},
    {"kind":"alarm","number":"TYPE_C_FORMAT","line":4,"n":7}
  ]
}
)json";

TEST(Case, EveryKeyIsRead) {
  const Case c = read_case(kCase, "c.json");
  EXPECT_EQ(c.id, "fanuc.tool-length-offset.0001");
  EXPECT_EQ(c.section, "fanuc/tool-length-offset");
  EXPECT_EQ(c.comment, "an \"example\"");
  EXPECT_EQ(c.flags, (std::vector<std::string>{"near-90", "tie"}));
  EXPECT_EQ(c.setup.h.at(1).geometry, (Decimal{40, 1, true, true}));
  EXPECT_EQ(c.program, "G43 Z1. H1\nG02 X10. R5.\n(\xC3\xA4)");
  EXPECT_EQ(c.samples, 4U);
  EXPECT_EQ(c.source, (CaseSource{"hand", "1.0.0", "17"}));
  ASSERT_EQ(c.expect.size(), 7U);

  const TextEvent& move = c.expect[0];
  EXPECT_EQ(move.kind, EventKind::move);
  EXPECT_EQ(move.line, 1U);
  EXPECT_EQ(move.n, 30U);
  EXPECT_EQ(move.type, MoveType::rapid);
  EXPECT_EQ(move.cause, Cause::start_up);
  EXPECT_EQ(move.programmed[1].v, "-1.50");
  EXPECT_EQ(move.axes[3].v, "90");
  EXPECT_EQ(move.machine.present, 1U << 2U);
  EXPECT_EQ((*move.tool_axis)[1], (NumberText{"0.6", "1e-15", "3/5"}));
  EXPECT_EQ(move.feed->v, "1000");
  EXPECT_FALSE(move.arc);

  const TextEvent& arc = c.expect[1];
  ASSERT_TRUE(arc.arc);
  EXPECT_EQ(arc.arc->center[0].v, "5");
  EXPECT_EQ(arc.arc->plane, Plane::xy);
  EXPECT_EQ(arc.arc->direction, ArcDirection::cw);
  EXPECT_EQ(arc.arc->sweep->v, "180");
  EXPECT_EQ(arc.arc->radius->second.v, "5.5");

  EXPECT_EQ(c.expect[2].t_numerator, 1U);
  EXPECT_EQ(c.expect[2].t_denominator, 4U);
  EXPECT_EQ(c.expect[3].setting.view(), "H1.wear");
  EXPECT_EQ(c.expect[3].value, (NumberText{"-0.25", "", "-1/4"}));
  EXPECT_EQ(c.expect[4].kind, EventKind::warning);
  EXPECT_EQ(c.expect[5].number.view(), "some.clause");
  EXPECT_EQ(c.expect[5].permitted, (PermittedOutcomes{true, false, true}));
  EXPECT_EQ(c.expect[6].number.view(), "TYPE_C_FORMAT");
  EXPECT_EQ(c.expect[6].n, 7U);
}

TEST(Case, WritersGiveBackTheSameText) {
  const Case c = read_case(kCase, "c.json");
  EXPECT_EQ(write_case(c), kCase);
  const std::string line = write_case_line(c);
  EXPECT_EQ(line.find('\n'), std::string::npos);
  EXPECT_EQ(write_case(read_case(line, "line")), kCase);
}

TEST(Case, EmptyPartsAreLeftOut) {
  Case c;
  c.program = "G0";
  EXPECT_EQ(write_case_line(c).find("expect"), std::string::npos);
  EXPECT_FALSE(read_case(write_case_line(c), "c").has_expect);
  c.has_expect = true;
  EXPECT_TRUE(write_case_line(c).ends_with(",\"expect\":[]}"));
  EXPECT_TRUE(read_case(write_case_line(c), "c").has_expect);
}

TEST(Case, ProgramsKeepEveryByteJsonCanCarry) {
  Case c;
  c.program = "\0\x01\"\\/\b\f\n\r\t\x7F (\xC3\xA4\xE2\x82\xAC\xF0\x9F\x98\x80)"sv;
  EXPECT_EQ(read_case(write_case(c), "c").program, c.program);
  c.program = "(\xE4)";  // Latin-1: JSON has no byte for it
  EXPECT_EQ(read_case(write_case(c), "c").program, "(\xEF\xBF\xBD)");
}

TEST(Case, ErrorsHaveTheirPosition) {
  EXPECT_EQ(error("{}"), "c.json:1:1: case: without case");
  EXPECT_EQ(error("{\"case\":2}"), "c.json:1:9: case: expected an integer from 1 to 1, found \"2\"");
  EXPECT_EQ(error("{\"case\":1}"), "c.json:1:1: case: without setup");
  EXPECT_EQ(error("{\"case\":1,\"setup\":{}}"), "c.json:1:1: case: without program");
  EXPECT_EQ(error("{\"case\":1,\n \"setup\":{\"unit\":1}}").substr(0, 40),
            "c.json:2:11: setup: unknown key \"unit\"; ");
  EXPECT_EQ(error("{\"case\":1,\"note\":1}").substr(0, 39), "c.json:1:11: case: unknown key \"note\"; ");
  EXPECT_EQ(error("{\"case\":1,\"program\":7,\"setup\":{}}"),
            "c.json:1:21: program: expected a string, found a number");
}

TEST(Case, TheControlDecidesTheDialect) {
  const auto dialect = [](const std::string& fields, const std::string& setup) {
    return "{\"case\":1," + fields + "\"setup\":{" + setup + "},\"program\":\"\"}";
  };
  const std::string heidenhain = R"("control":"heidenhain")";
  EXPECT_EQ(read_case(dialect("", ""), "c").dialect, "fanuc");
  EXPECT_EQ(read_case(dialect("", heidenhain), "c").dialect, "klartext");
  EXPECT_EQ(read_case(dialect(R"("dialect":"klartext",)", heidenhain), "c").dialect, "klartext");
  EXPECT_EQ(error(dialect(R"("dialect":"klartext",)", "")),
            "c.json:1:21: dialect: the control of the setup needs \"fanuc\", found \"klartext\"");
  EXPECT_EQ(error(dialect(R"("dialect":"fanuc",)", heidenhain)),
            "c.json:1:21: dialect: the control of the setup needs \"klartext\", found \"fanuc\"");
  EXPECT_EQ(error(dialect(R"("dialect":"iso",)", "")),
            "c.json:1:21: dialect: unknown value \"iso\"; expected one of fanuc, klartext");
}

TEST(Case, EventsHaveTheFieldsOfTheirKind) {
  EXPECT_EQ(event_error(R"({"kind":"warning","number":"A","line":1})"), "no error");
  EXPECT_EQ(event_error(R"({"kind":"warning","number":"A","line":1,"message":"m"})"), "no error");
  EXPECT_EQ(event_error(R"({"line":1})"), "event: without kind");
  EXPECT_EQ(event_error(R"({"kind":"alarm","number":"A"})"), "event: without line");
  EXPECT_EQ(event_error(R"({"kind":"alarm","line":1})"), "event: without number");
  EXPECT_EQ(event_error(R"({"kind":"move","line":1,"type":"rapid"})"), "event: without cause");
  EXPECT_EQ(event_error(R"({"kind":"sample","line":1})"), "event: without t");
  EXPECT_EQ(event_error(R"({"kind":"setting","line":1,"name":"H1"})"), "event: without value");
  EXPECT_EQ(event_error(R"({"kind":"undecided","line":1})"), "event: without clause");
  EXPECT_EQ(event_error(R"({"kind":"hole","line":1,"point":{"X":1,"Y":2},"r":3,"bottom":-4,"axes":{"X":1}})"),
            "event: without return");
  EXPECT_EQ(event_error(R"({"kind":"hole","line":1,"point":{"X":1},"r":3,"bottom":-4,"return":3,"axes":{"X":1}})"),
            "no error");
  EXPECT_EQ(event_error(R"({"kind":"move","line":1,"type":"rapid","cause":"programmed","unknown":["Q"]})"),
            "unknown: \"Q\" is not an axis of the setup");
  EXPECT_EQ(event_error(R"({"kind":"move","line":1,"type":"arc","cause":"programmed","sweep":1})"),
            "event: without center");
  EXPECT_EQ(event_error(R"({"kind":"alarm","number":"A","line":1,"feed":1})"),
            "event: \"feed\" does not belong to alarm events");
  EXPECT_EQ(event_error(R"({"kind":"alarm","number":"A","line":1,"colour":1})"), "event: unknown field \"colour\"");
  EXPECT_EQ(event_error(R"({"kind":"motion","line":1})"),
            "kind: unknown value \"motion\"; expected one of move, sample, alarm, warning, setting, undecided, "
            "not_supported, not_judged, hole");
  EXPECT_EQ(event_error(R"({"kind":"alarm","number":"A","line":1,"clauses":["no.such.clause"]})"),
            "clauses: unknown clause \"no.such.clause\"");
  EXPECT_EQ(event_error(R"({"kind":"alarm","line":1,"number":")" + std::string(64, 'A') + "\"}"),
            "number: longer than 63 characters");
}

TEST(Case, FieldsOfSpaceCompensation) {
  const auto move = [](const std::string& fields) {
    return event_error(R"({"kind":"move","line":1,"type":"linear","cause":"programmed",)" + fields + "}");
  };
  const std::string vector = R"({"X":1,"Y":{"v":2,"r":0.5},"Z":-3})";
  const std::string shifts = "\"shift\":" + vector + ",\"tool_shift\":" + vector;
  const std::string center = "\"tool_center\":" + vector + "," + shifts;
  const std::string contact = center + ",\"contact\":" + vector + ",\"normal\":[0,0.6,0.8]";
  EXPECT_EQ(move(center), "no error");
  EXPECT_EQ(move(center + ",\"carrier\":" + vector), "no error");
  EXPECT_EQ(move(contact), "no error");
  EXPECT_EQ(move(contact + R"(,"angle":45,"flat":false)"), "no error");
  EXPECT_EQ(move(shifts), "event: without tool_center");
  EXPECT_EQ(move(center + R"(,"normal":[0,0,1])"), "event: without contact");
  EXPECT_EQ(move(center + ",\"contact\":" + vector), "event: without normal");
  EXPECT_EQ(move(center + ",\"flat\":true"), "event: without contact");
  EXPECT_EQ(move(R"("tool_center":{"X":1,"Y":2},)" + shifts), "tool_center: without Z");
  EXPECT_EQ(move(R"("tool_center":{"X":1,"Y":2,"Z":3,"U":4},)" + shifts),
            "tool_center: unknown key \"U\"; expected one of X, Y, Z");
  EXPECT_EQ(move(center + R"(,"reason":"OUT_OF_SCOPE")"), "event: \"reason\" does not belong to move events");
  EXPECT_EQ(event_error(R"({"kind":"undecided","line":1,"clause":"a","permitted":[],"reason":"OUT_OF_SCOPE"})"),
            "no error");
  EXPECT_EQ(event_error(R"({"kind":"undecided","line":1,"clause":"a","permitted":[],"reason":"WHY"})"),
            "reason: unknown value \"WHY\"; expected one of OUT_OF_SCOPE");
}

TEST(Case, NumbersAreNumbers) {
  const auto value = [](const std::string& text) {
    return event_error(R"({"kind":"setting","line":1,"name":"H1","value":)" + text + "}");
  };
  for (const char* text : {"1", "-1.5e-7", "\"1.\"", "\"-.5\"", R"({"v":1,"r":0.5})", R"({"v":"1","q":"1"})"})
    EXPECT_EQ(value(text), "no error") << text;
  EXPECT_EQ(value("\"nan\""), "value: expected a number, found \"nan\"");
  EXPECT_EQ(value("null"), "value: expected a number, found null");
  EXPECT_EQ(value("{}"), "value: the number has no \"v\"");
  EXPECT_EQ(value(R"({"v":1,"r":-1})"), "value: r must not be negative");
  EXPECT_EQ(value(R"({"v":1,"q":"1/0"})"), "value: q must be a fraction such as \"-3/4\"");
  EXPECT_EQ(value(R"({"v":1,"q":"1/2/3"})"), "value: q must be a fraction such as \"-3/4\"");
  EXPECT_EQ(value(R"({"v":1,"x":1})"), "value: unknown key \"x\"; expected one of v, r, q");
}

TEST(Case, MalformedPartsAreRefused) {
  const auto move = [](const std::string& field) {
    return event_error(R"({"kind":"move","line":1,"type":"rapid","cause":"programmed",)" + field + "}");
  };
  EXPECT_EQ(move(R"("point":{"Q":1})"), "point: \"Q\" is not an axis of the setup");
  EXPECT_EQ(move(R"("point":[1])"), "point: expected a table, found an array");
  EXPECT_EQ(move(R"("tool_axis":[0,1])"), "tool_axis: expected 3 numbers");
  EXPECT_EQ(move(R"("n":-1)"), "n: expected an integer from 0 to 999999999999999999, found \"-1\"");
  const auto sample = [](const std::string& t) { return event_error(R"({"kind":"sample","line":1,"t":)" + t + "}"); };
  EXPECT_EQ(sample("\"3/4\""), "no error");
  for (const char* t : {"\"1/0\"", "\"/\"", "\"-1/2\"", "\"1.0/2\"", "\"4294967296/4294967296\""})
    EXPECT_EQ(sample(t), "t: expected a fraction such as \"1/4\"") << t;
}

TEST(Reply, PartsOfSpaceCompensation) {
  const Reply reply = read_reply(
      R"({"id":"7","events":[{"kind":"move","line":3,"contact":{"X":1,"Y":2,"Z":3}},{"kind":"move","line":4,"carrier":{"X":1,"Y":2,"Z":3}}]})",
      Axes("XYZ"), "reply");
  ASSERT_TRUE(reply.events[0].space && reply.events[0].space->contact);
  EXPECT_EQ(reply.events[0].space->contact->point[2].v, "3");
  EXPECT_EQ(reply.events[0].space->contact->normal[0].v, "0");
  EXPECT_TRUE(reply.fields[0].has(Field::contact));
  EXPECT_FALSE(reply.fields[0].has(Field::normal));
  EXPECT_FALSE(reply.events[1].space->contact);
  ASSERT_TRUE(reply.events[1].space->carrier);
  EXPECT_EQ((*reply.events[1].space->carrier)[0].v, "1");
}

TEST(Reply, MaySayThatTheCaseDoesNotApply) {
  const Reply reply = read_reply(R"({"id":"7","not_applicable":"no such axis"})", Axes("XYZ"), "reply");
  EXPECT_EQ(reply.id, "7");
  EXPECT_EQ(reply.not_applicable, "no such axis");
  EXPECT_TRUE(reply.events.empty());
  EXPECT_EQ(reply.known_difference, "");
  const std::string by_design = R"({"id":"7","not_applicable":"it runs an arc there","known_difference":)";
  EXPECT_EQ(read_reply(by_design + "\"outer-corner\"}", Axes("XYZ"), "reply").known_difference, "outer-corner");
  for (const std::string& name : {std::string("Outer"), std::string("a b"), std::string("-a"), std::string(),
                                  std::string(65, 'a'), std::string("é")})
    EXPECT_THROW(read_reply(by_design + '"' + name + "\"}", Axes("XYZ"), "reply"), InputError) << name;
  EXPECT_THROW(read_reply(by_design + "1}", Axes("XYZ"), "reply"), InputError);
  // Beside events it is a field like others that are unknown.
  EXPECT_EQ(read_reply(R"({"id":"7","events":[{"kind":"note","line":1,"text":"x"},{"kind":"move","line":2}]})",
                       Axes("XYZ"), "reply")
                .events.size(),
            1U)
      << "notes are passed over";
  EXPECT_EQ(read_reply(R"({"id":"7","events":[],"not_applicable":"x"})", Axes("XYZ"), "reply").not_applicable, "");
  for (const char* line : {R"({"id":"7","not_applicable":""})", R"({"id":"7","not_applicable":1})",
                           R"({"not_applicable":"x"})", R"({"id":"7"})"})
    EXPECT_THROW(read_reply(line, Axes("XYZ"), "reply"), InputError) << line;
}

TEST(Reply, UnknownFieldsAreIgnoredAndKnownOnesNamed) {
  const Reply reply = read_reply(
      R"({"id":"7","took":1.5,"events":[{"kind":"move","line":3,"axes":{"X":1e-7,"S":2},"colour":[{}],"clauses":["?"]}]})",
      Axes("XYZ"), "reply");
  EXPECT_EQ(reply.id, "7");
  ASSERT_EQ(reply.events.size(), 1U);
  EXPECT_EQ(reply.events[0].axes[0].v, "1e-7");
  EXPECT_EQ(reply.events[0].axes.present, 1U);
  EXPECT_TRUE(reply.events[0].clauses.empty());
  EXPECT_EQ(reply.fields[0], (FieldSet{Field::kind, Field::line, Field::axes, Field::clauses}));
}

TEST(Reply, MalformedOnesSayWhatIsWrong) {
  const auto wrong = [](std::string_view line) -> std::string {
    try {
      read_reply(line, Axes("XYZ"), "reply");
    } catch (const InputError& e) {
      return e.message();
    }
    return "no error";
  };
  EXPECT_EQ(wrong("rubbish"), "expected a JSON value");
  EXPECT_EQ(wrong("{}"), "reply: without id");
  EXPECT_EQ(wrong(R"({"id":1,"events":[]})"), "id: expected a string, found a number");
  EXPECT_EQ(wrong(R"({"id":"1"})"), "reply: without events");
  EXPECT_EQ(wrong(R"({"id":"1","events":{}})"), "events: expected an array, found a table");
  EXPECT_EQ(wrong(R"({"id":"1","events":[{"kind":"move"}]})"), "event: without line");
  EXPECT_EQ(wrong(R"({"id":"1","events":[{"kind":"move","line":1,"point":{"X":"nan"}}]})"),
            "point: expected a number, found \"nan\"");
  EXPECT_EQ(wrong(R"({"id":"1","events":[]} {})"), "unexpected text after the end of the JSON value");
}

TEST(Case, SchemaFilesAreTheSchemas) {
  const auto file = [](const std::string& name) {
    std::ifstream stream(TOOLCOMP_SOURCE_DIR "/corpus/schema/" + name, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(stream), {});
  };
  EXPECT_EQ(file("case.schema.json"), case_schema());
  EXPECT_EQ(file("event.schema.json"), event_schema());
  EXPECT_EQ(file("hello.schema.json"), hello_schema());
  EXPECT_EQ(file("answer.schema.json"), answer_schema());
}

}  // namespace
