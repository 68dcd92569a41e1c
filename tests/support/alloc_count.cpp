#include "support/alloc_count.h"

#include <cstddef>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)

namespace tp100::test {
bool counting() { return false; }
AllocCount::AllocCount() = default;
AllocCount::~AllocCount() = default;
std::uint64_t AllocCount::calls() const { return 0; }
}  // namespace tp100::test

#else

namespace {
thread_local bool t_armed = false;
thread_local std::uint64_t t_calls = 0;
void count() {
  if (t_armed) ++t_calls;
}
}  // namespace

extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t number, std::size_t size);
void* __libc_realloc(void* block, std::size_t size);
void __libc_free(void* block);

void* malloc(std::size_t size) {
  count();
  return __libc_malloc(size);
}
void* calloc(std::size_t number, std::size_t size) {
  count();
  return __libc_calloc(number, size);
}
void* realloc(void* block, std::size_t size) {
  count();
  return __libc_realloc(block, size);
}
void free(void* block) {
  if (block != nullptr) count();
  __libc_free(block);
}
}

namespace tp100::test {
bool counting() { return true; }
AllocCount::AllocCount() {
  t_calls = 0;
  t_armed = true;
}
AllocCount::~AllocCount() { t_armed = false; }
std::uint64_t AllocCount::calls() const { return t_calls; }
}  // namespace tp100::test

#endif
