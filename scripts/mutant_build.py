"""The copy of the working tree for scripts/mutate in build/mutate: it holds all chosen mutants at once, each behind a
switch (TP100_MUTANT=NUMBER in the environment), and records which a program reaches (TP100_MUTANTS_REACHED=FILE).

copy_tree() and configure() prepare it; build() weaves the mutants in, compiles, and takes out what does not compile.
"""
import concurrent.futures
import hashlib
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
WORK = ROOT / 'build/mutate'
SOURCE, STATE = WORK / 'source', WORK / 'state'
# In the preset's place relative to the source, which ccache needs for its hits.
BUILD = SOURCE / 'build/dev'
JOBS = os.cpu_count() or 1
NUMBERS = 1 << 16  # range of mutants' numbers

MUTANT_H = '''#ifndef TP100_MUTANT_H
#define TP100_MUTANT_H
#ifdef __AVR__
#define TP100_MUTANT(id) false
#else
#include <type_traits>
extern "C" int tp100_mutant;
extern "C" unsigned char* tp100_mutants_reached;
static inline __attribute__((unused)) bool tp100_is_mutant(int id) {
  tp100_mutants_reached[id] = 1;
  return tp100_mutant == id;
}
// A constant expression is never mutated.
#define TP100_MUTANT(id) (__builtin_is_constant_evaluated() ? false : tp100_is_mutant(id))
#define TP100_MUTANT_TYPE(name) typename std::decay<decltype(name)>::type
#endif
// avr-gcc does not know all of these.
#pragma GCC diagnostic ignored "-Wpragmas"
%s
#endif
''' % '\n'.join(f'#pragma GCC diagnostic ignored "-W{name}"' for name in (
    'all extra pedantic shadow conversion sign-conversion null-dereference double-promotion array-bounds parentheses '
    'unused-value unused-but-set-variable unused-variable unused-function unused-parameter unused-result type-limits '
    'sign-compare stringop-overflow stringop-overread maybe-uninitialized uninitialized return-type bool-compare '
    'int-in-bool-context tautological-compare logical-op div-by-zero shift-count-overflow empty-body narrowing '
    'shift-count-negative float-equal sequence-point aggressive-loop-optimizations overflow free-nonheap-object '
    'bool-operation duplicated-branches restrict dangling-pointer ignored-qualifiers misleading-indentation '
    'dangling-else').split())
MUTANT_C = '''#include <fcntl.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <unistd.h>
int tp100_mutant;
static unsigned char nowhere[%d];
unsigned char* tp100_mutants_reached = nowhere;
__attribute__((constructor(101))) static void begin(void) {
  const char* mutant = getenv("TP100_MUTANT");
  if (mutant) tp100_mutant = atoi(mutant);
  const char* reached = getenv("TP100_MUTANTS_REACHED");
  if (!reached) return;
  const int file = open(reached, O_RDWR);
  void* at = mmap(0, sizeof nowhere, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  if (at != MAP_FAILED) tp100_mutants_reached = at;
  close(file);
}
''' % NUMBERS


def say(text):
    print(f'mutate: {text}', file=sys.stderr, flush=True)


def git(*words):
    return subprocess.run(['git', '-C', ROOT, *words], check=True, capture_output=True, text=True).stdout


def copy_tree(woven, left=()):
    """Updates the copy to the state of the working tree, with the files of `woven` ({path: text}) replaced; writes only
    files that differ, and none of `left` that exist already. Returns a hash of the working tree."""
    listed = git('ls-files', '--cached', '--others', '--exclude-standard', '-z').split('\0')
    digest = hashlib.sha256()
    kept = set()
    for path in sorted(set(listed) - {''}):
        original, copy = ROOT / path, SOURCE / path
        if not original.is_file() and not original.is_symlink():
            continue
        kept.add(path)
        copy.parent.mkdir(parents=True, exist_ok=True)
        if original.is_symlink():
            if not copy.is_symlink():
                copy.symlink_to(os.readlink(original))
            continue
        if path in left and copy.exists():
            continue
        content = original.read_bytes()
        if not path.startswith('scripts/') and not path.endswith('.md'):
            digest.update(path.encode() + b'\0' + hashlib.sha256(content).digest())
        if path in woven:
            content = woven[path].encode('latin-1')
        if not copy.is_file() or copy.read_bytes() != content:
            copy.write_bytes(content)
            copy.chmod(original.stat().st_mode)
    for folder, folders, files in os.walk(SOURCE):
        if folder == str(SOURCE) and 'build' in folders:
            folders.remove('build')
        for name in files:
            copy = pathlib.Path(folder, name)
            if str(copy.relative_to(SOURCE)) not in kept:
                copy.unlink()
    return digest.hexdigest()


def configure():
    for name, text in (('mutant.h', MUTANT_H), ('mutant.c', MUTANT_C)):
        path = WORK / name
        if not path.exists() or path.read_text() != text:
            path.write_text(text)
    subprocess.run(['cc', '-O2', '-c', WORK / 'mutant.c', '-o', WORK / 'mutant.o'], check=True)
    # The flags of the preset dev, but each file by itself, so that one more mutant recompiles only one file.
    preset = next(p for p in json.loads((ROOT / 'CMakePresets.json').read_text())['configurePresets']
                  if p['name'] == 'dev')
    variables = dict(preset['cacheVariables'])
    variables['CMAKE_EXE_LINKER_FLAGS'] = f"{variables.get('CMAKE_EXE_LINKER_FLAGS', '')} {WORK}/mutant.o"
    flags = [f'-D{name}={value}' for name, value in variables.items()]
    subprocess.run(['cmake', '-S', SOURCE, '-B', BUILD, '-G', 'Ninja', *flags], check=True, stdout=subprocess.DEVNULL)


