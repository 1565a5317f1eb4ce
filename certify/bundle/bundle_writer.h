// SPDX-License-Identifier: Apache-2.0
// Evidence: everything needed to repeat a certificate, in one file (docs/evidence.md).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "certify/bundle/manifest.h"
#include "certify/bundle/spool.h"
#include "certify/campaign.h"
#include "certify/certificate.h"

namespace toolcomp::certify::bundle {

// How the certificate was asked for.
struct Request {
  std::vector<std::string> command;   // the words of the command line
  std::vector<std::string> sections;  // as CampaignOptions::sections
  std::string adapter;                // its name
  std::filesystem::path corpus;       // folder of the golden corpus; empty: none
};

// Keeps what is asked and answered on disk while it comes, in files that go with the process. Nothing stands under the
// bundle's name before it is whole. Everything throws std::runtime_error where it cannot be written.
class BundleWriter {
 public:
  BundleWriter(std::filesystem::path file, Request request);

  // A program, case or setup by its name on the command line; one of a name counts once.
  void add_input(const std::string& given, std::string bytes);
  // CampaignOptions::judged.
  void add(const JudgedCase& judged);
  // `report`: the folder of the report; `findings`: its files of findings.
  void finish(const Certificate& certificate, const std::filesystem::path& report,
              const std::vector<std::filesystem::path>& findings);

 private:
  std::filesystem::path file_;
  Request request_;
  Spool cases_, answers_, results_;
  std::uint64_t number_ = 0;
  std::vector<ManifestInput> inputs_;
  std::vector<std::string> texts_;  // of the inputs
};

}  // namespace toolcomp::certify::bundle
