// The formal specification, run, against the exact model: the same events, every number to forty decimals. The two
// share numbers and readers, no rule. Golden vectors and generated cases; what a fault in it looks like is the test of
// certificates (command_line, certify_specification.cpp).
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "certify/serve.h"
#include "corpus/golden.h"
#include "formal/engine.h"
#include "fuzz/gen/generator.h"
#include "spec/language/case_format.h"
#include "spec/language/input_error.h"

namespace toolcomp {
namespace {

using Json = nlohmann::json;
using certify::ServedEngine;

// An answer without what the specification does not say: clauses and messages.
Json answer_of(ServedEngine engine, const spec::Case& c) {
  Json answer = Json::parse(certify::answer(engine, spec::write_case_line(c)));
  if (answer.contains("events"))
    for (Json& event : answer["events"])
      for (const char* key : {"clauses", "message"}) event.erase(key);
  return answer;
}

struct Count {
  std::size_t agree = 0;
  std::size_t not_said = 0;
};

void hold(spec::Case c, Count& count) {
  c.expect.clear();
  c.has_expect = false;
  Json expected;
  try {
    expected = answer_of(ServedEngine::model, c);
  } catch (const spec::InputError&) {
    return;  // no control has this setup
  }
  const Json said = answer_of(ServedEngine::specification, c);
  if (said.contains("not_applicable")) {
    ++count.not_said;
    return;
  }
  ++count.agree;
  EXPECT_EQ(said, expected) << spec::write_case(c);
}

class FormalSpecification : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    if (!formal::available()) GTEST_SKIP() << "built without Coq or OCaml";
  }
};

TEST_P(FormalSpecification, GivesTheGoldenVectors) {
  Count count;
  for (spec::Case& c : corpus::read_golden(corpus::default_folder(), {GetParam()})) hold(std::move(c), count);
  EXPECT_EQ(count.not_said, 0U);
  EXPECT_GT(count.agree, 100U);
}

TEST_P(FormalSpecification, AgreesOnGeneratedCases) {
  constexpr std::uint64_t kCases = 300;
  for (const fuzz::Mode mode : {fuzz::Mode::directed, fuzz::Mode::unrestricted}) {
    Count count;
    for (std::uint64_t i = 0; i < kCases; ++i) {
      fuzz::SeededSource source(7000 + i);
      hold(fuzz::generate(GetParam(), mode, source), count);
    }
    EXPECT_EQ(count.not_said, 0U);
    EXPECT_GT(count.agree, kCases / 2);
  }
}

INSTANTIATE_TEST_SUITE_P(Sections, FormalSpecification, testing::ValuesIn(formal::sections()), [](const auto& section) {
  std::string name = section.param;
  std::ranges::replace_if(name, [](char c) { return c == '/' || c == '-'; }, '_');
  return name;
});
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(FormalSpecification);

}  // namespace
}  // namespace toolcomp
