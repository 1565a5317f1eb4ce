// A controller in C++: a control that positions, G00 and G01 with X Y Z, and knows no compensation. In place of moves()
// stands what asks your control.
#include "controller.h"

#include <map>
#include <regex>
#include <sstream>

using toolcomp_controller::Json;
using toolcomp_controller::NotApplicable;

namespace {

Json moves(const Json& request) {
  const Json& setup = request.at("setup");
  if (setup.at("control") != "fanuc" || setup.at("axes") != Json{"X", "Y", "Z"})
    throw NotApplicable("a control of three axes");
  for (const char* setting : {"workpiece", "position"})
    if (setup.contains(setting)) throw NotApplicable(setting);
  const Json parameters = setup.value("parameters", Json::object());
  for (const auto& [number, value] : parameters.items())
    if (number != "1411") throw NotApplicable("parameter " + number);
  static const std::regex kBlock(R"((G0?[01]|[XYZF]-?\d+\.?\d*|\s)*)");
  static const std::regex kWord(R"(([GXYZF])(-?\d+\.?\d*))");
  Json events = Json::array();
  std::map<char, double> at{{'X', 0}, {'Y', 0}, {'Z', 0}, {'G', 0}, {'F', parameters.value("1411", 0)}};
  std::istringstream program(request.at("program").get<std::string>());
  int line = 0;
  for (std::string block; std::getline(program, block);) {
    ++line;
    if (!std::regex_match(block, kBlock)) throw NotApplicable("the block " + block);
    bool moved = false;
    for (auto word = std::sregex_iterator(block.begin(), block.end(), kWord); word != std::sregex_iterator(); ++word) {
      const char address = (*word)[1].str().front();
      at[address] = std::stod((*word)[2]);
      moved = moved || (address >= 'X' && address <= 'Z');
    }
    if (!moved) continue;
    if (at['G'] != 0 && at['F'] == 0) throw NotApplicable("a cutting move without F");
    const Json axes{{"X", at['X']}, {"Y", at['Y']}, {"Z", at['Z']}};
    events.push_back({{"kind", "move"}, {"line", line}, {"type", at['G'] == 0 ? "rapid" : "linear"}, {"axes", axes}});
  }
  return events;
}

}  // namespace

int main() {
  const Json hello{{"name", "positions"},
                   {"version", "1"},
                   {"protocol", 1},
                   {"sections", {"fanuc/tool-length-offset"}},
                   {"fields", {"kind", "line", "type", "axes"}}};
  toolcomp_controller::serve(hello, moves);
}
