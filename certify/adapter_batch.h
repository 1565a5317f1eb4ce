// SPDX-License-Identifier: Apache-2.0
// A batch of programs for a trace adapter: folders written, the adapter's command run on them (docs/adapters.md).
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "certify/adapter.h"
#include "spec/language/case.h"

namespace toolcomp::certify {

// Folder number `index` of a batch, from 0: 0001 and so on.
std::filesystem::path batch_folder(const std::filesystem::path& batch, std::size_t index);

// Writes program.nc and setup.json.
void write_program(const std::filesystem::path& folder, const spec::Case& c);

// The first line of a file that the adapter wrote, or nothing.
std::optional<std::string> first_line(const std::filesystem::path& file);

// Lines of a program where the adapter says that the controller is known to differ.
struct KnownPlace {
  std::string id;
  std::uint64_t first = 0;
  std::uint64_t last = 0;
};
// Reads known.txt; nothing where there is none. Throws spec::InputError for lines that are not ID FIRST LAST, and for
// differences that the adapter's manifest does not know.
std::vector<KnownPlace> read_known_places(const std::filesystem::path& file, const Adapter& adapter);

// Runs the adapter's command with `option`, if any, on the batch to its end; what it says goes to `progress`. It is
// killed when it takes longer than `timeout` for each program and six times that besides, and when `stop` says why.
// What is wrong with it, or empty.
std::string run_adapter(const Adapter& adapter, const std::string& option, const std::filesystem::path& batch,
                        std::size_t programs, std::chrono::milliseconds timeout,
                        const std::function<void(const std::string&)>& progress,
                        const std::function<std::string()>& stop = {});

// Why the controller cannot run each of these programs, or is known to run it otherwise; empty where neither is said.
// Nothing is run: the adapter is asked. Throws spec::InputError where it gives no answer.
std::vector<std::string> why_not(const Adapter& adapter, const std::vector<spec::Case>& cases);

}  // namespace toolcomp::certify
