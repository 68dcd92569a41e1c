"""The finder of scripts/mutate: small wrong changes of C++ sources, and sources that contain many of them at once.

find() reads a file with libclang and lists every change; weave() returns the file with some of them behind a run-time
switch (TP100_MUTANT(id) of mutant.h), so that one build is enough for all.
"""
import dataclasses
import re

from clang.cindex import Config, CursorKind, Index, StorageClass, TranslationUnit, TypeKind

SWAPS = {'<': '<=', '<=': '<', '>': '>=', '>=': '>', '==': '!=', '!=': '==', '+': '-', '-': '+', '*': '/', '/': '*',
         '%': '/', '&&': '||', '||': '&&', '&': '|', '|': '&', '^': '|', '<<': '>>', '>>': '<<',
         '+=': '-=', '-=': '+=', '*=': '/=', '/=': '*=', '|=': '&=', '&=': '|=', '^=': '|=',
         '<<=': '>>=', '>>=': '<<=', '++': '--', '--': '++'}
# Two floating-point values are hardly ever equal: only the other direction makes a difference.
FLOAT_SWAPS = SWAPS | {'<': '>', '<=': '>=', '>': '<', '>=': '<='}
CALLS = {'min': 'max', 'max': 'min', 'sin': 'cos', 'cos': 'sin', 'floor': 'ceil', 'ceil': 'floor', 'abs': ''}
NOTHING = {'{}', '0', '0.0', '0.0f', '0.0F', 'false', 'nullptr', 'std::nullopt', '""'}
FUNCTIONS = {CursorKind.FUNCTION_DECL, CursorKind.CXX_METHOD, CursorKind.CONSTRUCTOR, CursorKind.DESTRUCTOR,
             CursorKind.FUNCTION_TEMPLATE, CursorKind.CONVERSION_FUNCTION}
LITERALS = {CursorKind.INTEGER_LITERAL, CursorKind.FLOATING_LITERAL}
BLOCKS = {CursorKind.COMPOUND_STMT, CursorKind.IF_STMT, CursorKind.FOR_STMT, CursorKind.WHILE_STMT,
          CursorKind.DO_STMT, CursorKind.CXX_FOR_RANGE_STMT, CursorKind.CASE_STMT, CursorKind.DEFAULT_STMT}
FLOATS = {TypeKind.FLOAT, TypeKind.DOUBLE, TypeKind.LONGDOUBLE}
INTEGERS = {TypeKind.UCHAR, TypeKind.USHORT, TypeKind.UINT, TypeKind.ULONG, TypeKind.ULONGLONG, TypeKind.SCHAR,
            TypeKind.SHORT, TypeKind.INT, TypeKind.LONG, TypeKind.LONGLONG, TypeKind.CHAR_S}


@dataclasses.dataclass(frozen=True)
class Site:
    """text[begin:end] becomes `other`. A statement includes its semicolon; `cast`: type to which both are cast."""
    begin: int
    end: int
    other: str
    statement: bool = False
    cast: str = ''


@dataclasses.dataclass(frozen=True)
class Mutant:
    """One change of `path`: at one site, or at each use of a constant. before and after are lines without indent."""
    path: str
    line: int
    before: str
    after: str
    nth: int
    sites: tuple

    @property
    def key(self):
        return f'{self.path}|{self.before}|{self.after}|{self.nth}'


