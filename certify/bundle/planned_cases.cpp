// SPDX-License-Identifier: Apache-2.0
#include "certify/bundle/planned_cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "certify/bundle/refused.h"
#include "certify/controller.h"
#include "certify/selection.h"
#include "corpus/golden.h"
#include "fuzz/gen/generator.h"
#include "host/sha256.h"
#include "spec/language/input_error.h"

namespace toolcomp::certify::bundle {
namespace {

bool among(const std::vector<std::string>& list, std::string_view text) {
  return std::ranges::find(list, text) != list.end();
}

}  // namespace

PlannedCases::PlannedCases(const Plan& plan) : of_adapter_(plan.of_adapter), interrupted_(plan.interrupted) {
  if (!plan.corpus.empty()) plan_golden(plan);
  if (plan.generated > 0) plan_generated(plan);
}

void PlannedCases::plan_golden(const Plan& plan) {
  corpus::Selection selection;
  for (const corpus::ManifestFile& file : corpus::read_manifest(plan.corpus).files) {
    if (!plan.sections.empty() && !among(plan.sections, file.section)) continue;
    if (host::sha256_file((plan.corpus / file.file).string()) != file.sha256)
      throw spec::InputError((plan.corpus / file.file).string(), 0, 0,
                             "is not the file that the manifest of the corpus names");
    if (!among(selection.sections, file.section)) selection.sections.push_back(file.section);
  }
  if (selection.sections.empty()) return;
  for (const corpus::Vector& vector : corpus::read_vectors(plan.corpus, selection))
    golden_[vector.c.id] = {1, host::sha256(request_line(vector.c))};
}

void PlannedCases::plan_generated(const Plan& plan) {
  for (const std::string_view section : fuzz::sections()) {
    if (!plan.sections.empty() && !among(plan.sections, section)) continue;
    // For a section that the controller does not know none are chosen.
    if (!among(plan.known, section)) {
      generated_[std::string(section)] = {plan.generated, {}};
      continue;
    }
    if (plan.regenerate) {
      for (const spec::Case& c : select_cases(section, plan.seed, plan.generated).cases)
        generated_[c.id] = {1, host::sha256(request_line(c))};
      continue;
    }
    for (std::uint32_t i = 0; i < plan.generated; ++i) generated_[generated_id(section, plan.seed, i)] = {};
  }
}

void PlannedCases::take(const spec::Case& c, Origin origin, const std::string& request) {
  if (origin == Origin::own) return;
  auto& planned = origin == Origin::golden ? golden_ : generated_;
  const auto found = planned.find(c.id);
  if (found == planned.end()) {
    if (origin == Origin::generated && of_adapter_) return;
    throw Refused(fmt::format("{}: is not a {} case of this certificate", c.id, name(origin)));
  }
  if (found->second.times == 0) throw Refused(c.id + ": occurs twice");
  if (!found->second.digest.empty() && found->second.digest != host::sha256(request))
    throw Refused(
        fmt::format("{}: is not the {}", c.id,
                    origin == Origin::golden ? "golden vector of the corpus" : "case that the seed generates"));
  --found->second.times;
}

void PlannedCases::finish() const {
  if (interrupted_) return;
  for (const auto* planned : {&golden_, &generated_})
    for (const auto& [id, left] : *planned)
      if (left.times > 0) throw Refused(id + ": is missing");
}

}  // namespace toolcomp::certify::bundle
