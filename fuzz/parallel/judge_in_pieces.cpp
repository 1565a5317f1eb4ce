// SPDX-License-Identifier: Apache-2.0
#include "fuzz/parallel/judge_in_pieces.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "fuzz/parallel/in_pieces.h"
#include "fuzz/parallel/lead.h"
#include "fuzz/parallel/piece_pass.h"
#include "model/basis/clause_counts.h"
#include "spec/language/fanuc/not_supported.h"
#include "spec/language/heidenhain/unsupported.h"

namespace toolcomp::fuzz {
namespace {

// Reads, and runs the fast engine where it is the one that is judged.
template <class Control>
class PieceReader {
  using Block = typename Control::Block;

 public:
  PieceReader(const StreamedProgram& program, const PieceRules& rules, const JudgeInPieces& options, bool fast)
      : reader_(Control::reader(program.open(), rules.setup, program.name, program.called_program)),
        epoch_(options.epoch),
        size_(options.epoch * options.epochs_in_piece),
        lead_blocks_(options.lead),
        lead_(options.epoch + options.lead) {
    if (fast) fast_ = std::make_unique<Fast>(rules, sink_);
    advance();
  }

  std::unique_ptr<Piece> next() {
    if (ended_) return nullptr;
    auto piece = std::make_unique<ProgramPiece<Control>>();
    piece->first = count_;
    piece->facts = facts_;
    if (count_ != 0) {
      piece->lead = lead_.blocks();
      piece->lead_judged = latest_judged_;
      piece->fast_lead = std::move(latest_);
    }
    piece->fast.runs = size_ + 1;
    piece->fast.events.reserve(size_ + size_ / 8);
    piece->fast.ends.reserve(size_);
    piece->blocks.reserve(size_);
    while (there_ && piece->blocks.size() < size_) run(*piece);
    piece->last = !there_;
    if (there_) {
      piece->next_line = block_->line;
      latest_judged_ = std::min<std::size_t>(piece->blocks.size(), epoch_ + lead_blocks_ / 2);
      if (fast_) keep_latest(piece->fast);
    } else {
      ended_ = true;
      piece->unreadable = unreadable_;
      sink_.to = &piece->fast.at_end;
      if (fast_ && !unreadable_) fast_->engine.end();
    }
    return piece;
  }

 private:
  struct Sink final : fast::EventSink {
    void on(const fast::Event& event) override { to->push_back(event); }
    std::vector<fast::Event>* to = nullptr;
  };

  struct Fast {
    Fast(const PieceRules& rules, Sink& sink) : engine(Control::fast(rules.setup, sink, rules.samples)) {}
    typename Control::Fast engine;
  };

  void advance() {
    try {
      there_ = reader_.next(*block_);
    } catch (...) {
      unreadable_ = std::current_exception();
      there_ = false;
    }
  }

  // The block at hand.
  void run(ProgramPiece<Control>& piece) {
    if (fast_ && fast_->engine.stopped()) piece.fast.runs = std::min(piece.fast.runs, piece.blocks.size());
    piece.blocks.add(*block_);
    facts_.read(*block_);
    if (fast_) {
      sink_.to = &piece.fast.events;
      fast_->engine.block(*block_);
      piece.fast.ends.push_back(piece.fast.events.size());
      if (fast_->engine.stopped()) piece.fast.runs = std::min(piece.fast.runs, piece.blocks.size());
    } else {
      piece.beyond = piece.beyond || not_supported(*block_) != nullptr;
    }
    lead_.add(*block_);
    ++count_;
    advance();
  }

  // What the fast engine gave for the last epoch, and for some blocks before: the judge has looked at numbers that
  // decisions of the epoch are made of.
  void keep_latest(const FastRun& run) {
    const std::size_t kept = latest_judged_;
    const std::size_t from = run.ends.size() - kept;
    const std::size_t begin = from == 0 ? 0 : run.ends[from - 1];
    latest_.events.assign(run.events.begin() + static_cast<std::ptrdiff_t>(begin), run.events.end());
    latest_.ends.clear();
    for (std::size_t i = from; i < run.ends.size(); ++i) latest_.ends.push_back(run.ends[i] - begin);
    latest_.runs = run.runs > run.ends.size() ? kept + 1 : run.runs < from ? 0 : run.runs - from;
  }

