#!/usr/bin/env python3
"""generate.py DEFINITIONS HEADER: a C++ type for each ROS 2 message of DEFINITIONS, with its schema and type hash.

The hash is RIHS01 (REP-2016): SHA-256 of the type's description as JSON.
"""
import hashlib
import json
import pathlib
import re
import sys

# Name in a definition: number in a type description (type_description_interfaces/FieldType), C++ type.
PRIMITIVES = {
    'float32': (10, 'float'),
    'float64': (11, 'double'),
    'bool': (15, 'bool'),
    'byte': (16, 'std::uint8_t'),
    'string': (17, 'std::string'),
    'int32': (6, 'std::int32_t'),
    'uint8': (3, 'std::uint8_t'),
    'uint32': (7, 'std::uint32_t'),
}
NESTED, BOUNDED_STRING, ARRAY, SEQUENCE = 1, 21, 48, 144
FIELD = re.compile(r'(?P<base>[\w/]+)(?:<=(?P<bound>\d+))?(?P<many>\[(?P<size>\d*)\])? (?P<name>\w+)(?:=(?P<value>\w+))?')


def read(text):
    """Lines of each message by its name, package/Name."""
    messages, name = {}, None
    for line in text.splitlines():
        if line.startswith('MSG: '):
            name = line.removeprefix('MSG: ')
            messages[name] = []
        elif line and not line.startswith('#'):
            match = FIELD.fullmatch(line)
            if not match or name is None:
                sys.exit(f'generate.py: not a field or a constant of a message: {line}')
            messages[name].append(match)
    return messages


def full(name):
    return name.replace('/', '/msg/')


def nested(fields, messages):
    """Names of all messages within these fields."""
    names = set()
    for field in fields:
        if field['base'] in messages:
            names |= {field['base']} | nested(messages[field['base']], messages)
        elif field['base'] not in PRIMITIVES:
            sys.exit(f'generate.py: no message or primitive type: {field["base"]}')
    return names


def described(name, messages):
    """The description of one type, without those within it."""
    fields = []
    for field in messages[name]:
        if field['value']:
            continue
        kind = NESTED if field['base'] in messages else BOUNDED_STRING if field['bound'] else PRIMITIVES[field['base']][0]
        if field['many']:
            kind += ARRAY if field['size'] else SEQUENCE
        fields.append({'name': field['name'], 'type': {
            'type_id': kind, 'capacity': int(field['size'] or 0), 'string_capacity': int(field['bound'] or 0),
            'nested_type_name': full(field['base']) if field['base'] in messages else ''}})
    return {'type_name': full(name), 'fields': fields}


def type_hash(name, messages):
    inner = sorted(nested(messages[name], messages), key=full)
    text = json.dumps({'type_description': described(name, messages),
                       'referenced_type_descriptions': [described(one, messages) for one in inner]})
    return 'RIHS01_' + hashlib.sha256(text.encode()).hexdigest()


def schema(name, messages):
    """The definition with those of the messages within it, as recordings carry it (`ros2msg`)."""
    def lines(one):
        return ''.join(field.string + '\n' for field in messages[one])
    return lines(name) + ''.join('=' * 80 + f'\nMSG: {inner}\n' + lines(inner)
                                 for inner in sorted(nested(messages[name], messages)))


def cpp_type(field, messages):
    base = field['base'].replace('/', '::') if field['base'] in messages else PRIMITIVES[field['base']][1]
    if not field['many']:
        return base
    return f'std::array<{base}, {field["size"]}>' if field['size'] else f'std::vector<{base}>'


def cpp(name, messages):
    package, short = name.split('/')
    constants = [field for field in messages[name] if field['value']]
    fields = [field for field in messages[name] if not field['value']]
    out = [f'namespace tp100::ros2::{package} {{', f'struct {short} {{']
    out += [f'  static constexpr {cpp_type(one, messages)} k{one["name"].title().replace("_", "")} = {one["value"]};'
            for one in constants]
    out += [f'  {cpp_type(one, messages)} {one["name"]}{{}};' for one in fields]
    tie = f'{{ return std::tie({", ".join(one["name"] for one in fields)}); }}'
    out += [f'  auto fields() const {tie}', f'  auto fields() {tie}',
            f'  static constexpr MessageType kType{{"{full(name)}", "{package}::msg::dds_::{short}_",',
            f'    "{type_hash(name, messages)}",',
            f'    R"({schema(name, messages)})"}};', '};', f'}}  // namespace tp100::ros2::{package}', '']
    return '\n'.join(out)


def main():
    messages = read(pathlib.Path(sys.argv[1]).read_text(encoding='utf-8'))
    header = ['// Generated from definitions.msg.', '#pragma once', '#include <array>', '#include <cstdint>',
              '#include <string>', '#include <tuple>', '#include <vector>', '', '#include "ros2/message_type.h"', '']
    text, path = '\n'.join(header + [cpp(name, messages) for name in messages]), pathlib.Path(sys.argv[2])
    # Unchanged, nothing is compiled anew.
    if not path.exists() or path.read_text(encoding='utf-8') != text:
        path.write_text(text, encoding='utf-8')


if __name__ == '__main__':
    main()