class _Finder:
    def __init__(self, text, unit):
        self.text = text
        self.unit = unit
        self.found = {}      # Site: order
        self.returns = True  # the function that is visited
        self.constants = {}  # name of the constant: its uses
        self.macros = [(c.extent.start.offset, c.extent.end.offset) for c in unit.cursor.get_children()
                       if c.kind == CursorKind.MACRO_INSTANTIATION and self.here(c)]

    def here(self, cursor):
        file = cursor.extent.start.file
        return file is not None and file.name == self.unit.spelling

    def range(self, cursor):
        return cursor.extent.start.offset, cursor.extent.end.offset

    def add(self, begin, end, other, **more):
        self.found.setdefault(Site(begin, end, other, **more), len(self.found))

    def between(self, begin, end):
        """The operator between two operands, and where it is."""
        gap = re.sub(r'//[^\n]*|/\*.*?\*/', lambda m: ' ' * len(m[0]), self.text[begin:end], flags=re.S)
        match = re.fullmatch(r'[\s)]*([-+*/%<>=!&|^]+)[\s(]*', gap)
        return (match[1], begin + match.start(1)) if match else (None, 0)

    def declarations(self, cursor):
        for child in cursor.get_children():
            if child.kind == CursorKind.TRANSLATION_UNIT or not self.here(child):
                continue
            if child.kind in FUNCTIONS:
                self.returns = '[[noreturn]]' not in self.head(child)
                for part in child.get_children():
                    if part.kind == CursorKind.COMPOUND_STMT or part.kind.is_expression():
                        self.visit(part, child, [])
            elif child.kind == CursorKind.FIELD_DECL:
                self.initial(child, [])
            elif child.kind in {CursorKind.NAMESPACE, CursorKind.CLASS_DECL, CursorKind.STRUCT_DECL,
                                CursorKind.CLASS_TEMPLATE, CursorKind.UNEXPOSED_DECL, CursorKind.LINKAGE_SPEC}:
                self.declarations(child)

    def head(self, function):
        """Its text up to the body, with the attributes before it."""
        begin, end = self.range(function)
        return self.text[self.text.rfind('\n', 0, begin) + 1:end].split('{')[0]

    def initial(self, declaration, above):
        """Visits only the value of a variable: other expressions in a declaration belong to its type."""
        children = list(declaration.get_children())
        begin, end = self.range(declaration)
        if not children or not children[-1].kind.is_expression() or children[-1].extent.end.offset != end:
            return
        if re.search(r'\bconstexpr\b', self.text[begin:end]):
            return
        self.visit(children[-1], declaration, above + [declaration])

    def visit(self, cursor, parent, above):
        """above: the enclosing nodes, outermost first, for changes that cannot be written as a conditional operator."""
        if not self.here(cursor):
            return
        begin, end = self.range(cursor)
        if any(b <= begin and end <= e for b, e in self.macros):
            return
        children = list(cursor.get_children())
        kind = cursor.kind
        if kind == CursorKind.VAR_DECL:
            # The compiler evaluates a table.
            if cursor.storage_class != StorageClass.STATIC or cursor.type.kind != TypeKind.CONSTANTARRAY:
                self.initial(cursor, above)
            return
        if kind in {CursorKind.STATIC_ASSERT, CursorKind.TYPE_ALIAS_DECL}:
            return
        if kind == CursorKind.LAMBDA_EXPR:
            for child in children:
                if child.kind == CursorKind.COMPOUND_STMT:
                    self.visit(child, cursor, [])
            return
        if kind == CursorKind.CASE_STMT:
            children = children[1:]
        if kind.is_expression() and parent.kind in BLOCKS and self.is_statement(cursor, parent):
            self.statement(cursor, children)
        if kind == CursorKind.RETURN_STMT and children:
            self.returned(cursor, children[0])
        elif kind == CursorKind.IF_STMT:
            if re.match(r'if\s+constexpr', self.text[begin:end]):
                children = children[1:]
            elif children[0].kind.is_expression() and self.text[:self.range(children[0])[0]].rstrip().endswith('('):
                self.negated(children[0])
        elif kind == CursorKind.CONDITIONAL_OPERATOR:
            self.negated(children[0])
        elif kind in {CursorKind.BINARY_OPERATOR, CursorKind.COMPOUND_ASSIGNMENT_OPERATOR} and len(children) == 2:
            self.binary(cursor, children, [])
        elif kind == CursorKind.UNARY_OPERATOR:
            self.unary(cursor, children[0])
        elif kind == CursorKind.CALL_EXPR:
            self.call(cursor, children, above)
        elif kind in LITERALS and parent.kind not in {CursorKind.MEMBER_REF_EXPR, CursorKind.DECL_REF_EXPR}:
            # A tokenless literal stands for something else, such as a default argument.
            if re.fullmatch(r"[\d.][\w.'+-]*", self.text[begin:end]):
                self.add(begin, end, changed(self.text[begin:end], kind == CursorKind.FLOATING_LITERAL))
        elif kind == CursorKind.CXX_BOOL_LITERAL_EXPR and parent.kind != CursorKind.RETURN_STMT:
            self.add(begin, end, 'false' if self.text[begin:end] == 'true' else 'true')
        elif kind == CursorKind.DECL_REF_EXPR:
            self.constant(cursor)
        for child in children:
            self.visit(child, cursor, above + [cursor])

    def is_statement(self, cursor, parent):
        if parent.kind == CursorKind.COMPOUND_STMT:
            return True
        begin, end = self.range(cursor)
        before = self.text[self.range(parent)[0]:begin].rstrip()
        follows = re.match(r'\s*;', self.text[end:])
        if not follows or self.text[begin:end] == '':
            return False
        if parent.kind in {CursorKind.CASE_STMT, CursorKind.DEFAULT_STMT}:
            return before.endswith(':')
        # The body follows the parenthesis that ends the head, or else or do.
        return (before.endswith(')') and before.count('(') == before.count(')')) or \
            re.search(r'\b(else|do)$', before) is not None

    def semicolon(self, end):
        match = re.match(r'\s*;', self.text[end:])
        return end + match.end() if match else None

    def statement(self, cursor, children):
        begin, end = self.range(cursor)
        end = self.semicolon(end)
        if end and (self.returns or not self.text.startswith('throw', begin)):
            self.add(begin, end, ';', statement=True)

    def returned(self, cursor, value):
        begin, end = self.range(cursor)
        end = self.semicolon(end)
        inside = self.text[slice(*self.range(value))]
        if not end or inside in NOTHING - {'false'}:
            return
        if value.type.get_canonical().kind == TypeKind.BOOL:
            self.add(begin, end, f'return !({inside});', statement=True)
        elif value.type.get_canonical().kind != TypeKind.VOID and not (
                value.kind == CursorKind.DECL_REF_EXPR and value.referenced.kind == CursorKind.ENUM_CONSTANT_DECL and
                value.referenced.enum_value == 0):
            self.add(begin, end, 'return {};', statement=True)

    def negated(self, condition):
        begin, end = self.range(condition)
        self.add(begin, end, f'!({self.text[begin:end]})')

    def binary(self, cursor, operands, above):
        begin, end = self.range(cursor)
        operator, at = self.between(self.range(operands[0])[1], self.range(operands[1])[0])
        floating = any(operand.type.get_canonical().kind in FLOATS for operand in operands)
        swaps = FLOAT_SWAPS if floating else SWAPS
        if operator in swaps:
            self.replaced(begin, end, at, at + len(operator), swaps[operator], above)

    def replaced(self, begin, end, at, to, other, above):
        """The expression with text[at:to] changed. With class types the two may differ in type (Eigen has a type for
        each formula): then the whole statement, or the variable's value, is duplicated instead."""
        statement, cast = False, ''
        for outer in reversed(above):
            outer_begin, outer_end = self.range(outer)
            if outer.kind == CursorKind.VAR_DECL:
                if 'auto' in self.text[outer_begin:begin].split():
                    return
                cast = outer.spelling
                begin, end = self.range(list(outer.get_children())[-1])
                break
            if outer.kind in BLOCKS or outer.kind == CursorKind.RETURN_STMT:
                break
            begin, end = outer_begin, outer_end
        if above and not cast:
            top = next((c for c in reversed(above) if c.kind == CursorKind.RETURN_STMT), None)
            if top is not None:
                begin, end = self.range(top)
            end = self.semicolon(end)
            statement = True
            if not end:
                return
        self.add(begin, end, self.text[begin:at] + other + self.text[to:end], statement=statement, cast=cast)

    def unary(self, cursor, operand):
        begin, end = self.range(cursor)
        inner_begin, inner_end = self.range(operand)
        prefix, postfix = self.text[begin:inner_begin].strip('( \n'), self.text[inner_end:end].strip(') \n')
        inside = self.text[inner_begin:inner_end]
        if prefix in {'!', '-', '~'}:
            # Without a cast, the result of `!` may be converted to the operand's class (std::optional).
            cast = 'true' if prefix == '!' and self.is_object(operand) else ''
            self.add(begin, end, self.text[begin:end].replace(prefix, '', 1), cast=cast)
        elif prefix in {'++', '--'}:
            self.add(begin, end, SWAPS[prefix] + inside)
        elif postfix in {'++', '--'}:
            self.add(begin, end, inside + SWAPS[postfix])

    def is_object(self, cursor):
        return any(c.type.get_canonical().kind == TypeKind.RECORD for c in cursor.walk_preorder()
                   if self.range(c) == self.range(cursor))

    def call(self, cursor, children, above):
        begin, end = self.range(cursor)
        name = cursor.spelling
        if name.startswith('operator') and len(children) == 3:
            symbol = name.removeprefix('operator')
            if symbol not in SWAPS or symbol in {'<<', '>>'}:
                return
            operator, at = self.between(self.range(children[0])[1], self.range(children[2])[0])
            if operator != symbol:
                return
            simple = cursor.type.get_canonical().kind == TypeKind.BOOL
            self.replaced(begin, end, at, at + len(operator), SWAPS[operator], [] if simple else above)
        elif name in CALLS and children:
            callee_begin, callee_end = self.range(children[0])
            callee = self.text[callee_begin:callee_end]
            if callee.startswith('std::'):
                other = callee.replace(name, CALLS[name], 1) if CALLS[name] else ''
                self.add(begin, end, other + self.text[callee_end:end])

    def constant(self, cursor):
        target = cursor.referenced
        if target is None or target.kind != CursorKind.VAR_DECL or not target.type.is_const_qualified():
            return
        if target.semantic_parent.kind in FUNCTIONS or target.location.file is None:
            return
        if target.location.file.name.startswith('/usr/'):
            return
        kind = target.type.get_canonical().kind
        begin, end = self.range(cursor)
        text = self.text[begin:end]
        if kind in FLOATS | INTEGERS:
            self.constants.setdefault(cursor.spelling, {})[Site(begin, end, changed(text, kind in FLOATS))] = True


