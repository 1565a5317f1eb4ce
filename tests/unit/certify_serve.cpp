// SPDX-License-Identifier: Apache-2.0
// The controller's side of the protocol.
#include "certify/serve.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "certify/capabilities.h"
#include "fuzz/gen/generator.h"
#include "spec/language/case_format.h"
#include "spec/language/input_error.h"

namespace toolcomp::certify {
namespace {

// The manual's note in 14.1.1: H1 = 20, H2 = 30; Z100 becomes 120, then 130.
spec::Case example() {
  spec::Case c;
  c.id = "two \"offsets\"";
  c.section = "fanuc/tool-length-offset";
  c.setup.h[1] = {spec::decimal(20), {}};
  c.setup.h[2] = {spec::decimal(30), {}};
  c.program = "G90 G43 Z100. H1\nG43 Z100. H2\n";
  return c;
}

TEST(Serve, AnswersHelloWithCapabilities) {
  for (const ServedEngine engine : {ServedEngine::fast, ServedEngine::model}) {
    const Capabilities c = read_capabilities(answer(engine, "{ \"hello\" : 1 }"));
    EXPECT_TRUE(meets_minimum(c));
    EXPECT_TRUE(fields_not_judged(c).empty());
    EXPECT_EQ(c.sections.size(), fuzz::sections().size());
  }
}

TEST(Serve, AnswersACaseWithItsEvents) {
  for (const ServedEngine engine : {ServedEngine::fast, ServedEngine::model}) {
    const std::string line = answer(engine, spec::write_case_line(example()));
    EXPECT_EQ(line.find('\n'), std::string::npos);
    const auto json = nlohmann::json::parse(line);
    EXPECT_EQ(json["id"], "two \"offsets\"");
    ASSERT_EQ(json["events"].size(), 2U);
    const spec::Reply reply = spec::read_reply(line, example().setup.axes, "reply");
    EXPECT_EQ(reply.events[0].axes[2].v, "120");
    EXPECT_EQ(reply.events[1].axes[2].v, "130");
  }
}

TEST(Serve, GoesOnAfterARequestItCannotRead) {
  std::istringstream in("{\"hello\":1}\nnonsense\n" + spec::write_case_line(example()) + "\n");
  std::ostringstream out;
  std::ostringstream errors;
  EXPECT_EQ(serve(ServedEngine::fast, in, out, errors), 1U);
  std::istringstream lines(out.str());
  std::string line;
  std::getline(lines, line);
  EXPECT_NO_THROW(read_capabilities(line));
  std::getline(lines, line);
  EXPECT_EQ(nlohmann::json::parse(line)["error"].get<std::string>().rfind("stdin:2:", 0), 0U) << line;
  EXPECT_EQ(errors.str().rfind("stdin:2:", 0), 0U);
  std::getline(lines, line);
  EXPECT_EQ(nlohmann::json::parse(line)["events"].size(), 2U);
  EXPECT_FALSE(std::getline(lines, line));
}

TEST(Serve, BoundsARequest) {
  std::istringstream in(std::string(1000, 'x') + "\n{\"hello\":1}\n");
  std::ostringstream out;
  std::ostringstream errors;
  EXPECT_EQ(serve(ServedEngine::fast, in, out, errors, 100), 1U);
  EXPECT_NE(out.str().find("\"protocol\":1"), std::string::npos);
}

TEST(Serve, ThrowsForWhatNoControlCouldRead) {
  spec::Case c = example();
  c.program = std::string("G00 X1\0Y2\n", 10);
  EXPECT_THROW(answer(ServedEngine::fast, spec::write_case_line(c)), spec::InputError);
  EXPECT_THROW(answer(ServedEngine::model, "{\"case\":1,\"colour\":2}"), spec::InputError);
}

}  // namespace
}  // namespace toolcomp::certify
