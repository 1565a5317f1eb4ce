// SPDX-License-Identifier: Apache-2.0
// The text of one event, in the formats that need no other event for it.
#pragma once

#include <string>

#include "cli/verbs.h"
#include "fast/basis/event.h"
#include "fast/basis/print.h"
#include "model/basis/event.h"
#include "model/basis/print.h"
#include "spec/language/event_format.h"
#include "spec/language/setup.h"
#include "spec/language/text_buffer.h"

namespace toolcomp::cli {

// How numbers of the engines are written.
class FastNumber {
 public:
  void operator()(spec::TextCursor& out, double value) const {
    out.write([&](char* to) { return writer_.write(to, value); });
  }

 private:
  mutable fast::NumberWriter writer_;
};
struct ModelNumber {
  int digits = 15;
  void operator()(spec::TextCursor& out, const exact::Real& value) const {
    std::string number;
    model::append_number(number, value, digits);
    out.append(number);
  }
};

class EventText {
 public:
  // `format`: jsonl or csv. The setup is kept by reference.
  EventText(const spec::Setup& setup, Format format) : setup_(setup), format_(format) {}

  template <class Number, class AppendNumber>
  [[gnu::flatten]] void append(spec::TextBuffer& to, const spec::Event<Number>& event,
                               const AppendNumber& number) const {
    spec::TextCursor out(to);
    if (format_ == Format::jsonl) {
      spec::append_event_json(out, event, setup_.axes, number);
      out += '\n';
    } else {
      spec::append_event_csv(out, event, setup_.axes, number, setup_.control);
    }
  }

 private:
  const spec::Setup& setup_;
  Format format_;
};

}  // namespace toolcomp::cli