def changed(value, floating):
    """Another value than the literal or constant `value`."""
    if value.isdecimal() and (value == '0' or value[0] != '0'):
        return str(int(value) + 1)
    if re.fullmatch(r'0\.0*[fF]?', value):
        return '1' + value[1:]
    return f'(2 * {value})' if floating else f'({value} + 1)'


def find(path, shown, arguments):
    """The mutants of a file, in the order of the text. `shown`: its name in results; `arguments`: the compiler's."""
    with open(path, encoding='latin-1', newline='') as file:
        text = file.read()
    unit = Index.create().parse(path, args=arguments, options=TranslationUnit.PARSE_DETAILED_PROCESSING_RECORD)
    fatal = [d for d in unit.diagnostics if d.severity >= d.Error]
    if fatal:
        raise ValueError(f'{shown}: clang does not read it: {fatal[0]}')
    finder = _Finder(text, unit)
    finder.declarations(unit.cursor)
    groups = [(site,) for site in finder.found] + \
        [tuple(sorted(sites, key=lambda site: site.begin)) for sites in finder.constants.values()]
    groups.sort(key=lambda sites: (sites[0].begin, sites[0].end, sites[0].other))
    mutants, seen = [], {}
    for sites in groups:
        before, after = lines(text, sites[0])
        nth = seen[before, after] = seen.get((before, after), 0) + 1
        mutants.append(Mutant(shown, text.count('\n', 0, sites[0].begin) + 1, before, after, nth, sites))
    return mutants


