#!/usr/bin/env python3
"""layers_test.py COMPILER FOLDERS INCLUDE: tests with the compiler which headers each library can include.

FOLDERS has a line for each library: its folder, and the directories in which its sources look for headers.
INCLUDE holds one directory for each library, through which alone its headers are reached.
"""
import pathlib
import re
import subprocess
import sys

# From the lowest layer up. A library may include folders of the lines above its own, and none of its own line.
LAYERS = [
    'shared wire',
    'core firmware web',
    'text model loop',
    'course estimation worlds link',
    'terrain control sim/body',
    'bridge messages sim/sensors',
    'record sim/board',
    'config runs sim/faults',
    'server identify report doctor camera ros2',
    'selftest',
    'live',
    'app sim/robot',
    'sim/trials sim/campaign',
    'sim/lab',
]


def included(compiler, directories, headers):
    """Which of these headers a source with these include directories can include."""
    source = ''.join(f'#if __has_include("{one}")\nyes {one}\n#endif\n' for one in headers)
    run = subprocess.run([compiler, '-x', 'c++', '-std=c++20', '-E', '-P', *(f'-I{one}' for one in directories), '-'],
                         input=source, text=True, capture_output=True, check=True)
    return {line.removeprefix('yes ') for line in run.stdout.splitlines()}


def names_the_laboratory(root):
    """The product's sources that name the laboratory, which a user need not have."""
    kinds = ('.cpp', '.h', '.ts', '.gd', '.toml', '.service')
    for folder in ('daemon', 'firmware', 'sim', 'config', 'scripts'):
        for path in (root / folder).rglob('*'):
            if path.suffix in kinds and not {'node_modules', 'lab'} & set(path.relative_to(root).parts):
                if re.search('sim/lab|tp100-lab|tp100_sim_lab', path.read_text(encoding='utf-8')):
                    yield str(path.relative_to(root))


def main():
    compiler, folders, include = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3])
    seen = {}
    for line in pathlib.Path(folders).read_text().splitlines():
        folder, *directories = line.split()
        seen[folder] = [one for one in directories if one.startswith(str(include))]
    layer = {folder: i for i, line in enumerate(LAYERS) for folder in line.split()}
    failures = [f'{folder} has no layer' for folder in seen if folder not in layer]
    headers = {}
    for folder in seen:
        name = 'tp100_' + folder.replace('/', '_')
        found = sorted((include / name / folder).glob('*.h'))
        if found:
            headers[folder] = f'{folder}/{found[0].name}'
    allowed = forbidden = 0
    for folder, directories in seen.items():
        possible = included(compiler, directories, headers.values())
        for other, header in headers.items():
            wanted = other == folder or str(include / ('tp100_' + other.replace('/', '_'))) in directories
            if wanted and other != folder and layer.get(other, 0) >= layer.get(folder, 0):
                failures.append(f'{folder} depends on {other}, which is not below it')
            if (header in possible) != wanted:
                failures.append(f'{folder} {"cannot" if wanted else "can"} include "{header}"')
            allowed, forbidden = allowed + wanted, forbidden + (not wanted)
    failures += [f'{path} names the laboratory' for path in names_the_laboratory(pathlib.Path(__file__).parents[2])]
    for failure in failures:
        print(failure)
    print(f'{len(seen)} folders, {allowed} allowed and {forbidden} forbidden pairs tried')
    return 1 if failures or forbidden == 0 else 0


if __name__ == '__main__':
    sys.exit(main())