def environment(**more):
    names = {name: value for name, value in os.environ.items() if not name.startswith('TP100_')}
    return names | {'CCACHE_BASEDIR': str(SOURCE), 'CCACHE_SLOPPINESS': 'pch_defines,time_macros'} | more


def compile_arguments():
    """A function that maps a file to the compiler's arguments for it; for a header, those of a source beside it."""
    arguments = {}
    for entry in json.loads((BUILD / 'compile_commands.json').read_text()):
        words = shlex.split(entry['command'])
        kept = [word for word in words if word.startswith(('-I', '-D', '-std'))]
        for at, word in enumerate(words):
            if word == '-isystem':
                kept += words[at:at + 2]
        arguments[pathlib.Path(entry['file'])] = kept

    def of(path):
        there = SOURCE / path
        beside = [file for folder in (there.parent, there.parent.parent) for file in arguments if file.parent == folder]
        return arguments[there if there in arguments else beside[0]]

    return of


def weave_all(chosen):
    """{path: text} with the mutants {id: mutant} in them, and {path: places}."""
    import mutants
    by_path = {}
    for number, mutant in chosen.items():
        by_path.setdefault(mutant.path, {})[number] = mutant
    texts, places = {}, {}
    for path, of_path in by_path.items():
        texts[path], places[path] = mutants.weave(
            (ROOT / path).read_text(encoding='latin-1'), of_path, f'#include "{WORK}/mutant.h"\n')
    return texts, places


def refused(output, texts, places):
    """The ids of the mutants to which the compiler's messages refer."""
    ids = set()
    for message in ('error:', 'required from', ''):
        for match in re.finditer(r'^(\S+?):(\d+):(\d+):\s+' + message, output, re.M):
            file = (BUILD / match[1]).resolve()
            path = str(file.relative_to(SOURCE)) if file.is_relative_to(SOURCE) else ''
            if path not in texts:
                continue
            lines = texts[path].split('\n')
            line = int(match[2]) - 1
            begin = sum(len(text) + 1 for text in lines[:line])
            at = begin + int(match[3]) - 1
            inner = [numbers for b, e, numbers in places[path] if b <= at <= e]
            if inner:
                ids.update(inner[-1])
            else:
                for b, e, numbers in places[path]:
                    if b < begin + len(lines[line]) and begin < e:
                        ids.update(numbers)
        if ids:
            break
    return ids


def build(chosen, tests):
    """Builds the test executables with all mutants in them; removes from `chosen` those that do not compile. Returns
    the hash of the tree, and the removed mutants."""
    kept = STATE / 'refused'
    known = set(kept.read_text().splitlines()) if kept.exists() else set()
    dropped = {}

    def drop(numbers):
        for number in numbers:
            dropped[number] = chosen.pop(number)
        with kept.open('a') as file:
            file.writelines(dropped[number].key + '\n' for number in numbers)

    for number in [number for number, mutant in chosen.items() if mutant.key in known]:
        dropped[number] = chosen.pop(number)
    arguments = compile_arguments()
    while True:
        texts, places = weave_all(chosen)
        tree = copy_tree(texts)
        # Headers first: one that does not compile would fail hundreds of sources.
        headers = [path for path in texts if path.endswith('.h')]
        good, now = STATE / 'headers', hashlib.sha256(''.join(map(texts.get, headers)).encode()).hexdigest()
        if not good.exists() or good.read_text() != now:
            with concurrent.futures.ThreadPoolExecutor(JOBS) as pool:
                outputs = pool.map(lambda path: subprocess.run(
                    ['c++', '-fsyntax-only', '-Werror=return-local-addr', *arguments(path), '-xc++', SOURCE / path],
                    cwd=BUILD, capture_output=True, text=True).stderr, headers)
            bad = refused(''.join(outputs), texts, places)
            drop(bad)
            if bad:
                continue
            good.write_text(now)
        say(f'builds {len(tests)} test executables with {len(chosen)} mutants in {len(texts)} files')
        run = subprocess.Popen(['ninja', '-C', BUILD, '-j', str(JOBS), '-k', '0', *tests], env=environment(),
                               stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        output = []
        try:
            for line in run.stdout:
                output.append(line)
                if line.startswith('['):
                    print(f'\r{line.split()[0]} ', end='', file=sys.stderr, flush=True)
        except KeyboardInterrupt:
            run.terminate()
            run.wait()
            raise
        print(file=sys.stderr)
        if run.wait() == 0:
            return tree, dropped
        (STATE / 'build.log').write_text(''.join(output))
        bad = refused(''.join(output), texts, places)
        if not bad:
            sys.exit(f'mutate: the build fails, and not of a mutant: {STATE}/build.log')
        say(f'{len(bad)} do not compile')
        drop(bad)