def lines(text, site):
    """The lines of a site before and after the change, each joined into one line."""
    begin = text.rfind('\n', 0, site.begin) + 1
    end = text.find('\n', site.end)
    before, head, tail = text[begin:end], text[begin:site.begin], text[site.end:end]
    was = text[site.begin:site.end]
    after = head + (f'/* {was} */' if site.other == ';' else site.other) + tail
    return ' '.join(before.split()), ' '.join(after.split())


def weave(text, mutants, head):
    """The text with all of `mutants` ({id: mutant}) in it below `head`, and where each is: [(begin, end, ids)], the
    innermost last."""
    groups = {}
    for number, mutant in mutants.items():
        for site in mutant.sites:
            groups.setdefault((site.begin, site.end, site.statement, site.cast), []).append((number, site.other))
    # Outer sites first; of two at the same place the statement is the outer one.
    order = sorted(groups, key=lambda group: (group[0], -group[1], not group[2], group[3]))
    places = []

    def write(begin, end, inside, at):
        """text[begin:end] with the groups `inside` it woven in; `at` is its offset in the output."""
        out, last = '', begin
        while inside:
            group = inside.pop(0)
            within = []
            while inside and inside[0][1] <= group[1]:
                within.append(inside.pop(0))
            out += text[last:group[0]]
            start = at + len(out)
            mine = len(places)
            places.append(None)
            _, _, statement, cast = group
            if statement:
                others = ''.join(f'if (TP100_MUTANT({n})) {{ {other} }} else ' for n, other in groups[group])
                head, foot = '{ ' + others + '{ ', ' } }'
            else:
                to = f'TP100_MUTANT_TYPE({cast})' if cast else ''
                head = '(' + ''.join(f'TP100_MUTANT({n}) ? {to}({other}) : ' for n, other in groups[group]) + to + '('
                foot = '))'
            out += head
            out += write(group[0], group[1], within, at + len(out)) + foot
            places[mine] = (start, at + len(out), [n for n, _ in groups[group]])
            last = group[1]
        return out + text[last:end]

    woven = write(0, len(text), order, len(head))
    return head + woven, places
