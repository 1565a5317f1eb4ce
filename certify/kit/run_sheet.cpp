// SPDX-License-Identifier: Apache-2.0
#include "certify/kit/run_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "certify/kit/alarm_form.h"
#include "certify/kit/marks.h"
#include "certify/kit/offsets.h"
#include "certify/kit/screen.h"
#include "certify/markup.h"
#include "certify/page.h"

namespace toolcomp::certify::kit {
namespace {

constexpr std::string_view kBox = "&#9744; ";

std::string code(std::string_view text) { return "<code>" + escape(text) + "</code>"; }
std::string check(std::string_view html) { return "<li>" + std::string(kBox) + std::string(html) + "</li>\n"; }

std::string name_of(const KitProgram& program) { return program.file.substr(0, program.file.find('.')); }

// The clauses that the outcomes belong to, each once, with the outcomes behind.
std::string clauses_of(const std::vector<std::string>& shows) {
  std::map<std::string, std::string> outcomes;
  for (const std::string& shown : shows) {
    const std::size_t equals = shown.rfind('=');
    std::string& list = outcomes[shown.substr(0, equals)];
    list += (list.empty() ? "" : ", ") + shown.substr(equals + 1);
  }
  std::string html;
  for (const auto& [clause, list] : outcomes) html += (html.empty() ? "" : "; ") + code(clause) + " " + escape(list);
  return html;
}

std::string summary(const Kit& kit) {
  const auto stopped = static_cast<std::size_t>(
      std::ranges::count_if(kit.programs, [](const KitProgram& p) { return !p.alarm.empty(); }));
  return "<h1>Run sheet</h1>\n" +
         facts({{"Made by", escape(kit.tool)},
                {"Golden corpus", escape(kit.corpus) + ", " + code(kit.corpus_hash)},
                {"Programs",
                 fmt::format("{} to record, {} that must end in an alarm", kit.programs.size() - stopped, stopped)},
                {"Clause outcomes", fmt::format("{} of {}: {} by recordings, {} by alarms", kit.recorded + kit.noted,
                                                kit.outcomes, kit.recorded, kit.noted)},
                {"Machine, serial number", "______________________________"},
                {"Control, software", "______________________________"},
                {"Date, name", "______________________________"}});
}

bool is_klartext(const Kit& kit) { return kit.machine.setup.control == spec::Control::heidenhain; }

std::string columns(const spec::Setup& setup) {
  std::string letters = "time";
  const bool all = setup.control == spec::Control::fanuc;
  for (const char axis : setup.axes.letters())
    if (all || spec::is_linear_axis(axis)) letters += std::string(",") + axis;
  return code(letters);
}

std::string preparation_fanuc(const Kit& kit) {
  const spec::Setup& setup = kit.machine.setup;
  std::string html =
      check("Save parameters, offsets and work zero points. The kit overwrites offsets and some parameters.");
  html += check("Set the workpiece system <b>G54</b> to the machine position " +
                code(place_words(setup, setup.workpiece[0])) + " and the external and shared shifts to 0.");
  html +=
      check("All programs begin and end at " + code(place_words(setup, setup.position)) + " of G54. Go there by hand.");
  html += check(
      "Block skip OFF, so that <code>/G80 G69</code> is executed. If the control has no G69 and raises an alarm there, "
      "switch block skip ON, and make sure that no canned cycle, rotation or scaling is in force.");
  html += check(
      "Rapid traverse in straight lines (1401#1 = 1). If this is not possible, judge the recordings with "
      "<code>--rapids-by-axis</code>.");
  html += check("Enter the offsets: run " + code(kit.offsets_program) +
                ", or type in the list below. Then compare the offsets with the list.");
  return html;
}

std::string preparation_klartext(const Kit& kit) {
  const spec::Setup& setup = kit.machine.setup;
  std::string html = check("Save tool table and presets.");
  html += check(
      "Set the preset so that the travels below are free. They are travels of the tool tip in the coordinates of the "
      "preset. Leave room for the movement of the head when it turns: the kit does not know the kinematics of the "
      "machine, nor the rotary positions that tool vectors give under TCPM.");
  html += check("All programs begin and end at " + code(place_words(setup, setup.position)) + ". Go there by hand.");
  html += check("Copy the tools from " + code("tool.t") +
                ", or type in the list below. These tools do not exist: TOOL CALL must not fetch them (use manual "
                "tools, or a programming station).");
  return html;
}

std::string preparation(const Kit& kit) {
  std::string html = "<h2>Before the first program</h2>\n<ul style=\"list-style:none\">\n";
  html +=
      check("Nothing on the table, no tool in the spindle, nothing in the way of any axis inside the travels below.");
  html += check("Spindle and coolant off. No program of the kit starts them.");
  html += check("Compare the control with the list at the end, \"The machine\".");
  html += is_klartext(kit) ? preparation_klartext(kit) : preparation_fanuc(kit);
  html += check("Single block OFF, dry run OFF, mirror image OFF, feed override 100 %, rapid override low.");
  html += check("Record the positions of the axes with a time column (seconds), every 20 ms or more often, as CSV: " +
                columns(kit.machine.setup) + ". A file may hold several programs, in any order.");
  return html + "</ul>\n";
}

std::string travels(const Kit& kit) {
  std::vector<Row> rows{{"Axis", "Least", "Greatest"}};
  for (const auto& [axis, travel] : kit.machine.travels)
    rows.push_back({std::string(1, axis), spec::to_string(travel.least), spec::to_string(travel.greatest)});
  return "<h2>Travels</h2>\n<p>" + std::string(is_klartext(kit) ? "Travels of the tool tip." : "Machine coordinates.") +
         " In the model no program leaves them.</p>\n" + table(rows, 1);
}

std::string tools(const Kit& kit) {
  std::vector<Row> rows{{"Tool", "L", "R", "R2", "DL", "DR", "DR2", "Entered"}};
  for (const spec::ToolRow& row : kit.machine.setup.tools)
    rows.push_back({std::to_string(row.number / 10), row.l ? with_point(*row.l) : "", with_point(row.r),
                    with_point(row.r2), with_point(row.dl), with_point(row.dr), with_point(row.dr2),
                    std::string(kBox)});
  return "<h2>Tools</h2>\n" + table(rows, 1);
}

std::string offsets(const Kit& kit) {
  if (is_klartext(kit)) return tools(kit);
  std::vector<Row> rows{{"Table", "Number", "Geometry", "Wear", "Entered"}};
  const auto add = [&rows](std::string_view name, const std::map<std::uint32_t, spec::OffsetEntry>& entries) {
    for (const auto& [number, entry] : entries)
      rows.push_back({std::string(name), std::to_string(number), spec::to_string(entry.geometry),
                      spec::to_string(entry.wear), std::string(kBox)});
  };
  const bool separate = kit.machine.setup.memory == spec::OffsetMemory::c;
  add(separate ? "H" : "H and D", kit.machine.setup.h);
  if (separate) add("D", kit.machine.setup.d);
  return "<h2>Offsets</h2>\n" + table(rows, 1);
}

std::string program_rows(const Kit& kit, std::size_t group) {
  std::vector<Row> recorded{{"Program", "Cases", "What it shows", "Recorded, file"}};
  std::vector<Row> stopped{{"Program", "What it shows", "Expected stop"}};
  for (const KitProgram& program : kit.programs) {
    if (program.group != group) continue;
    std::set<std::string> shows;
    for (const KitCase& c : program.cases) shows.insert(c.shows.begin(), c.shows.end());
    const std::string shown = clauses_of({shows.begin(), shows.end()});
    if (program.alarm.empty())
      recorded.push_back({name_of(program), std::to_string(program.cases.size()), shown, std::string(kBox)});
    else
      stopped.push_back({name_of(program), shown, fmt::format("an alarm, block {}", program.alarm_n)});
  }
  std::string html;
  if (recorded.size() > 1) html += "<h3>To record</h3>\n" + table(recorded);
  if (stopped.size() > 1)
    html += "<h3>To note</h3>\n<p>Each program stops in an alarm. Note the number and the block in " +
            code(kAlarmForm) +
            " (NONE if it ends without an alarm), then press RESET. Keep a hand on feed hold: a control that raises no "
            "alarm runs on to the end of the program.</p>\n" +
            table(stopped);
  return html;
}

std::string groups(const Kit& kit) {
  std::string html;
  for (std::size_t i = 0; i < kit.groups.size(); ++i) {
    const KitGroup& group = kit.groups[i];
    html += fmt::format("<h2>Part {}: parameters {}</h2>\n", i + 1, escape(to_string(group.parameters)));
    if (!group.parameters.empty()) {
      std::vector<Row> rows{{"Parameter", "Value", "On the machine", "Set", "Set back"}};
      for (const auto& [id, value] : group.parameters)
        rows.push_back({spec::to_string(id), spec::to_string(value),
                        spec::to_string(value_in_force(kit.machine.setup, id)), std::string(kBox), std::string(kBox)});
      html += "<p>Set these parameters with " + code(group.program) +
              ", or by hand if the program cannot set them. After this part set them back.</p>\n" + table(rows, 1);
    }
    html += program_rows(kit, i);
  }
  return html;
}

std::string machine_list(const Kit& kit) {
  std::vector<Row> rows{{"What", "Value", "Checked"}};
  const auto add = [&rows](const std::string& what, const std::string& value) {
    rows.push_back({what, escape(value), std::string(kBox)});
  };
  const spec::Setup& setup = kit.machine.setup;
  add("axes", setup.axes.letters());
  add("units", setup.units == spec::Units::inch ? "inch" : "mm");
  if (!is_klartext(kit)) add("digits after the point", std::to_string(decimals_of(setup, true)));
  for (const auto& [id, value] : setup.parameters) add(spec::to_string(id), spec::to_string(value));
  return "<h2>The machine</h2>\n<p>The control must have these values. The kit changes only what a part above "
         "names.</p>\n" +
         table(rows);
}

std::string missing(const Kit& kit) {
  std::vector<Row> rows{{"Clause outcome", "Why it is not shown"}};
  for (const NotCovered& m : kit.missing) rows.push_back({code(m.outcome) + " " + escape(m.text), escape(m.why)});
  return fmt::format("<h2>What this kit does not show</h2>\n<p>{} of {} clause outcomes.</p>\n", kit.missing.size(),
                     kit.outcomes) +
         table(rows);
}

std::string marks() {
  return fmt::format(
      "<h2>Marks</h2>\n<p>A program begins with {} rests of {} to {} s, which give its number. A case ends with a rest "
      "of {} s, the program with a rest of {} s. <code>kit judge</code> finds programs and cases by these rests, so do "
      "not stop a program in between.</p>\n",
      kDigits, digit_length(0) / 1000.0, digit_length(kBase - 1) / 1000.0, kCaseEnd / 1000.0, kProgramEnd / 1000.0);
}

}  // namespace

std::string write_run_sheet(const Kit& kit) {
  return page("toolcomp kit: run sheet", summary(kit) + preparation(kit) + travels(kit) + groups(kit) + marks() +
                                             offsets(kit) + machine_list(kit) + missing(kit));
}

}  // namespace toolcomp::certify::kit
