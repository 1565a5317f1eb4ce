// SPDX-License-Identifier: Apache-2.0
// A controller that is right until it is told not to be: `toolcomp_faulty_controller FAULT [TEXT]` answers with the
// fast engine and commits FAULT in every case whose program contains TEXT (without TEXT: in every case). `seventh-…`
// commits it in every seventh case that its process is asked, `sometimes-…` in about half of them, by chance.
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <string_view>
#include <thread>

#include "certify/serve.h"
#include "spec/language/input_error.h"
#include "tests/support/controllers/wrong_events.h"

namespace {

using Json = nlohmann::ordered_json;
using toolcomp::certify::answer;
using toolcomp::certify::ServedEngine;

// Longer than any time-out of a test.
void hang() { std::this_thread::sleep_for(std::chrono::hours(1)); }

void print_long_line() {
  const std::string piece(1 << 20, 'x');
  for (int i = 0; i < 200; ++i) std::cout << piece;
  std::cout << '\n' << std::flush;
}

// The last move that has a Z that is not 0.
Json* last_z(Json& events) {
  Json* found = nullptr;
  for (Json& event : events)
    if (event.contains("axes") && event["axes"].contains("Z") && event["axes"]["Z"] != 0) found = &event["axes"]["Z"];
  return found;
}

// What the controller says of itself, as a fault has it.
std::string hello(const std::string& fault, const std::string& request) {
  if (fault == "hello-hang") hang();
  if (fault == "hello-rubbish") return "Welcome to CNC 3000";
  Json json = Json::parse(answer(ServedEngine::fast, request));
  json["name"] = "faulty controller";
  if (fault == "less-than-minimum") json["fields"] = {"kind", "line", "type"};
  if (fault == "no-type") std::erase(json["fields"].get_ref<Json::array_t&>(), Json("type"));
  if (fault == "coarse") json["resolution"] = {{"mm", "0.001"}, {"inch", "0.001"}, {"degrees", "0.001"}};
  if (fault == "coarse-rounding") {
    json["resolution"] = "0.001";
    json["rounding"] = "nearest";
  }
  if (fault == "very-coarse") json["resolution"] = "0.05";
  if (fault == "very-coarse-inch") {
    json["resolution"] = "0.001";
    json["setup"] = {{"units", "inch"}};
  }
  // The fast engine marks none.
  if (fault == "never-sends") json["fields"].push_back("clauses");
  if (fault == "fixed-setup") json["setup"] = {{"parameters", {{"5001#2", 1}}}};
  if (fault == "one-section") json["sections"] = {"fanuc/tool-length-offset"};
  return json.dump();
}

// Commits the fault on the answer to one case; false where it leaves no answer to give.
bool commit(const std::string& fault, Json& json) {
  Json& events = json["events"];
  if (fault == "flip-sign") {
    if (Json* z = last_z(events)) *z = -z->get<double>();
  } else if (fault == "drop-event") {
    if (!events.empty()) events.erase(events.size() - 1);
  } else if (fault == "hang") {
    hang();
  } else if (fault == "exit") {
    std::cerr << "servo not ready\n";
    std::_Exit(3);
  } else if (fault == "abort") {
    std::raise(SIGKILL);
  } else if (fault == "rubbish") {
    std::cout << "%%% 17 @ X=?\n" << std::flush;
    return false;
  } else if (fault == "long-line") {
    print_long_line();
    return false;
  } else if (fault == "wrong-id") {
    json["id"] = "somebody else's";
  } else if (fault == "no-events") {
    json.erase("events");
  } else if (const auto lie = toolcomp::test::lies().find(fault); lie != toolcomp::test::lies().end()) {
    lie->second(events);
  } else if (fault == "previous") {
    static Json before = Json::array();
    std::swap(before, events);
  } else if (fault == "duplicate-keys") {
    std::string text = json.dump();
    text.insert(1, R"("id":"another",)");
    std::cout << text << '\n' << std::flush;
    return false;
  } else if (fault == "error") {
    json.erase("events");
    json["error"] = "servo not ready";
  } else if (fault == "chatter") {
    std::cout << "axes ready\n";
  } else if (fault == "not-a-number") {
    if (Json* z = last_z(events)) *z = "nan";
  } else if (fault == "missing-field" || fault == "no-type") {
    for (Json& event : events) event.erase("type");
  } else if (fault == "missing-axes") {
    for (Json& event : events) event.erase("axes");
  } else if (fault == "two-lines") {
    std::cout << json.dump() << '\n';
  } else if (fault == "coarse" || fault == "coarse-rounding") {
    // Truncates to its resolution, as a display does.
    for (Json& event : events)
      for (const char* field : {"programmed", "point", "axes", "machine"})
        if (event.contains(field))
          for (Json& value : event[field]) {
            const double truncated = static_cast<double>(static_cast<long long>(value.get<double>() * 1000)) / 1000;
            value = truncated == 0 ? 0.0 : truncated;
          }
  }
  return true;
}

// Whether the fault is committed now, and without its prefix.
bool is_due(std::string& fault, std::uint64_t cases) {
  constexpr std::uint64_t kSeventh = 7;
  constexpr std::string_view kByCount = "seventh-";
  constexpr std::string_view kByChance = "sometimes-";
  if (fault.starts_with(kByCount)) {
    fault.erase(0, kByCount.size());
    return cases % kSeventh == 0;
  }
  if (fault.starts_with(kByChance)) {
    fault.erase(0, kByChance.size());
    return std::random_device{}() % 2 == 0;
  }
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string given = argc > 1 ? argv[1] : "none";
  const std::string text = argc > 2 ? argv[2] : "";
  std::uint64_t cases = 0;
  std::string line;
  while (std::getline(std::cin, line)) {
    const Json request = Json::parse(line);
    if (request.contains("hello")) {
      std::cout << hello(given, line) << std::endl;
      continue;
    }
    Json asked = request;
    if (const auto other = toolcomp::test::other_requests().find(given);
        other != toolcomp::test::other_requests().end())
      other->second(asked);
    Json json = Json::parse(answer(ServedEngine::fast, asked.dump()));
    std::string fault = given;
    if (!is_due(fault, ++cases)) fault = "none";
    if (request["program"].get<std::string>().find(text) == std::string::npos || commit(fault, json))
      std::cout << json.dump() << std::endl;
  }
}
