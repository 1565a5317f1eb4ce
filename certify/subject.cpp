// SPDX-License-Identifier: Apache-2.0
#include "certify/subject.h"

#include <utility>

#include "certify/serve.h"
#include "fuzz/gen/generator.h"
#include "judge/oracle/verdict.h"
#include "spec_engine/engine.h"

namespace toolcomp::certify {
namespace {

class BuiltInEngine final : public Subject {
 public:
  [[nodiscard]] bool is_fast_engine() const override { return true; }
  std::variant<Capabilities, Fault> capabilities() override {
    Capabilities c;
    c.name = "toolcomp fast engine";
    c.version = TOOLCOMP_VERSION;
    for (const std::string_view section : fuzz::sections()) c.sections.emplace_back(section);
    c.fields = all_fields();
    return c;
  }

  Answer run(const spec::Case& c, std::optional<std::chrono::milliseconds> /*patience*/) override {
    return {judge::run_fast(c), {}, {}};
  }
};

class FormalSpecification final : public Subject {
 public:
  std::variant<Capabilities, Fault> capabilities() override { return served_capabilities(ServedEngine::specification); }

  Answer run(const spec::Case& c, std::optional<std::chrono::milliseconds> /*patience*/) override {
    spec_engine::Run run = spec_engine::run(c);
    if (!run.not_said.empty()) return {NotApplicable{run.not_said}, {}, {}};
    return {std::move(run.events), {}, {}};
  }
};

}  // namespace

std::string name(FaultKind kind) {
  switch (kind) {
    case FaultKind::crash:
      return "crash";
    case FaultKind::hang:
      return "hang";
    case FaultKind::too_long:
      return "reply too long";
    case FaultKind::error:
      return "error";
    case FaultKind::malformed:
      break;
  }
  return "malformed reply";
}

std::unique_ptr<Subject> formal_specification() { return std::make_unique<FormalSpecification>(); }

std::unique_ptr<Subject> built_in_engine() { return std::make_unique<BuiltInEngine>(); }

}  // namespace toolcomp::certify
