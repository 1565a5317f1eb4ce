// A controller that is right until it is told not to be: `toolcomp_faulty_controller FAULT [TEXT]` answers with the
// fast engine and commits FAULT in every case whose program contains TEXT (without TEXT: in every case).
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>

#include "certify/serve.h"
#include "spec/language/input_error.h"

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
  if (fault == "coarse") json["resolution"] = "0.001";
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
  } else if (fault == "missing-field" || fault == "no-type") {
    for (Json& event : events) event.erase("type");
  } else if (fault == "missing-axes") {
    for (Json& event : events) event.erase("axes");
  } else if (fault == "two-lines") {
    std::cout << json.dump() << '\n';
  } else if (fault == "coarse") {
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

}  // namespace

int main(int argc, char** argv) {
  const std::string fault = argc > 1 ? argv[1] : "none";
  const std::string text = argc > 2 ? argv[2] : "";
  std::string line;
  while (std::getline(std::cin, line)) {
    const Json request = Json::parse(line);
    if (request.contains("hello")) {
      std::cout << hello(fault, line) << std::endl;
      continue;
    }
    Json json = Json::parse(answer(ServedEngine::fast, line));
    if (request["program"].get<std::string>().find(text) == std::string::npos || commit(fault, json))
      std::cout << json.dump() << std::endl;
  }
}
