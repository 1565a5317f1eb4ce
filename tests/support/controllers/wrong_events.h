// SPDX-License-Identifier: Apache-2.0
// Lies about the events of a right answer, by name: what a faulty controller makes of them.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>

namespace toolcomp::test {

using Json = nlohmann::ordered_json;
using Lie = std::function<void(Json& events)>;

inline constexpr const char* kPositions[] = {"programmed", "point", "axes", "machine"};

// Every number of positions, by its letter.
inline Lie positions(const std::function<double(char letter, double)>& wrong) {
  return [wrong](Json& events) {
    for (Json& event : events)
      for (const char* field : kPositions)
        if (event.contains(field))
          for (auto& [letter, value] : event[field].items()) value = wrong(letter[0], value.get<double>());
  };
}

inline Lie rounded(double scale, double (*round)(double)) {
  return positions([=](char, double x) { return round(x * scale) / scale; });
}

// A field of every event that has it.
inline Lie field(const std::string& name, const std::function<void(Json&)>& wrong) {
  return [=](Json& events) {
    for (Json& event : events)
      if (event.contains(name)) wrong(event[name]);
  };
}

inline Lie scaled(const std::string& name, double factor) {
  return field(name, [factor](Json& value) { value = value.get<double>() * factor; });
}

inline Lie left_out(const std::function<bool(const Json& event)>& gone) {
  return [gone](Json& events) { std::erase_if(events.get_ref<Json::array_t&>(), gone); };
}

inline void exchange_x_and_y(Json& events) {
  for (Json& event : events)
    for (const char* name : kPositions)
      if (event.contains(name) && event[name].contains("X") && event[name].contains("Y"))
        std::swap(event[name]["X"], event[name]["Y"]);
}

inline void one_block_late(Json& events) {
  for (std::size_t i = events.size(); i-- > 1;)
    for (const char* name : kPositions)
      if (events[i].contains(name) && events[i - 1].contains(name))
        for (auto& [letter, value] : events[i][name].items())
          if (events[i - 1][name].contains(letter)) value = events[i - 1][name][letter];
}

// Of every hole.
inline void returns_to_point_r(Json& events) {
  for (Json& event : events) {
    if (event["kind"] != "hole") continue;
    event["axes"]["Z"] = event["axes"]["Z"].get<double>() + event["r"].get<double>() - event["return"].get<double>();
    event["return"] = event["r"];
  }
}

// Behind the first hole the axes go where the tool point is.
inline void no_length_behind_a_hole(Json& events) {
  bool behind = false;
  for (Json& event : events) {
    if (behind && event["kind"] == "move") event["axes"]["Z"] = event["point"]["Z"];
    behind = behind || event["kind"] == "hole";
  }
}

inline bool ends_in_alarm(const Json& events) { return !events.empty() && events.back()["kind"] == "alarm"; }

inline const std::map<std::string, Lie>& lies() {
  const auto is = [](const char* name, const char* value) {
    return [=](const Json& event) { return event.contains(name) && event[name] == value; };
  };
  const auto always = [](const char* name, const char* value) {
    return field(name, [value](Json& now) { now = value; });
  };
  static const std::map<std::string, Lie> all{
      {"constant-x", positions([](char letter, double x) { return letter == 'X' ? x + 0.000001 : x; })},
      {"constant-z", positions([](char letter, double x) { return letter == 'Z' ? x - 0.25 : x; })},
      {"bias", positions([](char, double x) { return x + 0.00001; })},
      {"scaled-z", positions([](char letter, double x) { return letter == 'Z' ? x * 1.0001 : x; })},
      {"inches", positions([](char letter, double x) { return letter >= 'U' ? x / 25.4 : x; })},
      {"radians", positions([](char letter, double x) { return letter < 'U' ? x * std::numbers::pi / 180 : x; })},
      {"sign-y", positions([](char letter, double x) { return letter == 'Y' ? -x : x; })},
      {"rotary-sense", positions([](char letter, double x) { return letter < 'U' ? -x : x; })},
      {"rounded-3", rounded(1000, [](double x) { return std::round(x); })},
      {"down-2", rounded(100, [](double x) { return std::floor(x); })},
      {"truncated-4", rounded(10000, [](double x) { return std::trunc(x); })},
      {"huge", positions([](char, double) { return 1e300; })},
      {"zero", positions([](char, double) { return 0.0; })},
      {"exchanged", exchange_x_and_y},
      {"hole-to-point-r", returns_to_point_r},
      {"no-length-behind-a-hole", no_length_behind_a_hole},
      {"late", one_block_late},
      {"feed", scaled("feed", 60)},
      {"no-feed", field("feed", [](Json& value) { value = 0; })},
      {"sweep", scaled("sweep", -1)},
      {"tool-axis", field("tool_axis",
                          [](Json& v) {
                            for (Json& x : v) x = -x.get<double>();
                          })},
      {"line", field("line", [](Json& line) { line = line.get<int>() + 1; })},
      {"sequence", field("n", [](Json& n) { n = n.get<int>() + 1; })},
      {"rapid", always("type", "rapid")},
      {"cause", always("cause", "programmed")},
      {"direction", field("direction", [](Json& d) { d = d == "cw" ? "ccw" : "cw"; })},
      {"plane", field("plane", [](Json& p) { p = p == "XY" ? "ZX" : "XY"; })},
      {"alarm", always("number", "PS0001")},
      {"no-alarm", left_out(is("kind", "alarm"))},
      {"alarm-alone",
       [](Json& events) {
         if (ends_in_alarm(events)) events = Json::array({events.back()});
       }},
      {"no-settings", left_out(is("kind", "setting"))},
      {"no-corners", left_out(is("cause", "corner"))},
      {"nothing", left_out([](const Json&) { return true; })},
      {"drop-last",
       [](Json& events) {
         if (!events.empty()) events.erase(events.size() - 1);
       }},
      {"twice",
       [](Json& events) {
         if (!events.empty()) events.push_back(Json(events.back()));
       }},
      {"reversed", [](Json& events) { std::reverse(events.begin(), events.end()); }},
  };
  return all;
}

// Lies about the case: the fast engine is asked another one.
inline const std::map<std::string, std::function<void(Json& request)>>& other_requests() {
  const auto offsets = [](const std::function<void(Json&)>& change) {
    return [change](Json& request) {
      if (!request["setup"].contains("offsets")) return;
      for (const char* table : {"H", "D"})
        if (request["setup"]["offsets"].contains(table))
          for (auto& [number, entry] : request["setup"]["offsets"][table].items()) {
            if (entry.is_object())
              for (auto& [part, value] : entry.items()) change(value);
            else
              change(entry);
          }
    };
  };
  static const std::map<std::string, std::function<void(Json&)>> all{
      {"offset-sign", offsets([](Json& value) {
         const std::string text = value.is_string() ? value.get<std::string>() : value.dump();
         value = text.starts_with('-') ? text.substr(1) : "-" + text;
       })},
      {"no-offsets", offsets([](Json& value) { value = 0; })},
      {"sides",
       [](Json& request) {
         std::string program = request["program"];
         for (std::size_t at = 0; (at = program.find("G4", at)) != std::string::npos; at += 3)
           if (at + 2 < program.size() && (program[at + 2] == '1' || program[at + 2] == '2'))
             program[at + 2] = program[at + 2] == '1' ? '2' : '1';
         for (std::size_t at = 0; (at = program.find(" R", at)) != std::string::npos; at += 3)
           if (at + 2 < program.size() && (program[at + 2] == 'L' || program[at + 2] == 'R'))
             program[at + 2] = program[at + 2] == 'L' ? 'R' : 'L';
         request["program"] = program;
       }},
  };
  return all;
}

}  // namespace toolcomp::test
