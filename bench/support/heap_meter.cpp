#include "support/heap_meter.h"

#include <malloc.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace frontier_pilot::bench {
namespace {

std::atomic<std::size_t> in_use{0};
std::atomic<std::size_t> most{0};

/// With the allocator's own eight bytes.
std::size_t sizeOf(void* memory) { return malloc_usable_size(memory) + sizeof(std::size_t); }

void* counted(void* memory) {
  if (memory == nullptr) throw std::bad_alloc();
  const std::size_t now = in_use += sizeOf(memory);
  std::size_t before = most;
  while (before < now && !most.compare_exchange_weak(before, now)) {
  }
  return memory;
}

void release(void* memory) {
  if (memory == nullptr) return;
  in_use -= sizeOf(memory);
  std::free(memory);
}

}  // namespace

std::size_t HeapMeter::inUse() { return in_use; }
std::size_t HeapMeter::peak() { return most; }
void HeapMeter::restart() { most = in_use.load(); }

}  // namespace frontier_pilot::bench

void* operator new(std::size_t bytes) { return frontier_pilot::bench::counted(std::malloc(bytes)); }
void* operator new(std::size_t bytes, std::align_val_t alignment) {
  const auto step = static_cast<std::size_t>(alignment);
  return frontier_pilot::bench::counted(std::aligned_alloc(step, (bytes + step - 1) / step * step));
}
void operator delete(void* memory) noexcept { frontier_pilot::bench::release(memory); }
void operator delete(void* memory, std::size_t) noexcept { frontier_pilot::bench::release(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { frontier_pilot::bench::release(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { frontier_pilot::bench::release(memory); }
