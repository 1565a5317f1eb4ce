#include "certify/running_report.h"

#include <fmt/format.h>

#include <utility>

#include "certify/report.h"
#include "spec/language/file_writer.h"

namespace toolcomp::certify {
namespace {

namespace fs = std::filesystem;

// A folder interrupted-N that is not yet there.
fs::path free_folder(const fs::path& folder) {
  for (int n = 1;; ++n)
    if (fs::path free = folder / fmt::format("interrupted-{}", n); !fs::exists(free)) return free;
}

}  // namespace

RunningReport::RunningReport(fs::path folder, const std::string& command)
    : folder_(std::move(folder)), mark_(folder_, command) {
  if (!mark_.earlier()) return;
  earlier_ = words(*mark_.earlier());
  const fs::path findings = folder_ / "findings";
  if (!fs::is_directory(findings) || fs::is_empty(findings)) {
    earlier_ += "; it had found nothing";
    return;
  }
  const fs::path aside = free_folder(folder_);
  fs::rename(findings, aside);
  earlier_ += "; its findings are in " + aside.string();
}

void RunningReport::found(const Finding& finding) {
  if (files_.empty()) remove_findings(folder_);
  auto [place, fresh] = files_.try_emplace(finding.key);
  if (fresh) place->second = folder_ / "findings" / file_name(finding, files_.size() - 1);
  spec::write_file(place->second, write_finding(finding));
}

}  // namespace toolcomp::certify
