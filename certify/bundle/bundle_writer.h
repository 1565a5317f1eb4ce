// SPDX-License-Identifier: Apache-2.0
// Evidence: everything needed to repeat a certificate, in one file (docs/evidence.md).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "certify/bundle/manifest.h"
#include "certify/bundle/spool.h"
#include "certify/certificate.h"
#include "certify/certification.h"

namespace toolcomp::certify::bundle {

// The command that asked for the certificate.
struct Request {
  std::vector<std::string> command;   // the words of the command line
  std::vector<std::string> sections;  // as CertificationOptions::sections
  std::string adapter;                // its name
  std::filesystem::path corpus;       // folder of the golden corpus; empty: none
};

// Keeps requests and answers on disk as they come, in files that are removed with the process. No file has the bundle's
// name before the bundle is complete. All functions throw std::runtime_error if something cannot be written.
class BundleWriter {
 public:
  BundleWriter(std::filesystem::path file, Request request);

  // Adds a program, case or setup by its name on the command line. A name is added only once.
  void add_input(const std::string& given, std::string bytes);
  // To be called by CertificationOptions::judged.
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
