#!/usr/bin/python3
"""scripts/mutants.py must find the mutants of a small source, and each mutant must change the program's output."""
import os
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, ROOT + '/scripts')
sys.dont_write_bytecode = True
try:
    import mutants
except ImportError:
    print('skipped: needs python3-clang-14')
    sys.exit(77)

SOURCE = """#include <algorithm>
#include <cstdio>
#include <optional>
#define TWICE(x) ((x) + (x))
namespace {
constexpr double kGain = 0.5;
struct Sum {
  int total = 3;
  void add(int value) {
    total += value;
  }
};
struct Vector {
  int x;
  Vector operator-(Vector other) const { return {x * other.x}; }
};
bool is_low(double value) { return value < kGain; }
bool is_missing(const std::optional<int>& value) { return !value; }
[[noreturn]] void fail(int value) {
  throw value;
}
int share(int value) {
  static const int kTable[2] = {1, 2};
  static_assert(1 + 1 == 2);
  if (value > 2) return std::min(value, 7);
  return TWICE(value);
}
}  // namespace
int main() {
  Sum sum;
  sum.add(-4);
  const Vector v = Vector{5} - Vector{1};
  std::printf("%d %d %d %d %d %d %d\\n", sum.total, v.x, is_low(0.4), is_low(0.5), is_low(0.6), share(2), share(8));
  std::printf("%d %d\\n", is_missing(0), is_missing({}));
}
"""
HEAD = """#include <cstdlib>
#include <type_traits>
#define TP100_MUTANT(id) (std::atoi(std::getenv("MUTANT")) == id)
#define TP100_MUTANT_TYPE(name) std::decay_t<decltype(name)>
"""
FOUND = {
    ('int total = 3;', 'int total = 4;'),
    ('total += value;', 'total -= value;'),
    ('total += value;', '/* total += value; */'),
    ('Vector operator-(Vector other) const { return {x * other.x}; }',
     'Vector operator-(Vector other) const { return {}; }'),
    ('Vector operator-(Vector other) const { return {x * other.x}; }',
     'Vector operator-(Vector other) const { return {x / other.x}; }'),
    ('bool is_low(double value) { return value < kGain; }', 'bool is_low(double value) { return !(value < kGain); }'),
    ('bool is_low(double value) { return value < kGain; }', 'bool is_low(double value) { return value > kGain; }'),
    ('bool is_low(double value) { return value < kGain; }',
     'bool is_low(double value) { return value < (2 * kGain); }'),
    ('bool is_missing(const std::optional<int>& value) { return !value; }',
     'bool is_missing(const std::optional<int>& value) { return !(!value); }'),
    ('bool is_missing(const std::optional<int>& value) { return !value; }',
     'bool is_missing(const std::optional<int>& value) { return value; }'),
    ('if (value > 2) return std::min(value, 7);', 'if (!(value > 2)) return std::min(value, 7);'),
    ('if (value > 2) return std::min(value, 7);', 'if (value >= 2) return std::min(value, 7);'),
    ('if (value > 2) return std::min(value, 7);', 'if (value > 3) return std::min(value, 7);'),
    ('if (value > 2) return std::min(value, 7);', 'if (value > 2) return {};'),
    ('if (value > 2) return std::min(value, 7);', 'if (value > 2) return std::max(value, 7);'),
    ('if (value > 2) return std::min(value, 7);', 'if (value > 2) return std::min(value, 8);'),
    ('return TWICE(value);', 'return {};'),
    ('sum.add(-4);', '/* sum.add(-4); */'),
    ('sum.add(-4);', 'sum.add(4);'),
    ('sum.add(-4);', 'sum.add(-5);'),
}
# share() is never called with 3: no output differs.
EQUIVALENT = {'if (value > 3) return std::min(value, 7);'}


def main():
    with tempfile.TemporaryDirectory(prefix='tp100-mutants-') as folder:
        path = folder + '/small.cpp'
        with open(path, 'w', encoding='utf-8') as file:
            file.write(SOURCE)
        found = [m for m in mutants.find(path, 'small.cpp', ['-std=c++20']) if m.line < 29 or 'sum.add' in m.before]
        texts = {(m.before, m.after) for m in found}
        assert texts == FOUND, f'missing: {FOUND - texts}, too many: {texts - FOUND}'

        woven, _ = mutants.weave(SOURCE, dict(enumerate(found, 1)), HEAD)
        with open(path, 'w', encoding='utf-8') as file:
            file.write(woven)
        subprocess.run(['c++', '-std=c++20', '-w', path, '-o', folder + '/small'], check=True)

        def output(number):
            run = subprocess.run([folder + '/small'], env={'MUTANT': str(number)}, check=True, capture_output=True)
            return run.stdout

        right = output(0)
        assert right == b'-1 5 1 0 0 4 7\n0 1\n', right
        same = {m.after for number, m in enumerate(found, 1) if output(number) == right}
        # 5 / 1 is 5 * 1.
        assert same == EQUIVALENT | {'Vector operator-(Vector other) const { return {x / other.x}; }'}, same


main()
