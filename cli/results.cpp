// SPDX-License-Identifier: Apache-2.0
// toolcomp results: certificates of several controllers in one table.
#include "certify/results/results.h"

#include <fmt/format.h>

#include <filesystem>
#include <iostream>

#include "cli/manners.h"
#include "cli/program.h"
#include "cli/verbs.h"
#include "host/file_writer.h"
#include "spec/language/input_error.h"

namespace toolcomp::cli {

namespace fs = std::filesystem;

int results(const ResultsOptions& options) {
  using certify::results::kMostControllers;
  if (options.folders.size() > kMostControllers)
    throw spec::InputError("toolcomp results", 0, 0,
                           fmt::format("takes {} folders at most, found {}", kMostControllers, options.folders.size()));
  const std::string file = !options.out.empty() || options.json ? options.out : "results.html";
  if (options.out.empty() && !file.empty()) expect_page_of_ours(file);
  if (const fs::path folder = fs::path(file).parent_path(); !folder.empty()) expect_folder(folder.string(), "--out");
  std::vector<certify::results::Controller> controllers;
  for (const std::string& folder : options.folders) {
    controllers.push_back(certify::results::read_certificate(fs::path(folder)));
    detail("certificate: " + controllers.back().folder + ": " + controllers.back().title());
  }
  if (options.json) std::cout << certify::results::json(controllers);
  if (file.empty()) return kAgrees;
  host::write_file(file, certify::results::page(controllers));
  note("wrote " + file);
  return kAgrees;
}

}  // namespace toolcomp::cli
