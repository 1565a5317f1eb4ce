// SPDX-License-Identifier: Apache-2.0
// judge_stream (fuzz/oracle/verdict.h) on several processors.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fuzz/oracle/epoch.h"
#include "fuzz/oracle/verdict.h"
#include "model/basis/recorder.h"
#include "spec/language/fields.h"

namespace toolcomp::fuzz {

struct JudgeInPieces {
  unsigned jobs = 1;
  // Sizes, in blocks: a piece is a whole number of epochs. Tests make them small.
  std::uint64_t epoch = kBlocksInEpoch;
  std::uint64_t epochs_in_piece = 24;
  // So many blocks a model runs before its events are judged, where it begins in the middle, besides those of Lead.
  std::uint64_t lead = 64;
  std::size_t* wrong = nullptr;  // gets how many guesses were wrong
  // For tests: in_pieces.h.
  std::function<bool(const std::string& ended, const std::string& begun)> same = std::equal_to<>();
};

// The same verdict. The fast engine runs in one thread, in the order of the program. The model and the judge run piece
// by piece: each begins in the middle with the blocks of Lead (lead.h), and its piece counts where everything it knew
// there is what the piece before it ended with (in_pieces.h). A difference beside a near tie is settled by
// judge_stream. A program that can be read only once is judged by judge_stream.
Verdict judge_in_pieces(const StreamedProgram& program, const spec::Setup& setup, std::uint32_t samples,
                        const JudgeInPieces& options, void (*on_block)(std::uint64_t) = nullptr);

// What a case comes to beside its verdict.
struct Counted {
  std::vector<model::ClauseCount> clauses;  // as the recorder of a ModelRun counts them
  spec::FieldSet fields;                    // that the model's events have
};
// Adds the fields of an event.
using FieldsOf = void (*)(spec::FieldSet& fields, const model::Event& event);

struct Agreed {
  Verdict verdict;
  Counted counted;
};

// What judge() says of a case where the events agree as they are, in bounded memory. Nothing in every other case, which
// is to be judged with the whole run at hand: a difference (be it that of a near tie taken otherwise), a program that
// is left open or goes beyond what is supported, rounded numbers, samples that are not judged.
//
// Of the fast engine, which runs in here.
std::optional<Agreed> agreement_in_pieces(const spec::Case& c, const JudgeInPieces& options);
// Of a controller's events.
std::optional<Agreed> agreement_in_pieces(const spec::Case& c, std::span<const spec::TextEvent> events,
                                          const JudgeOptions& judged, FieldsOf fields_of, const JudgeInPieces& options);

}  // namespace toolcomp::fuzz
