// SPDX-License-Identifier: Apache-2.0
// Wrong clauses that both engines follow alike. Each engine stays as it is: a program or a setup is altered behind its
// back, so both run the wrong thing and agree, and the events are held against the case as it was written. Only a law
// can find it.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "judge/oracle/trial.h"

namespace toolcomp::fuzz {

struct WrongClause {
  std::string_view name;
  std::string_view section;  // whose directed generator must find it
  std::string_view law;      // that must find it first
  std::uint64_t budget;      // executions, fresh cases of one seed
  // The case that both engines run instead; nothing: the case itself.
  spec::Case (*altered)(const spec::Case&);
  // What is wrong in the events of both; nothing: the altered case says it all.
  void (*events)(const spec::Case&, std::vector<model::Event>&);
};

// Which law finds which after how many executions: judge/laws/README.md; tests/harness/laws.cpp prints it.
std::span<const WrongClause> wrong_clauses();

// The case through both engines with the wrong clause, judged, and held against the laws.
judge::Trial try_wrong(const WrongClause& wrong, const spec::Case& c);

}  // namespace toolcomp::fuzz
