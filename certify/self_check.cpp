// SPDX-License-Identifier: Apache-2.0
#include "certify/self_check.h"

#include <fmt/format.h>

#include <string_view>

#include "certify/convert.h"
#include "certify/subject.h"
#include "fuzz/gen/generator.h"
#include "host/sha256.h"
#include "judge/oracle/verdict.h"

namespace toolcomp::certify {
namespace {

// The judge on a program whose last event sends an axis to a place that is known.
std::string check_judge(const spec::Case& c, std::size_t axis, std::string_view place) {
  const judge::ModelRun run = judge::run_model(c);
  TextEvents events;
  constexpr int kDigits = 40;
  for (const model::Event& event : run.events) events.push_back(in_text(event, kDigits));
  const auto judged = [&](const TextEvents& answer) { return judge::judge(c, run, answer).outcome; };
  if (events.size() != 2 || events.back().axes[axis].v != place)
    return fmt::format("{}: the model does not send {} to {}", c.section, c.setup.axes.letter(axis), place);
  if (judged(events) != judge::Outcome::agrees) return c.section + ": the model's own events are not accepted";
  const TextEvents fewer(events.begin(), events.end() - 1);
  if (judged(fewer) != judge::Outcome::differs) return c.section + ": a missing event is not noticed";
  TextEvents moved = events;
  moved.back().axes.set(axis,
                        {std::string(place) + (place.find('.') == std::string_view::npos ? ".001" : "1"), {}, {}});
  if (judged(moved) != judge::Outcome::differs) return c.section + ": a deviation is not noticed";
  return {};
}

}  // namespace

std::string self_check() {
  spec::Case fanuc;
  fanuc.id = "self-check";
  fanuc.section = "fanuc/tool-length-offset";
  fanuc.setup.h[1] = {spec::decimal(20), {}};
  fanuc.program = "G90 G43 Z100. H1\nG01 X10. Y5. F100\n";
  if (const std::string failure = check_judge(fanuc, 2, "120"); !failure.empty()) return failure;
  // A toroid cutter of 5 and 2 mm against a wall of 3-4-5: the tip moves by dR2 (n - t) + (rho' - rho) u, in X by
  // 0.1 * 0.6 + 0.2.
  spec::Case heidenhain;
  heidenhain.id = "self-check";
  heidenhain.section = "heidenhain/face-milling";
  heidenhain.dialect = "klartext";
  heidenhain.setup.control = spec::Control::heidenhain;
  heidenhain.setup.axes = spec::Axes("XYZ");
  spec::ToolRow tool;
  tool.number = 10;
  tool.r = spec::decimal(5);
  tool.r2 = spec::decimal(2);
  heidenhain.setup.tools = {tool};
  heidenhain.program =
      "TOOL CALL 1 Z DL+0.25 DR+0.3 DR2+0.1\nL Z+9 R0 FMAX M107\nLN X+0 Y+0 Z+0 NX+0.6 NY+0 NZ+0.8 R0 F500\n";
  if (const std::string failure = check_judge(heidenhain, 0, "0.26"); !failure.empty()) return failure;
  if (host::sha256("abc") != "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad")
    return "SHA-256 is wrong";
  return {};
}

}  // namespace toolcomp::certify
