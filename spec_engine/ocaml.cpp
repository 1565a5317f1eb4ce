// SPDX-License-Identifier: Apache-2.0
// The C interface of OCaml: numbers for the extracted specification, and data to it and back.
#define CAML_NAME_SPACE
#include <caml/alloc.h>
#include <caml/callback.h>
#include <caml/custom.h>
#include <caml/fail.h>
#include <caml/memory.h>
#include <caml/mlvalues.h>

#include <mutex>
#include <new>
#include <ranges>
#include <stdexcept>

#include "model/exact/alike.h"
#include "spec_engine/data.h"

namespace toolcomp::spec_engine {
namespace {

using exact::Real;

// A number is a block of OCaml with a Real in it: a reference that may be moved byte by byte, counted in C++.
Real& real_of(value v) { return *static_cast<Real*>(Data_custom_val(v)); }

void finalize(value v) { real_of(v).~Real(); }

custom_operations operations() {
  custom_operations ops{};
  ops.identifier = "toolcomp.real";
  ops.finalize = finalize;
  return ops;
}

value box(Real number) {
  static custom_operations ops = operations();
  // Nodes are some hundred bytes: the collector hears of them.
  constexpr mlsize_t kMemory = 200;
  constexpr mlsize_t kMost = 50'000'000;
  const value v = caml_alloc_custom(&ops, sizeof(Real), kMemory, kMost);
  new (Data_custom_val(v)) Real(std::move(number));
  return v;
}

// Of an operation that may not be decided; nothing of C++ may leave through OCaml, and nothing may be left undestroyed
// where OCaml raises.
template <class Operation>
value result_of(Operation operation) {
  bool decided = true;
  try {
    return box(operation());
  } catch (const exact::Undecided&) {
    decided = false;
  } catch (const std::domain_error&) {
    decided = false;
  }
  if (!decided) caml_raise_constant(*caml_named_value("toolcomp_spec_engine_undecided"));
  return Val_unit;
}

// Nothing has to be made of a zero: most of a vector often is one.
bool is_zero(value v) {
  const Real& x = real_of(v);
  return x.is_rational() && x.sign() == exact::Sign::zero;
}

enum Kind : int { kNumber, kInteger, kText, kList };

value to_ocaml(const Data& data) {
  CAMLparam0();
  CAMLlocal3(content, cell, item);
  const int kind = static_cast<int>(data.value.index());
  switch (kind) {
    case kNumber:
      content = box(data.number());
      break;
    case kInteger:
      content = Val_long(data.integer());
      break;
    case kText:
      content = caml_alloc_initialized_string(data.text().size(), data.text().data());
      break;
    default:
      content = Val_emptylist;
      for (const Data& entry : std::views::reverse(data.list())) {
        item = to_ocaml(entry);
        cell = caml_alloc(2, 0);
        Store_field(cell, 0, item);
        Store_field(cell, 1, content);
        content = cell;
      }
  }
  cell = caml_alloc(1, static_cast<tag_t>(kind));
  Store_field(cell, 0, content);
  CAMLreturn(cell);
}

Data from_ocaml(value v) {
  const value content = Field(v, 0);
  switch (Tag_val(v)) {
    case kNumber:
      return real_of(content);
    case kInteger:
      return static_cast<std::int64_t>(Long_val(content));
    case kText:
      return std::string(String_val(content), caml_string_length(content));
    default:
      break;
  }
  List list;
  for (value at = content; at != Val_emptylist; at = Field(at, 1)) list.push_back(from_ocaml(Field(at, 0)));
  return list;
}

value call(const Data& c) {
  CAMLparam0();
  CAMLlocal2(tree, result);
  tree = to_ocaml(c);
  result = caml_callback_exn(*caml_named_value("toolcomp_spec_engine_run"), tree);
  CAMLreturn(result);
}

}  // namespace

Data run_case(const Data& c) {
  static std::once_flag started;
  std::call_once(started, [] {
    static char name[] = "toolcomp";
    static char* arguments[] = {name, nullptr};
    caml_startup(arguments);
  });
  const value result = call(c);
  if (Is_exception_result(result)) throw std::logic_error("the formal specification raised an exception");
  return from_ocaml(result);
}

}  // namespace toolcomp::spec_engine

using toolcomp::spec_engine::box;
using toolcomp::spec_engine::is_zero;
using toolcomp::spec_engine::real_of;
using toolcomp::spec_engine::result_of;

extern "C" {

value toolcomp_spec_engine_integer(value i) {
  return box(toolcomp::exact::Real(toolcomp::exact::Rational(static_cast<long long>(Long_val(i)))));
}
value toolcomp_spec_engine_plus(value a, value b) {
  if (is_zero(a)) return b;
  if (is_zero(b)) return a;
  return result_of([&] { return real_of(a) + real_of(b); });
}
// What is made alike is equal, where no sign of a difference would ever be certified too.
value toolcomp_spec_engine_minus(value a, value b) {
  if (is_zero(b)) return a;
  return result_of([&] {
    const auto& x = real_of(a);
    const auto& y = real_of(b);
    return !x.is_rational() && toolcomp::exact::alike(x, y) ? toolcomp::exact::Real() : x - y;
  });
}
value toolcomp_spec_engine_times(value a, value b) {
  if (is_zero(a)) return a;
  if (is_zero(b)) return b;
  return result_of([&] { return real_of(a) * real_of(b); });
}
value toolcomp_spec_engine_over(value a, value b) {
  return result_of([&] { return real_of(a) / real_of(b); });
}
value toolcomp_spec_engine_root(value a) {
  return result_of([&] { return sqrt(real_of(a)); });
}
value toolcomp_spec_engine_sine(value a) {
  return result_of([&] { return toolcomp::exact::sin_real_degrees(real_of(a)); });
}
value toolcomp_spec_engine_cosine(value a) {
  return result_of([&] { return toolcomp::exact::cos_real_degrees(real_of(a)); });
}
value toolcomp_spec_engine_half_turn(value /*unit*/) {
  return result_of([] { return toolcomp::exact::pi(); });
}
value toolcomp_spec_engine_arctangent(value a) {
  return result_of([&] { return toolcomp::exact::arctangent_degrees(real_of(a)); });
}
value toolcomp_spec_engine_sign(value a) {
  constexpr int kUndecided = 2;
  try {
    return Val_int(static_cast<int>(real_of(a).sign()));
  } catch (const toolcomp::exact::Undecided&) {
    return Val_int(kUndecided);
  }
}

}  // extern "C"
