// SPDX-License-Identifier: Apache-2.0
// Which subject a finding was made of.
#include <filesystem>

#include "certify/controller.h"
#include "certify/finding.h"
#include "spec/language/input_error.h"
#include "spec_engine/engine.h"

namespace toolcomp::certify {

Finding signed_finding(Finding finding, const std::string& controller, std::uint64_t seed) {
  finding.controller = controller;
  if (!controller.empty()) finding.directory = std::filesystem::current_path().string();
  finding.seed = std::to_string(seed);
  finding.tool = std::string("toolcomp ") + TOOLCOMP_VERSION;
  return finding;
}

std::string command_in(const std::string& directory, const std::string& command) {
  if (directory.empty() || command.empty()) return command;
  return "cd " + host::shell_quoted(directory) + " && {\n" + command + "\n}";
}

std::unique_ptr<Subject> subject_of(const std::string& controller, std::chrono::milliseconds timeout,
                                    std::size_t reply_limit) {
  if (controller.empty()) return built_in_engine();
  ControllerOptions options;
  options.command = controller;
  options.timeout = timeout;
  options.reply_limit = reply_limit;
  return std::make_unique<Controller>(std::move(options));
}

std::unique_ptr<Subject> subject_of_finding(const std::string& controller, std::chrono::milliseconds timeout) {
  if (controller != kFormalSpecification) return subject_of(controller, timeout);
  if (!spec_engine::available())
    throw spec::InputError(controller, 0, 0, "this toolcomp was built without the formal specification");
  return formal_specification();
}

int exit_status(Result result) {
  switch (result) {
    case Result::agrees:
      return 0;
    case Result::differs:
      return 1;
    default:
      return 3;
  }
}

}  // namespace toolcomp::certify
