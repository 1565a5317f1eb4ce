// SPDX-License-Identifier: Apache-2.0
// toolcomp certify --evidence: the bundle beside the report.
#pragma once

#include <optional>
#include <string>

#include "certify/bundle/bundle_writer.h"
#include "certify/certification.h"
#include "cli/verbs.h"

namespace toolcomp::cli {

class Evidence {
 public:
  // Nothing is done without --evidence. Throws spec::InputError for a file or a key that cannot be, before hours of
  // work end there.
  explicit Evidence(const CertifyOptions& options);

  // `adapter`: its name; `corpus`: the folder of the golden corpus that is judged, or empty.
  void begin(certify::CertificationOptions& certification, const std::string& adapter,
             const std::filesystem::path& corpus);
  // Writes the bundle, and signs it. Throws spec::InputError where it cannot be signed.
  void finish(const certify::Certificate& certificate, const std::vector<std::filesystem::path>& findings);

 private:
  void add_inputs();

  const CertifyOptions& options_;
  std::optional<certify::bundle::BundleWriter> writer_;
};

// Throws spec::InputError for --evidence and --sign where nothing is asked and answered.
void refuse_evidence(const CertifyOptions& options, const std::string& why);

}  // namespace toolcomp::cli
