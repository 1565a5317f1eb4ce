// SPDX-License-Identifier: Apache-2.0
// What Debian's libraries for WebAssembly leave out. Its libc++abi is built without exceptions, so what `clang
// -fwasm-exceptions` calls is here: the part of the Itanium C++ ABI that throws, finds the handler, and frees. The
// instructions of WebAssembly unwind. Nobody throws pointers here, and one thread runs.
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <new>
#include <typeinfo>

namespace __cxxabiv1 {

// As libc++abi declares it (src/private_typeinfo.h): all types of C++ answer whether they catch another one.
class __shim_type_info : public std::type_info {
 public:
  ~__shim_type_info() override;
  virtual void noop1() const;
  virtual void noop2() const;
  virtual bool can_catch(const __shim_type_info* thrown, void*& adjusted) const = 0;
};

}  // namespace __cxxabiv1

namespace {

using Type = __cxxabiv1::__shim_type_info;
using Destructor = void* (*)(void*);  // those of WebAssembly return what they destroyed

// In front of each object thrown.
struct alignas(16) Thrown {
  const std::type_info* type;
  Destructor destroy;
  void* adjusted;  // the object, as the handler sees it
  Thrown* next;    // caught before it
  int handlers;    // that it is in; negative: thrown on by one
};

Thrown* caught = nullptr;  // the latest

void* object_of(Thrown* thrown) { return thrown + 1; }
Thrown* thrown_of(void* object) { return static_cast<Thrown*>(object) - 1; }

void free_thrown(Thrown* thrown) {
  if (thrown->destroy != nullptr) thrown->destroy(object_of(thrown));
  std::free(thrown);
}

// The tables of the compiler: LEB128.
std::uint32_t read_unsigned(const std::uint8_t*& at) {
  std::uint32_t value = 0;
  for (unsigned shift = 0;; shift += 7) {
    const std::uint8_t byte = *at++;
    value |= static_cast<std::uint32_t>(byte & 0x7fU) << shift;
    if ((byte & 0x80U) == 0) return value;
  }
}
std::int32_t read_signed(const std::uint8_t*& at) {
  std::uint32_t value = 0;
  unsigned shift = 0;
  std::uint8_t byte = 0x80;
  while ((byte & 0x80U) != 0) {
    byte = *at++;
    value |= static_cast<std::uint32_t>(byte & 0x7fU) << shift;
    shift += 7;
  }
  if ((byte & 0x40U) != 0 && shift < 32) value |= ~std::uint32_t{0} << shift;
  return static_cast<std::int32_t>(value);
}

}  // namespace

extern "C" {

// Between the code of a landing pad and _Unwind_CallPersonality, by the convention of the compiler.
struct LandingPad {
  std::uintptr_t index;
  const std::uint8_t* table;
  std::uintptr_t selector;
};
thread_local LandingPad __wasm_lpad_context;

void* __cxa_allocate_exception(std::size_t size) {
  auto* thrown = static_cast<Thrown*>(std::malloc(sizeof(Thrown) + size));
  if (thrown == nullptr) std::abort();
  *thrown = {};
  return object_of(thrown);
}

void __cxa_free_exception(void* object) { std::free(thrown_of(object)); }

[[noreturn]] void __cxa_throw(void* object, std::type_info* type, Destructor destroy) {
  Thrown* thrown = thrown_of(object);
  thrown->type = type;
  thrown->destroy = destroy;
  thrown->adjusted = object;
  __builtin_wasm_throw(0, thrown);
}

// Chooses the handler of a landing pad: 0 is none, then only what must be destroyed is.
int _Unwind_CallPersonality(void* exception) {
  constexpr std::uint8_t kOmitted = 0xff;
  auto* thrown = static_cast<Thrown*>(exception);
  __wasm_lpad_context.selector = 0;
  const std::uint8_t* at = __wasm_lpad_context.table;
  if (at == nullptr) return 0;
  ++at;  // where landing pads begin: not told
  const std::uint8_t* types = nullptr;
  if (*at++ != kOmitted) {
    const std::uint32_t size = read_unsigned(at);
    types = at + size;
  }
  ++at;  // how calls are encoded: as whole numbers
  const std::uint32_t size = read_unsigned(at);
  const std::uint8_t* const actions = at + size;
  std::uint32_t action = 0;
  for (std::uintptr_t i = 0; i <= __wasm_lpad_context.index; ++i) {
    if (at >= actions) std::terminate();
    read_unsigned(at);
    action = read_unsigned(at);
  }
  if (action == 0) return 0;
  at = actions + (action - 1);
  while (true) {
    const std::int32_t filter = read_signed(at);
    if (filter > 0) {
      const Type* const type = reinterpret_cast<const Type* const*>(types)[-filter];
      void* adjusted = object_of(thrown);
      if (type == nullptr || type->can_catch(static_cast<const Type*>(thrown->type), adjusted)) {
        thrown->adjusted = adjusted;
        __wasm_lpad_context.selector = static_cast<std::uintptr_t>(filter);
        return 0;
      }
    }
    const std::uint8_t* const here = at;
    const std::int32_t next = read_signed(at);
    if (next == 0) return 0;
    at = here + next;
  }
}

void* __cxa_get_exception_ptr(void* exception) noexcept { return static_cast<Thrown*>(exception)->adjusted; }

void* __cxa_begin_catch(void* exception) noexcept {
  auto* thrown = static_cast<Thrown*>(exception);
  thrown->handlers = (thrown->handlers < 0 ? -thrown->handlers : thrown->handlers) + 1;
  if (caught != thrown) {
    thrown->next = caught;
    caught = thrown;
  }
  return thrown->adjusted;
}

void __cxa_end_catch() {
  Thrown* thrown = caught;
  if (thrown == nullptr) return;
  if (thrown->handlers < 0) {
    // Thrown on: who catches it next owns it.
    if (++thrown->handlers == 0) caught = thrown->next;
  } else if (--thrown->handlers == 0) {
    caught = thrown->next;
    free_thrown(thrown);
  }
}

[[noreturn]] void __cxa_rethrow() {
  Thrown* thrown = caught;
  if (thrown == nullptr) std::terminate();
  thrown->handlers = -thrown->handlers;
  __builtin_wasm_throw(0, thrown);
}

// The one thread ends with the module.
int __cxa_thread_atexit(void (*)(void*), void*, void*) noexcept { return 0; }

// The builtins of the compiler are built with a guard of the stack.
std::uintptr_t __stack_chk_guard = 0x595e9fbd;
[[noreturn]] void __stack_chk_fail() { std::abort(); }

}  // extern "C"
