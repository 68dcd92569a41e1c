#pragma once
// Properties of this machine that decide the last bits of a result; see core/arithmetic.h.

#include <string>

namespace tp100 {

/// Kind of this processor, version of the C library and whether its functions use FMA, as in
/// "x86_64, glibc 2.36 with FMA". Results may differ in their last bits between programs with
/// different texts, or of different versions.
std::string arithmetic();

}  // namespace tp100
