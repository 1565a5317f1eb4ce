// SPDX-License-Identifier: Apache-2.0
#include "certify/running_report.h"

#include <utility>

#include "certify/report.h"
#include "host/file_writer.h"

namespace toolcomp::certify {

namespace fs = std::filesystem;

RunningReport::RunningReport(fs::path folder, const std::string& command)
    : folder_(std::move(folder)), mark_(folder_, command) {
  if (!mark_.earlier()) return;
  earlier_ = words(*mark_.earlier());
  const auto aside = set_aside(folder_ / "findings");
  earlier_ += aside ? "; its findings are in " + aside->string() : "; it had found nothing";
}

void RunningReport::found(const Finding& finding) {
  if (files_.empty()) remove_findings(folder_);
  auto [place, fresh] = files_.try_emplace(finding.key);
  if (fresh) place->second = folder_ / "findings" / file_name(finding, files_.size() - 1);
  host::write_file(place->second, write_finding(finding));
}

}  // namespace toolcomp::certify
