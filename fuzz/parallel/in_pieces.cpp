// SPDX-License-Identifier: Apache-2.0
#include "fuzz/parallel/in_pieces.h"

#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

namespace toolcomp::fuzz {
namespace {

// A piece and who works on it.
struct Place {
  std::shared_ptr<const Piece> piece;
  std::uint64_t run = 0;             // which run of it counts; 0: none yet
  std::optional<std::string> begun;  // the state that run began with
  std::optional<std::string> ended;
  std::unique_ptr<PieceResult> result;
  std::exception_ptr thrown;
  bool done = false;
};

class Crew {
 public:
  explicit Crew(const InPieces& work) : work_(work) {}
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;
  ~Crew() {
    {
      const std::lock_guard lock(mutex_);
      stop_ = true;
    }
    changed_.notify_all();
    for (std::thread& thread : threads_) thread.join();
  }

  std::size_t run() {
    threads_.emplace_back([this] { read(); });
    for (unsigned n = 0; n < work_.jobs; ++n) threads_.emplace_back([this] { help(); });
    take_all();
    return wrong_;
  }

 private:
  using Lock = std::unique_lock<std::mutex>;

  // The thread that reads.
  void read() {
    for (;;) {
      {
        Lock lock(mutex_);
        changed_.wait(lock, [this] { return stop_ || places_.size() <= work_.jobs; });
        if (stop_) return;
      }
      std::unique_ptr<Piece> piece;
      std::exception_ptr thrown;
      try {
        piece = work_.next();
      } catch (...) {
        thrown = std::current_exception();
      }
      const std::lock_guard lock(mutex_);
      if (piece == nullptr) {
        unreadable_ = thrown;
        all_read_ = true;
      } else {
        places_.emplace_back().piece = std::move(piece);
      }
      changed_.notify_all();
      if (all_read_) return;
    }
  }

  // Piece `index`, if it is there; those taken are gone.
  Place* at(std::size_t index) {
    return index < taken_ || index - taken_ >= places_.size() ? nullptr : &places_[index - taken_];
  }

  // A thread that works.
  void help() {
    Lock lock(mutex_);
    for (;;) {
      changed_.wait(lock, [this] { return stop_ || at(unclaimed()) != nullptr || all_read_; });
      const std::size_t index = unclaimed();
      if (stop_ || at(index) == nullptr) return;
      const std::uint64_t run = claim(index);
      std::shared_ptr<const Piece> piece = at(index)->piece;
      lock.unlock();
      std::unique_ptr<PieceWork> work;
      std::optional<std::string> begun;
      std::exception_ptr thrown;
      try {
        work = work_.begin(*piece, index == 0);
        if (work != nullptr && index != 0) begun = work->state();
      } catch (...) {
        // Behind the first piece it was a guess.
        if (index == 0) thrown = std::current_exception();
        work = nullptr;
      }
      piece.reset();
      lock.lock();
      Place* const place = current(index, run);
      if (place == nullptr) continue;
      place->begun = begun.value_or("");
      if (work == nullptr) {
        place->thrown = thrown;
        place->done = thrown != nullptr;
        if (!thrown) place->run = kNobody;
      }
      changed_.notify_all();
      if (work != nullptr) go_on(lock, *work, index, run);
      lock.unlock();
      work.reset();
      lock.lock();
    }
  }

  // Runs piece `index`, and those behind it that were begun with another state than it ends in.
  void go_on(Lock& lock, PieceWork& work, std::size_t index, std::uint64_t run) {
    for (;;) {
      std::shared_ptr<const Piece> piece = at(index)->piece;
      lock.unlock();
      std::unique_ptr<PieceResult> result;
      std::string ended;
      std::exception_ptr thrown;
      try {
        result = work.run(*piece, stop_);
        ended = work.state();
      } catch (...) {
        thrown = std::current_exception();
      }
      piece.reset();
      lock.lock();
      Place* place = current(index, run);
      if (place == nullptr) return;
      place->result = std::move(result);
      place->ended = ended;
      place->thrown = thrown;
      place->done = true;
      changed_.notify_all();
      if (thrown) return;
      // Taken meanwhile or not, this run counts as long as nobody has replaced it.
      Place* next = nullptr;
      changed_.wait(lock, [&] {
        next = at(index + 1);
        return stop_ || replaced(index, run) || (next == nullptr && all_read_) ||
               (next != nullptr && (next->run == 0 || next->begun));
      });
      if (stop_ || replaced(index, run) || next == nullptr) return;
      const bool guessed = next->run != 0;
      if (guessed && next->run != kNobody && work_.same(ended, *next->begun)) return;
      if (guessed) ++wrong_;
      ++index;
      run = claim(index);
      next->begun = ended;
      next->done = false;
      next->result = nullptr;
      next->thrown = nullptr;
      changed_.notify_all();
    }
  }

  [[nodiscard]] std::size_t unclaimed() {
    std::size_t index = taken_;
    while (at(index) != nullptr && at(index)->run != 0) ++index;
    return index;
  }
  std::uint64_t claim(std::size_t index) { return at(index)->run = ++runs_; }
  // Another run of this piece counts, or has counted.
  [[nodiscard]] bool replaced(std::size_t index, std::uint64_t run) {
    const Place* const place = at(index);
    return place != nullptr ? place->run != run : index + 1 != taken_ || taken_run_ != run;
  }
  Place* current(std::size_t index, std::uint64_t run) {
    Place* const place = at(index);
    return stop_ || place == nullptr || place->run != run ? nullptr : place;
  }

  // The thread that called: a piece counts where it was begun with the state in which the one before it ended.
  void take_all() {
    Lock lock(mutex_);
    std::string ended;
    for (;;) {
      changed_.wait(lock, [&] {
        if (places_.empty()) return all_read_;
        Place& place = places_.front();
        return place.done && place.run != kNobody && (taken_ == 0 || work_.same(ended, *place.begun));
      });
      if (places_.empty()) break;
      Place place = std::move(places_.front());
      places_.pop_front();
      ++taken_;
      taken_run_ = place.run;
      changed_.notify_all();
      if (place.thrown) std::rethrow_exception(place.thrown);
      ended = std::move(*place.ended);
      lock.unlock();
      const bool more = work_.take(*place.result);
      place.piece.reset();
      if (!more) return;
      lock.lock();
    }
    if (unreadable_) std::rethrow_exception(unreadable_);
  }

  static constexpr std::uint64_t kNobody = ~std::uint64_t{0};

  const InPieces& work_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Place> places_;  // from the first that is not taken
  std::size_t taken_ = 0;
  std::uint64_t taken_run_ = 0;  // of the last of those
  std::uint64_t runs_ = 0;
  std::size_t wrong_ = 0;
  bool all_read_ = false;
  std::exception_ptr unreadable_;
  std::atomic<bool> stop_{false};
  std::vector<std::thread> threads_;
};

}  // namespace

std::size_t in_pieces(const InPieces& work) { return Crew(work).run(); }

}  // namespace toolcomp::fuzz