  Sink sink_;
  typename Control::Reader reader_;
  std::unique_ptr<Fast> fast_;
  std::uint64_t epoch_;
  std::uint64_t size_;
  std::uint64_t lead_blocks_;
  Lead<Block> lead_;
  std::size_t latest_judged_ = 0;
  FastRun latest_;
  ProgramFacts facts_;
  std::unique_ptr<Block> block_ = std::make_unique<Block>();
  bool there_ = false;
  bool ended_ = false;
  std::exception_ptr unreadable_;
  std::uint64_t count_ = 0;
};

// Adds what a later piece was judged to be; the outcome is that of the latest.
void add(Verdict& all, bool scope_left, const PieceVerdict& piece) {
  const Verdict& v = piece.verdict;
  all.values += v.values;
  all.numbers += v.numbers;
  all.wide += v.wide;
  all.widths.add(v.widths);
  all.out_of_scope += scope_left ? v.events : v.out_of_scope;
  all.events += v.events;
  all.decisions += v.decisions;
  all.near_ties += v.near_ties;
  all.worst_ulp = std::max(all.worst_ulp, v.worst_ulp);
  all.worst_um = std::max(all.worst_um, v.worst_um);
  all.bias.add(v.bias);
  all.outcome = v.outcome;
  all.difference = v.difference;
  all.undecided = v.undecided;
  if (all.outcome == Outcome::nothing_judged && all.values > 0) all.outcome = Outcome::agrees;
}

// All pieces together.
struct Whole {
  Verdict verdict;
  Counted counted;
  bool near_tie = false;  // beside a difference
};

template <class Control, class Given>
Whole judge(const StreamedProgram& program, const PieceRules& rules, const typename Given::Origin& origin,
            const JudgeInPieces& options, void (*on_block)(std::uint64_t)) {
  using Pass = PiecePass<Control, Given>;
  // A setup that both engines refuse is refused by the model, as in one thread.
  static_cast<void>(Pass(rules, origin));
  PieceReader<Control> reader(program, rules, options, std::is_same_v<typename Given::Number, double>);
  Whole all;
  all.counted.clauses.resize(spec::kClauseCount);
  std::size_t events = 0;
  std::uint64_t blocks = 0;
  bool scope_left = false;
  InPieces work;
  work.jobs = options.jobs;
  work.same = options.same;
  work.next = [&] { return reader.next(); };
  work.begin = [&](const Piece& piece, bool first) -> std::unique_ptr<PieceWork> {
    const auto& here = static_cast<const ProgramPiece<Control>&>(piece);
    if (first) return std::make_unique<Pass>(rules, origin);
    return begin_by(here.lead, options.epoch + options.lead, options.lead / 2,
                    [&](const auto& lead) -> std::unique_ptr<Pass> {
                      auto pass = std::make_unique<Pass>(rules, origin);
                      return pass->begin(here, lead) ? std::move(pass) : nullptr;
                    });
  };
  work.take = [&](PieceResult& result) {
    auto& piece = static_cast<PieceVerdict&>(result);
    if (piece.unreadable) std::rethrow_exception(piece.unreadable);
    add(all.verdict, scope_left, piece);
    if (all.verdict.difference) all.verdict.difference->event += events;
    model::add(all.counted.clauses, piece.counted.clauses);
    all.counted.fields.add(piece.counted.fields);
    events += piece.events;
    blocks += piece.blocks;
    scope_left = scope_left || piece.scope_left;
    all.near_tie = piece.near_tie;
    if (on_block != nullptr) on_block(blocks);
    return !piece.over;
  };
  const std::size_t wrong = in_pieces(work);
  if (options.wrong != nullptr) *options.wrong = wrong;
  return all;
}

template <template <class> class Given>
std::optional<Agreed> agreement(const spec::Case& c, PieceRules rules, const auto& origin,
                                const JudgeInPieces& options) {
  rules.samples = c.samples;
  rules.epoch = options.epoch;
  rules.counts = true;
  const StreamedProgram program{[&c] { return spec::text_source(c.program); }};
  Whole whole = with_control(c.setup, [&]<class Control>(Control) {
    using OfBlocks = Given<typename Control::Block>;
    return judge<Control, OfBlocks>(program, rules, origin, options, nullptr);
  });
  const Outcome outcome = whole.verdict.outcome;
  if (outcome != Outcome::agrees && outcome != Outcome::nothing_judged) return std::nullopt;
  return Agreed{std::move(whole.verdict), std::move(whole.counted)};
}

}  // namespace

Verdict judge_in_pieces(const StreamedProgram& program, const spec::Setup& setup, std::uint32_t samples,
                        const JudgeInPieces& options, void (*on_block)(std::uint64_t)) {
  if (options.jobs > 1 && !program.once) {
    const PieceRules rules{Rules(setup, {}, {}), setup, samples, options.epoch};
    Whole whole = with_control(setup, [&]<class Control>(Control) {
      using Given = GivenByEngine<typename Control::Block>;
      return judge<Control, Given>(program, rules, {}, options, on_block);
    });
    if (!whole.near_tie) return std::move(whole.verdict);
  }
  return judge_stream(program, setup, samples, on_block);
}

std::optional<Agreed> agreement_in_pieces(const spec::Case& c, const JudgeInPieces& options) {
  return agreement<GivenByEngine>(c, {Rules(c.setup, c.section, {}), c.setup}, EngineOrigin(), options);
}

std::optional<Agreed> agreement_in_pieces(const spec::Case& c, std::span<const spec::TextEvent> events,
                                          const JudgeOptions& judged, FieldsOf fields_of,
                                          const JudgeInPieces& options) {
  PieceRules rules{Rules(c.setup, c.section, judged), c.setup};
  if (rules.rules.rounds() || (c.samples > 0 && !rules.rules.judges("t"))) return std::nullopt;
  rules.fields_of = fields_of;
  return agreement<GivenAsList>(c, std::move(rules), ListOrigin{events, c.setup.axes}, options);
}

}  // namespace toolcomp::fuzz
