// SPDX-License-Identifier: Apache-2.0
#include "host/date.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <charconv>
#include <cstdlib>
#include <cstring>
#include <ctime>

namespace toolcomp::host {
namespace {

std::string text(std::time_t time) { return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(time)); }

}  // namespace

std::string time_of_now() { return text(std::time(nullptr)); }

std::string date_of_now() {
  const char* const epoch = std::getenv("SOURCE_DATE_EPOCH");  // NOLINT(concurrency-mt-unsafe)
  std::time_t time = std::time(nullptr);
  if (epoch != nullptr) std::from_chars(epoch, epoch + std::strlen(epoch), time);
  return text(time);
}

}  // namespace toolcomp::host
