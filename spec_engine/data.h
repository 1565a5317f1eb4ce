// SPDX-License-Identifier: Apache-2.0
// Plain data between C++ and OCaml. The kinds are the constructors of `data` in run.ml, in their order.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "model/exact/real.h"

namespace toolcomp::spec_engine {

struct Data;
using List = std::vector<Data>;

struct Data {
  std::variant<exact::Real, std::int64_t, std::string, List> value;

  Data(exact::Real number) : value(std::move(number)) {}  // NOLINT(google-explicit-constructor)
  Data(std::int64_t integer) : value(integer) {}          // NOLINT(google-explicit-constructor)
  Data(std::string text) : value(std::move(text)) {}      // NOLINT(google-explicit-constructor)
  Data(List list) : value(std::move(list)) {}             // NOLINT(google-explicit-constructor)

  [[nodiscard]] const exact::Real& number() const { return std::get<exact::Real>(value); }
  [[nodiscard]] std::int64_t integer() const { return std::get<std::int64_t>(value); }
  [[nodiscard]] const std::string& text() const { return std::get<std::string>(value); }
  [[nodiscard]] const List& list() const { return std::get<List>(value); }
};

// The function `run` of run.ml, of a case.
Data run_case(const Data& c);

}  // namespace toolcomp::spec_engine
