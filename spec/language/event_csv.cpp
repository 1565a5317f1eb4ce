// SPDX-License-Identifier: Apache-2.0
#include "spec/language/event_csv.h"

namespace toolcomp::spec {

void append_csv_text(std::string& out, std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) {
    out += text;
    return;
  }
  out += '"';
  for (const char c : text) {
    if (c == '"') out += '"';
    out += c;
  }
  out += '"';
}

void append_csv_header(std::string& out, const Axes& axes, Control control) {
  const auto columns = [&](std::string_view field, bool linear_only) {
    for (const char letter : axes.letters()) {
      if (linear_only && !is_linear_axis(letter)) continue;
      out += field;
      out += '.';
      out += letter;
      out += ',';
    }
  };
  out += "kind,line,n,type,cause,";
  columns("programmed", true);
  columns("point", true);
  columns("axes", false);
  columns("machine", false);
  out += "tool_axis.i,tool_axis.j,tool_axis.k,";
  columns("center", true);
  out += "plane,direction,sweep,radius.start,radius.end,";
  const bool space = control == Control::heidenhain;
  if (space)
    out +=
        "tool_center.X,tool_center.Y,tool_center.Z,contact.X,contact.Y,contact.Z,normal.i,normal.j,normal.k,"
        "shift.X,shift.Y,shift.Z,tool_shift.X,tool_shift.Y,tool_shift.Z,carrier.X,carrier.Y,carrier.Z,angle,flat,";
  out += space ? "feed,unknown,number,message,name,value," : "feed,number,message,name,value,";
  out += "r,bottom,return,t,";
  out += space ? "reason,clauses\n" : "clauses\n";
}

}  // namespace toolcomp::spec
