#include "core/processor.h"

#include <gnu/libc-version.h>
#ifdef __x86_64__
// The header uses C's own type, which only GCC accepts in C++.
#define _Bool bool  // NOLINT(bugprone-reserved-identifier)
#include <sys/platform/x86.h>
#undef _Bool
#endif

namespace tp100 {

std::string arithmetic() {
#if defined __x86_64__
  // glibc has each function in two versions, and the user may have chosen one (GLIBC_TUNABLES).
  const char* const kind = "x86_64";
  const bool fma = CPU_FEATURE_ACTIVE(FMA) && CPU_FEATURE_ACTIVE(AVX2);
#elif defined __aarch64__
  const char* const kind = "aarch64";
  const bool fma = true;
#else
#error "Name this processor, and say whether the C library's functions use FMA on it."
#endif
  return std::string(kind) + ", glibc " + gnu_get_libc_version() + (fma ? " with" : " without") +
         " FMA";
}

}  // namespace tp100
