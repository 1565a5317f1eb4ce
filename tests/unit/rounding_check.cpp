// SPDX-License-Identifier: Apache-2.0
// The check of the bounds of rounding errors can fail: one spoilt copy for each thing it looks for.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace {

namespace fs = std::filesystem;

class RoundingCheck : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) /
              (std::string("rounding_") + testing::UnitTest::GetInstance()->current_test_info()->name() + "_" +
               std::to_string(::getpid()));
    fs::remove_all(folder_);
    fs::create_directories(folder_ / "source");
    // One script is enough, and quick.
    std::ifstream in(kSource / "direction_one_term.gappa");
    script_ = {std::istreambuf_iterator<char>(in), {}};
    replace("# facts: sine.gappa, cosine.gappa", "# facts: known");
    std::ofstream(folder_ / "source/Facts.v") << "Lemma known : True.\nProof. exact I. Qed.\n";
  }
  void TearDown() override { fs::remove_all(folder_); }

  void replace(const std::string& from, const std::string& to) {
    const std::size_t at = script_.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    script_.replace(at, from.size(), to);
  }
  int check(const std::string& options = "") {
    std::ofstream(folder_ / "source/direction_one_term.gappa") << script_;
    const std::string command = "'" + (kSource / "check").string() + "' " + options + " '" +
                                (folder_ / "build").string() + "' '" + (folder_ / "source").string() +
                                "' >/dev/null 2>'" + (folder_ / "messages").string() + "'";
    const int status = std::system(command.c_str());  // NOLINT(cert-env33-c,concurrency-mt-unsafe): a script of ours
    return status == -1 ? -1 : WEXITSTATUS(status);
  }
  std::string messages() {
    std::ifstream in(folder_ / "messages");
    return {std::istreambuf_iterator<char>(in), {}};
  }
  void expect_refused(const std::string& message, const std::string& options = "") {
    EXPECT_EQ(check(options), 1);
    EXPECT_NE(messages().find(message), std::string::npos) << messages();
  }

  const fs::path kSource = fs::path(TOOLCOMP_SOURCE_DIR) / "spec/formal/rounding";
  fs::path folder_;
  std::string script_;
};

TEST_F(RoundingCheck, AcceptsWhatIsProved) { EXPECT_EQ(check("--coq"), 0) << messages(); }

TEST_F(RoundingCheck, RefusesABoundThatIsNotProved) {
  replace("# bound: 210b-57", "# bound: 110b-57");
  replace("<= 210b-57", "<= 110b-57");
  expect_refused("direction_one_term.gappa: not proved");
}

TEST_F(RoundingCheck, RefusesHypothesesThatContradictEachOther) {
  replace("/\\ |I| <= 1", "/\\ |I| <= 1 /\\ I in [2, 3]");
  expect_refused("direction_one_term.gappa: proves what is false");
}

TEST_F(RoundingCheck, RefusesARuleThatIsNoIdentity) {
  script_ += "\nvalue - I * O -> value - i * O;\n";
  expect_refused("direction_one_term.gappa: not proved");
}

TEST_F(RoundingCheck, RefusesAFactThatIsNowhere) {
  replace("# facts: known", "# facts: known, unknown");
  expect_refused("there is no unknown");
}

TEST_F(RoundingCheck, RefusesAScriptWithoutARefutedBound) {
  replace("# refuted:", "# refused:");
  expect_refused("no bound, or none that is refuted");
}

TEST_F(RoundingCheck, RefusesABoundThatIsNotTheOneConcluded) {
  replace("# bound: 210b-57", "# bound: 211b-57");
  expect_refused("no bound, or none that is refuted");
}

TEST_F(RoundingCheck, RefusesWhatIsAdmitted) {
  std::ofstream(folder_ / "source/Facts.v", std::ios::app) << "Lemma wrong : 1 = 2.\nProof. Admitted.\n";
  expect_refused("assumes without proof");
}

TEST_F(RoundingCheck, RefusesALemmaWhoseProofFails) {
  std::ofstream(folder_ / "source/Facts.v", std::ios::app) << "Lemma wrong : 1 = 2.\nProof. reflexivity. Qed.\n";
  expect_refused("Facts.v: not proved", "--coq");
}

TEST_F(RoundingCheck, RefusesAnAxiomThatIsNotAllowed) {
  std::ofstream(folder_ / "source/Facts.v", std::ios::app)
      << "From Coq Require Import Floats.\nLemma same x : SF2Prim (Prim2SF x) = x.\nProof. exact (SF2Prim_Prim2SF x). "
         "Qed.\n";
  expect_refused("these axioms are not allowed", "--coq");
}

TEST_F(RoundingCheck, BadUsage) {
  const int status = std::system(("'" + (kSource / "check").string() + "' 2>/dev/null").c_str());  // NOLINT(*)
  EXPECT_EQ(WEXITSTATUS(status), 2);
}

}  // namespace
