// SPDX-License-Identifier: Apache-2.0
#include "certify/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string_view>

#include "certify/markup.h"
#include "certify/view/assets.h"
#include "certify/view/view.h"

namespace toolcomp::certify {
namespace {

// Nothing is asked of any other place, whatever a browser or a text in the page may want.
constexpr std::string_view kPolicy =
    "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; base-uri 'none'; form-action 'none'";

constexpr std::string_view kStyle = R"(
:root{--ink:#1f2328;--soft:#57606a;--line:#d0d7de;--paper:#fff;--panel:#f6f8fa;--good:#1a7f37;--bad:#cf222e;--open:#9a6700;--hit:#fff1c2}
@media(prefers-color-scheme:dark){:root{--ink:#e6edf3;--soft:#9aa4af;--line:#30363d;--paper:#0d1117;--panel:#161b22;--good:#3fb950;--bad:#ff7b72;--open:#d29922;--hit:#4b3a00}}
*{box-sizing:border-box}
body{margin:0 auto;max-width:72rem;padding:1rem;font:16px/1.5 system-ui,sans-serif;color:var(--ink);background:var(--paper)}
h1{font-size:1.6rem;margin:.5rem 0;overflow-wrap:anywhere}h2{font-size:1.25rem;margin:2rem 0 .5rem;border-bottom:1px solid var(--line)}h3{font-size:1.05rem;margin:1.2rem 0 .3rem}
p{margin:.4rem 0}code,pre{font:13px/1.45 ui-monospace,monospace}code{overflow-wrap:anywhere}
pre{background:var(--panel);border:1px solid var(--line);border-radius:6px;padding:.6rem;overflow-x:auto;margin:.5rem 0}
pre span{display:block}pre .hit{background:var(--hit)}pre i{display:inline-block;min-width:2.2em;color:var(--soft);font-style:normal;text-align:right;padding-right:.8em;user-select:none}
.wide{overflow-x:auto}table{border-collapse:collapse;font-size:14px;width:100%;margin:.5rem 0}
th,td{border:1px solid var(--line);padding:.25rem .5rem;text-align:left;vertical-align:top}th{background:var(--panel)}td.n,th.n{text-align:right;font-variant-numeric:tabular-nums}td.n{white-space:nowrap}
dl{display:grid;grid-template-columns:max-content 1fr;gap:.15rem 1rem;margin:.5rem 0}dt{color:var(--soft)}dd{margin:0;overflow-wrap:anywhere}
.badge{display:inline-block;border-radius:1em;padding:.05em .7em;border:1px solid currentColor;font-weight:600}.good{color:var(--good)}.bad{color:var(--bad)}.open{color:var(--open)}
article{border:1px solid var(--line);border-radius:8px;padding:.2rem 1rem 1rem;margin:1rem 0}details{margin:.4rem 0}summary{cursor:pointer}
svg{max-width:100%;height:auto}.soft{color:var(--soft)}nav{margin:1.5rem 0 0}nav a{margin-right:1rem}a{color:inherit}
.sign{display:grid;grid-template-columns:repeat(3,1fr);gap:1.5rem;margin-top:4rem}.sign span{border-top:1px solid var(--ink);padding-top:.2rem;font-size:13px}
:focus-visible{outline:3px solid #0969da;outline-offset:2px}
@media(max-width:40rem){dl{grid-template-columns:1fr}dt{margin-top:.4rem}article{padding:.2rem .6rem .6rem}
.wide thead{display:none}.wide tr{display:block;border:1px solid var(--line);border-radius:6px;margin:.5rem 0;padding:.2rem .5rem}.wide td{display:flex;justify-content:space-between;gap:1rem;border:0;padding:.1rem 0;overflow-wrap:anywhere;min-width:0}.wide td.n{white-space:normal}.wide td[data-label]::before{content:attr(data-label);color:var(--soft);flex:none;max-width:45%}}
@page{margin:15mm}
@media print{:root{color-scheme:light}body{max-width:none;padding:0;font-size:10.5pt}code,pre{font-size:8.5pt}table{font-size:8.5pt}.first{break-after:page}.first h2{margin:.8rem 0 .3rem}
thead{display:table-header-group}tr,svg,.sign{break-inside:avoid}h2,h3{break-after:avoid}.wide{overflow:visible}pre{white-space:pre-wrap;overflow-wrap:anywhere}nav{display:none}
details::details-content{content-visibility:visible;display:block;block-size:auto}}
)";

std::string joined(std::span<const std::string_view> pieces) {
  std::string out;
  for (const std::string_view piece : pieces) out += piece;
  return out;
}

}  // namespace

std::string page(std::string_view title, std::string_view body, const PageOptions& options) {
  std::string out = "<!DOCTYPE html>\n<html lang=\"en\"";
  if (!options.live.empty()) out += " data-live=\"" + escape(options.live) + "\"";
  out += ">\n<head>\n<meta charset=\"utf-8\"/>\n<meta name=\"generator\" content=\"toolcomp\"/>\n";
  out += "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n";
  out += R"(<meta http-equiv="Content-Security-Policy" content=")" + std::string(kPolicy) +
         (options.live.empty() ? "" : "; connect-src 'self'") + "\"/>\n";
  const bool moves = has_view(body) || !options.live.empty();
  out += "<title>" + escape(title) + "</title>\n<style>" + std::string(kStyle) + (moves ? joined(view_style()) : "") +
         "</style>\n</head>\n<body" + (options.fills_window ? " class=\"fills\"" : "") + ">\n";
  out += body;
  if (moves) out += "<script>" + joined(view_script()) + "</script>\n";
  return out + "</body>\n</html>\n";
}

std::string table(const std::vector<Row>& rows, std::size_t numbers_from) {
  std::string out = "<div class=\"wide\"><table>\n";
  for (std::size_t r = 0; r < rows.size(); ++r) {
    if (r == 0) out += "<thead>";
    if (r == 1) out += "<tbody>";
    out += "<tr>";
    const std::string_view cell = r == 0 ? "th" : "td";
    for (std::size_t c = 0; c < rows[r].size(); ++c)
      out += fmt::format("<{0}{1}{2}>{3}</{0}>", cell, c >= numbers_from ? R"( class="n")" : "",
                         r == 0 || c == 0 ? "" : " data-label=\"" + rows[0][c] + "\"", rows[r][c]);
    out += "</tr>";
    if (r == 0) out += "</thead>";
    out += '\n';
  }
  return out + (rows.size() > 1 ? "</tbody>" : "") + "</table></div>\n";
}

std::string listing(std::string_view program, std::uint64_t marked) {
  std::string out = "<pre>";
  for (std::uint64_t line = 1; !program.empty(); ++line) {
    const std::size_t end = std::min(program.find('\n'), program.size());
    out += line == marked ? "<span class=\"hit\">" : "<span>";
    out += "<i>" + std::to_string(line) + "</i>" + escape(program.substr(0, end)) + "</span>";
    program.remove_prefix(std::min(end + 1, program.size()));
  }
  return out + "</pre>\n";
}

std::string facts(const std::vector<Row>& rows) {
  std::string out = "<dl>\n";
  for (const Row& row : rows) out += "<dt>" + row.at(0) + "</dt><dd>" + row.at(1) + "</dd>\n";
  return out + "</dl>\n";
}

std::string badge(std::string_view text, Tone tone) {
  const std::string_view style = tone == Tone::good ? "good" : tone == Tone::bad ? "bad" : "open";
  return "<span class=\"badge " + std::string(style) + "\">" + escape(text) + "</span>";
}

}  // namespace toolcomp::certify
