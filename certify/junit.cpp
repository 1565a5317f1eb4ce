// SPDX-License-Identifier: Apache-2.0
#include "certify/junit.h"

#include <fmt/format.h>

#include "certify/markup.h"

namespace toolcomp::certify::junit {

void Suite::add(std::string_view group, std::string_view name, const std::string& inside) {
  ++tests_;
  failures_ += inside.find("<failure") == std::string::npos ? 0 : 1;
  errors_ += inside.find("<error") == std::string::npos ? 0 : 1;
  skipped_ += inside.find("<skipped") == std::string::npos ? 0 : 1;
  cases_ += fmt::format(R"(    <testcase classname="{}" name="{}")", escape(group), escape(name));
  cases_ += inside.empty() ? "/>\n" : ">" + inside + "</testcase>\n";
}

std::string Suite::xml(std::string_view name) const {
  return fmt::format(
      "  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"{}\">\n{}  </testsuite>\n",
      escape(name), tests_, failures_, errors_, skipped_, cases_);
}

std::string document(const std::string& suites) {
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"toolcomp certify\">\n" + suites +
         "</testsuites>\n";
}

}  // namespace toolcomp::certify::junit
