// SPDX-License-Identifier: Apache-2.0
#include "spec/language/case_format.h"
#include "spec/language/event_json.h"
#include "spec/language/number_text.h"
#include "spec/language/setup_format.h"

namespace toolcomp::spec {
namespace {

// What stands between the parts of a case.
struct Layout {
  std::string_view open, next, close;  // of the object
  std::string_view colon;
  std::string_view open_list, next_event, close_list;  // of expect
};
constexpr Layout kLine = {"{", ",", "}", ":", "[", ",", "]"};
constexpr Layout kPretty = {"{\n  ", ",\n  ", "\n}\n", ": ", "[\n    ", ",\n    ", "\n  ]"};

class CaseWriter {
 public:
  explicit CaseWriter(const Layout& layout) : layout_(layout) {}

  std::string write(const Case& c) {
    key("case");
    out_ += '1';
    text("id", c.id);
    text("section", c.section);
    if (!c.comment.empty()) text("comment", c.comment);
    texts("clauses", c.clauses);
    texts("flags", c.flags);
    text("dialect", c.dialect);
    key("setup");
    out_ += write_setup_json(c.setup);
    text("program", c.program);
    if (c.samples != 0) {
      key("samples");
      append_integer(out_, c.samples);
    }
    if (c.source != CaseSource{}) source(c.source);
    if (c.has_expect) expect(c);
    out_ += layout_.close;
    return std::move(out_);
  }

 private:
  void key(std::string_view name) {
    out_ += first_ ? layout_.open : layout_.next;
    first_ = false;
    append_json_string(out_, name);
    out_ += layout_.colon;
  }

  void text(std::string_view name, std::string_view value) {
    key(name);
    append_json_string(out_, value);
  }

  void texts(std::string_view name, const std::vector<std::string>& list) {
    if (list.empty()) return;
    key(name);
    char separator = '[';
    for (const std::string& item : list) {
      out_ += separator;
      append_json_string(out_, item);
      separator = ',';
    }
    out_ += ']';
  }

  void source(const CaseSource& value) {
    key("source");
    out_ += "{\"generator\":";
    append_json_string(out_, value.generator);
    out_ += ",\"version\":";
    append_json_string(out_, value.version);
    out_ += ",\"seed\":";
    append_json_string(out_, value.seed);
    out_ += '}';
  }

  void expect(const Case& c) {
    key("expect");
    if (c.expect.empty()) {
      out_ += "[]";
      return;
    }
    std::string_view separator = layout_.open_list;
    for (const TextEvent& event : c.expect) {
      out_ += separator;
      append_event_json(out_, event, c.setup.axes, append_number_text);
      separator = layout_.next_event;
    }
    out_ += layout_.close_list;
  }

  const Layout& layout_;
  std::string out_;
  bool first_ = true;
};

}  // namespace

std::string write_case(const Case& c) { return CaseWriter(kPretty).write(c); }
std::string write_case_line(const Case& c) { return CaseWriter(kLine).write(c); }

}  // namespace toolcomp::spec
