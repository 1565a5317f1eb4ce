// The controller's side of the protocol (docs/protocol.md) in one header, over nlohmann/json.
#pragma once

#include <functional>
#include <iostream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

namespace toolcomp_controller {

using Json = nlohmann::ordered_json;

// Thrown for a case that needs what the control does not have.
struct NotApplicable : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Answers line by line until the input ends: `hello` to the greeting, to a case the events that `run` makes of it. What
// else `run` throws is answered as an error, which is a finding.
inline void serve(const Json& hello, const std::function<Json(const Json& request)>& run) {
  for (std::string line; std::getline(std::cin, line);) {
    Json answer;
    try {
      const Json request = Json::parse(line);
      if (request.contains("hello")) {
        answer = hello;
      } else {
        answer["id"] = request.at("id");
        answer["events"] = run(request);
      }
    } catch (const NotApplicable& why) {
      answer["not_applicable"] = why.what();
    } catch (const std::exception& error) {
      answer["error"] = error.what();
    }
    std::cout << answer.dump() << std::endl;
  }
}

}  // namespace toolcomp_controller
