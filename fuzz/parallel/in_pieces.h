// SPDX-License-Identifier: Apache-2.0
// A long piece of work, done in pieces side by side, with what one thread would give.
//
// The pieces come in order from one thread. Each is worked on from a start that is guessed, and the state of the work
// is written down there and behind the piece. A piece counts only where the state it was begun with is, byte by byte,
// the state in which the piece before it ended; where it is not, who did the piece before goes on with this one. So a
// wrong guess costs time, and nothing else.
#pragma once

#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <memory>
#include <string>

namespace toolcomp::fuzz {

class Piece {
 public:
  Piece() = default;
  Piece(const Piece&) = delete;
  Piece& operator=(const Piece&) = delete;
  virtual ~Piece() = default;
};

// What a piece has given.
class PieceResult {
 public:
  PieceResult() = default;
  PieceResult(const PieceResult&) = delete;
  PieceResult& operator=(const PieceResult&) = delete;
  virtual ~PieceResult() = default;
};

// Work at one place of the whole, in one thread from its making to its end.
class PieceWork {
 public:
  PieceWork() = default;
  PieceWork(const PieceWork&) = delete;
  PieceWork& operator=(const PieceWork&) = delete;
  virtual ~PieceWork() = default;
  // All of what comes depends on: the beginning of the next piece.
  [[nodiscard]] virtual std::string state() const = 0;
  // The next piece, from where this stands. An exception is the piece's result. Ends early where `stop` is set; the
  // result is then not asked for.
  virtual std::unique_ptr<PieceResult> run(const Piece& piece, const std::atomic<bool>& stop) = 0;
};

struct InPieces {
  unsigned jobs = 1;
  // The next piece; nothing behind the last one. Called by one thread.
  std::function<std::unique_ptr<Piece>()> next;
  // Work that stands at the beginning of this piece, as far as it can be guessed; nothing where it cannot. That of the
  // first piece is no guess. Called by any thread.
  std::function<std::unique_ptr<PieceWork>(const Piece& piece, bool first)> begin;
  // The results, in order, called by the thread that calls; false: nothing behind this one counts.
  std::function<bool(PieceResult& result)> take;
  // For tests: two states that are taken for equal although they are not, where it says so.
  std::function<bool(const std::string& ended, const std::string& begun)> same = std::equal_to<>();
};

// Throws what next(), begin() of the first piece, a piece that counts or take() throws, once the pieces before have
// been taken. At most jobs + 1 pieces are held. Gives how often a guess was wrong.
std::size_t in_pieces(const InPieces& work);

}  // namespace toolcomp::fuzz
