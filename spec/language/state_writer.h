// SPDX-License-Identifier: Apache-2.0
// The state of an object as bytes: equal bytes, equal state.
//
// A class whose state counts has `void state(StateWriter& out) const`. It binds all of its members
// (`const auto& [a, b, c] = *this;`), so that a new one does not compile until it is written or left out by name.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace toolcomp::spec {

class StateWriter;

// For types that have no state() of their own.
template <class Value>
struct StateOf;

class StateWriter {
 public:
  // Numbers, enumerations, texts, standard containers, owned objects, classes with state(), and what StateOf says.
  template <class... Values>
  void operator()(const Values&... values) {
    (write(values), ...);
  }

  // Objects that several others share are written once, then by their number: whether two are one object is state, too.
  // The number of an object, and whether it is the first time.
  struct Shared {
    std::uint32_t number = 0;
    bool first = false;
  };
  Shared shared(const void* object) {
    const auto [known, first] = shared_.try_emplace(object, static_cast<std::uint32_t>(shared_.size() + 1));
    return {known->second, first};
  }
  [[nodiscard]] bool knows(const void* object) const { return shared_.contains(object); }

  // All members of a plain struct: so many, or it does not compile.
  template <std::size_t kMembers, class Plain>
  void all(const Plain& plain);

  // What is not written whole: the state is equal to no other.
  void incomparable() {
    static std::atomic<std::uint64_t> next{0};
    write(next.fetch_add(1));
  }

  void bytes(const void* from, std::size_t size) { text_.append(static_cast<const char*>(from), size); }
  [[nodiscard]] std::string take() { return std::move(text_); }

 private:
  template <class Value>
  void write(const Value& value) {
    if constexpr (requires { value.state(*this); })
      value.state(*this);
    else if constexpr (std::is_arithmetic_v<Value> || std::is_enum_v<Value>)
      bytes(&value, sizeof value);
    else
      StateOf<Value>::write(*this, value);
  }
  void write(std::string_view text) {
    write(text.size());
    bytes(text.data(), text.size());
  }
  void write(const std::string& text) { write(std::string_view(text)); }
  void write(const char* text) { write(std::string_view(text)); }
  template <class Value>
  void write(const std::optional<Value>& value) {
    write(value.has_value());
    if (value) write(*value);
  }
  template <class First, class Second>
  void write(const std::pair<First, Second>& pair) {
    write(pair.first);
    write(pair.second);
  }
  template <class Value, std::size_t kSize>
  void write(const std::array<Value, kSize>& values) {
    for (const Value& value : values) write(value);
  }
  template <class Value>
  void write(const std::vector<Value>& values) {
    write_all(values);
  }
  template <class Value>
  void write(const std::deque<Value>& values) {
    write_all(values);
  }
  template <class Key, class Value>
  void write(const std::map<Key, Value>& values) {
    write_all(values);
  }
  template <class Values>
  void write_all(const Values& values) {
    write(values.size());
    for (const auto& value : values) write(value);
  }
  template <class Value>
  void write(const std::shared_ptr<Value>& value) {
    if (value == nullptr) return write(std::uint32_t{0});
    const Shared object = shared(value.get());
    write(object.number);
    if (object.first) write(*value);
  }
  template <class Value>
  void write(const std::unique_ptr<Value>& value) {
    write(value != nullptr);
    if (value != nullptr) write(*value);
  }

  std::string text_;
  std::unordered_map<const void*, std::uint32_t> shared_;
};

template <std::size_t kMembers, class Plain>
void StateWriter::all(const Plain& plain) {
  if constexpr (kMembers == 2) {
    const auto& [a, b] = plain;
    (*this)(a, b);
  } else if constexpr (kMembers == 3) {
    const auto& [a, b, c] = plain;
    (*this)(a, b, c);
  } else if constexpr (kMembers == 4) {
    const auto& [a, b, c, d] = plain;
    (*this)(a, b, c, d);
  } else if constexpr (kMembers == 5) {
    const auto& [a, b, c, d, e] = plain;
    (*this)(a, b, c, d, e);
  } else if constexpr (kMembers == 6) {
    const auto& [a, b, c, d, e, f] = plain;
    (*this)(a, b, c, d, e, f);
  } else if constexpr (kMembers == 7) {
    const auto& [a, b, c, d, e, f, g] = plain;
    (*this)(a, b, c, d, e, f, g);
  } else if constexpr (kMembers == 8) {
    const auto& [a, b, c, d, e, f, g, h] = plain;
    (*this)(a, b, c, d, e, f, g, h);
  } else if constexpr (kMembers == 9) {
    const auto& [a, b, c, d, e, f, g, h, i] = plain;
    (*this)(a, b, c, d, e, f, g, h, i);
  } else if constexpr (kMembers == 13) {
    const auto& [a, b, c, d, e, f, g, h, i, j, k, l, m] = plain;
    (*this)(a, b, c, d, e, f, g, h, i, j, k, l, m);
  } else if constexpr (kMembers == 14) {
    const auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n] = plain;
    (*this)(a, b, c, d, e, f, g, h, i, j, k, l, m, n);
  } else if constexpr (kMembers == 19) {
    const auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s] = plain;
    (*this)(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s);
  } else if constexpr (kMembers == 23) {
    const auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, u, v, w, x] = plain;
    (*this)(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, u, v, w, x);
  } else {
    static_assert(kMembers == 0, "give this number a binding");
  }
}

}  // namespace toolcomp::spec
