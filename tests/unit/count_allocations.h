// SPDX-License-Identifier: Apache-2.0
// Counts what a test program allocates: to be included once in a program.
#pragma once

#include <cstdlib>
#include <new>

namespace {

std::size_t allocations = 0;
std::size_t live_allocations = 0;  // not freed yet

void* counted(std::size_t size) {
  void* const memory = std::malloc(size == 0 ? 1 : size);
  if (memory == nullptr) throw std::bad_alloc();
  ++allocations;
  ++live_allocations;
  return memory;
}

void freed(void* memory) {
  if (memory != nullptr) --live_allocations;
  std::free(memory);
}

}  // namespace

void* operator new(std::size_t size) { return counted(size); }
void* operator new[](std::size_t size) { return counted(size); }
void operator delete(void* memory) noexcept { freed(memory); }
void operator delete[](void* memory) noexcept { freed(memory); }
void operator delete(void* memory, std::size_t) noexcept { freed(memory); }
void operator delete[](void* memory, std::size_t) noexcept { freed(memory); }
