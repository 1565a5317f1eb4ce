// SPDX-License-Identifier: Apache-2.0
// What a search over one section has met.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "corpus/mine/mine.h"

namespace toolcomp::corpus {

// Looks at every decision of every run. Used by one thread.
class Harvest {
 public:
  // Runs the model. What is nearer to a boundary than anything before goes through both engines, and is kept if they
  // agree. Nothing where the setup or the program is refused. `found` is where it comes from.
  std::optional<fuzz::ModelRun> look(const spec::Case& c, const std::string& found);
  // The same through both engines, for deviations; nothing where that is no measure: they do not agree, or a value is
  // granted more than a micrometre.
  std::optional<fuzz::Verdict> judge(const spec::Case& c, const std::string& found);

  // Leaves out of the programs what nothing hangs on.
  void shorten();

  [[nodiscard]] std::uint64_t runs() const { return runs_; }
  [[nodiscard]] std::uint64_t not_searched() const { return not_searched_; }
  // Runs in which a clause was decided by sign.
  [[nodiscard]] const std::map<spec::Clause, std::uint64_t>& decided() const { return decided_; }
  [[nodiscard]] std::vector<Nearest> nearest() const;
  [[nodiscard]] std::vector<Worst> worst() const;
  [[nodiscard]] std::vector<Met> differ() const { return values(differ_); }
  [[nodiscard]] std::vector<Met> undecided() const { return values(undecided_); }

 private:
  // Clause, outcome, and whether no number is finer than usual.
  using Key = std::tuple<spec::Clause, exact::Sign, bool>;
  struct Kept {
    double margin = 0;
    spec::Case c;
    std::string found;
  };

  void take(const fuzz::ModelRun& run, const spec::Case& c, const std::string& found);
  bool agrees(const fuzz::Trial& trial, const spec::Case& c);
  void worse(const fuzz::Verdict& verdict, const spec::Case& c, const std::string& found);
  static std::vector<Met> values(const std::map<std::string, Met>& met);

  std::map<Key, Kept> kept_;
  std::map<Deviation, Kept> worst_;
  std::map<spec::Clause, std::uint64_t> decided_;
  std::map<std::string, Met> differ_;
  std::map<std::string, Met> undecided_;
  std::uint64_t runs_ = 0;
  std::uint64_t not_searched_ = 0;
};

}  // namespace toolcomp::corpus
