#include "allocation_count.h"

#include <cstddef>

namespace {

thread_local bool armed = false;
thread_local std::uint64_t count = 0;

}  // namespace

#if TP100_COUNTS_ALLOCATIONS
extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void __libc_free(void*);

void* malloc(std::size_t size) {
  if (armed) ++count;
  return __libc_malloc(size);
}
void* calloc(std::size_t n, std::size_t size) {
  if (armed) ++count;
  return __libc_calloc(n, size);
}
void* realloc(void* at, std::size_t size) {
  if (armed) ++count;
  return __libc_realloc(at, size);
}
void free(void* at) {
  if (armed && at != nullptr) ++count;
  __libc_free(at);
}
}
#endif

namespace tp100 {

AllocationCount::AllocationCount() {
  count = 0;
  armed = true;
}
AllocationCount::~AllocationCount() { armed = false; }
std::uint64_t AllocationCount::calls() const { return count; }

}  // namespace tp100
