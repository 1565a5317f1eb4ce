// SPDX-License-Identifier: Apache-2.0
// A batch of programs for a trace adapter: writes the folders, and runs the command of the adapter on them
// (docs/adapters.md).
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

// Lines of a program in which the adapter reports a known difference.
struct KnownPlace {
  std::string id;
  std::uint64_t first = 0;
  std::uint64_t last = 0;
};
// Reads known.txt; empty if there is none. Throws spec::InputError for lines that are not ID FIRST LAST, and for
// differences that the adapter's manifest does not know.
std::vector<KnownPlace> read_known_places(const std::filesystem::path& file, const Adapter& adapter);

// Runs the adapter's command with `option`, if any, on the batch to its end. Its lines go to `progress`. It is killed
// if it takes longer than `timeout` for each program plus six times `timeout`, or if `stop` gives a reason. Returns
// what went wrong, or an empty text.
std::string run_adapter(const Adapter& adapter, const std::string& option, const std::filesystem::path& batch,
                        std::size_t programs, std::chrono::milliseconds timeout,
                        const std::function<void(const std::string&)>& progress,
                        const std::function<std::string()>& stop = {});

// For each program: why the controller cannot run it, or which known difference it has; empty if there is neither. The
// programs are not run; only the adapter is asked. Throws spec::InputError if it gives no answer.
std::vector<std::string> why_not(const Adapter& adapter, const std::vector<spec::Case>& cases);

}  // namespace toolcomp::certify
