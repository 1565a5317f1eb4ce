// SPDX-License-Identifier: Apache-2.0
// Answers of a controller, and what is told of those that are none.
#include <gtest/gtest.h>

#include <string>
#include <variant>

#include "certify/controller.h"

namespace toolcomp::certify {
namespace {

std::string told(const std::string& error) {
  spec::Case c;
  c.id = "x";
  const Answer answer = read_answer({}, c, R"({"id":"x","error":")" + error + "\"}");
  const auto* const fault = std::get_if<Fault>(&answer.result);
  if (fault == nullptr) return "no fault";
  EXPECT_EQ(fault->kind, FaultKind::error);
  return fault->what;
}

TEST(Answers, TellTheBeginningOfALongText) {
  EXPECT_EQ(told("no room"), "\"no room\"");
  EXPECT_EQ(told("two\\nlines"), "\"two\xEF\xBF\xBDlines\"");
  EXPECT_EQ(told(std::string(80, 'a')), "\"" + std::string(80, 'a') + "\"");
  EXPECT_EQ(told(std::string(81, 'a')), "\"" + std::string(80, 'a') + "\"…");
}

}  // namespace
}  // namespace toolcomp::certify
