# SPDX-License-Identifier: Apache-2.0
"""What can be mutated: every candidate in a tree of C++ sources, found in Clang's syntax tree.

A candidate is a dict: file, begin and end (bytes), line, kind, form, original, mutated, changes. Its form is "expression"
(the text is replaced by a choice of two), "condition" (negated) or "statement" (left out); `changes` where the text calls a
function that may change its arguments or its object, or the change may be a call without end. What the compiler evaluates,
and what comes of a macro, is passed over.
"""

import re

from clang.cindex import CursorKind as K
from clang.cindex import Index, TranslationUnit, TypeKind

COMPARISONS = {"<": ["<=", ">="], "<=": ["<", ">"], ">": [">=", "<="], ">=": [">", "<"], "==": ["!="], "!=": ["=="]}
ARITHMETIC = {"+": ["-"], "-": ["+"], "*": ["/"], "/": ["*"]}
LOGIC = {"&&": ["||"], "||": ["&&"]}
MASKS = {"both": ["either"], "either": ["both"], "and_not": ["both"]}
EXTREMA = {"min": ["max"], "max": ["min"]}
# Functions with a number of roundoffs, or its logarithm, for the argument of a template: changed by a factor.
TEMPLATES = {"decided_by_gap": ("{} - 3", "{} + 12"), "raised": ("{} / 8", "{} * 64")}
# Functions whose value is a bound or a limit of a guard.
BOUNDS = {"roundoffs", "guard_power", "underflow_allowance", "power"}
ASSIGNMENTS = {"=", "+=", "-=", "*=", "/=", "|=", "&=", "^=", "<<=", ">>="}
SCOPES = {K.NAMESPACE, K.LINKAGE_SPEC, K.CLASS_DECL, K.STRUCT_DECL, K.CLASS_TEMPLATE,
          K.CLASS_TEMPLATE_PARTIAL_SPECIALIZATION}
FUNCTIONS = {K.FUNCTION_DECL, K.CXX_METHOD, K.FUNCTION_TEMPLATE, K.CONSTRUCTOR, K.DESTRUCTOR, K.CONVERSION_FUNCTION}
NOT_ENTERED = {K.STATIC_ASSERT, K.ENUM_DECL, K.CXX_UNARY_EXPR, K.CONCEPT_DECL, K.DECL_REF_EXPR, K.OVERLOADED_DECL_REF,
               K.TYPE_ALIAS_DECL, K.TYPEDEF_DECL, K.USING_DECLARATION, K.TYPE_REF, K.TEMPLATE_REF, K.PARM_DECL,
               K.TEMPLATE_TYPE_PARAMETER, K.TEMPLATE_NON_TYPE_PARAMETER, K.FRIEND_DECL, K.TYPE_ALIAS_TEMPLATE_DECL}
NUMBER = re.compile(rb"(0x[0-9a-fA-F.']+(p[+-]?\d+)?|[\d.']+(e[+-]?\d+)?)([fFuUlL]*)$")


class Finder:
    """Gathers candidates of the files for which `wanted(path)` is true; these call functions of the files for which
    `own(path)` is."""

    def __init__(self, wanted, own=None):
        self.wanted, self.own, self.found, self.texts, self.done = wanted, own or wanted, [], {}, set()
        self.changing, self.declared = set(), set()

    def parse(self, path, arguments, text=None):
        """One translation unit; files that an earlier one had are not gathered again."""
        unit = Index.create().parse(path, args=arguments, unsaved_files=[(path, text)] if text else None,
                                    options=TranslationUnit.PARSE_DETAILED_PROCESSING_RECORD)
        errors = [str(d) for d in unit.diagnostics if d.severity >= 3]
        if errors:
            raise SystemExit("mutate: " + errors[0])
        macros, now, declared = {}, set(), set()
        for cursor in unit.cursor.get_children():
            file = cursor.location.file
            if file is not None and self.own(file.name) and file.name not in self.declared and not cursor.kind.is_preprocessing():
                declared.add(file.name)
                self.note_changing(cursor)
            if file is None or not self.wanted(file.name) or file.name in self.done:
                continue
            if cursor.kind == K.MACRO_INSTANTIATION:
                macros.setdefault(file.name, []).append((cursor.extent.start.offset, cursor.extent.end.offset))
            elif not cursor.kind.is_preprocessing():
                now.add(file.name)
                self.file, self.macros = file.name, macros.get(file.name, [])
                if file.name not in self.texts:
                    self.texts[file.name] = open(file.name, "rb").read()
                self.text = self.texts[file.name]
                self.visit(cursor)
        self.done |= now
        self.declared |= declared

    def note_changing(self, cursor):
        """By name: what a call in a template means is not known."""
        if cursor.kind in SCOPES:
            for child in cursor.get_children():
                self.note_changing(child)
        elif cursor.kind in FUNCTIONS:
            of_object = cursor.semantic_parent.kind in SCOPES - {K.NAMESPACE, K.LINKAGE_SPEC} and \
                not cursor.is_static_method() and not cursor.is_const_method()
            parameters = [c.type for c in cursor.get_children() if c.kind == K.PARM_DECL]
            if of_object or any(t.kind in (TypeKind.LVALUEREFERENCE, TypeKind.POINTER) and
                                not t.get_pointee().is_const_qualified() for t in parameters):
                self.changing.add(cursor.spelling.split("<")[0])

    def unique(self):
        """Each candidate once, in the order of the files; a template's pattern may be met twice."""
        seen = {(c["file"], c["begin"], c["end"], c["form"], c["mutated"]): c for c in self.found}
        called = re.compile(r"(\w+)\s*(?:<[^<>()]*>)?\(")
        return [dict(seen[key], changes=self.calls_itself(key) or
                     any(name in self.changing for name in called.findall(seen[key]["original"]))) for key in sorted(seen)]

    def calls_itself(self, key):
        """Whether an operator is defined in that line, of which the change may be another call."""
        file, begin = key[:2]
        text = self.texts[file]
        return b" operator" in text[text.rfind(b"\n", 0, begin) + 1:begin]

    # ---- the walk

    def visit(self, cursor):
        kind = cursor.kind
        if kind in NOT_ENTERED or self.constant(cursor):
            return
        children = list(cursor.get_children())
        if kind in FUNCTIONS or kind == K.LAMBDA_EXPR:
            entered = [c for c in children if c.kind == K.COMPOUND_STMT or (kind == K.CONSTRUCTOR and c.kind.is_expression())]
        elif kind in (K.VAR_DECL, K.FIELD_DECL):
            # Not the bound of an array.
            entered = [c for c in children[-1:] if c.extent.start.offset > cursor.location.offset and
                       self.text[c.extent.start.offset - 1:c.extent.start.offset] != b"["]
        elif kind == K.CASE_STMT:
            entered = children[1:]
        elif kind == K.IF_STMT and self.of(cursor).startswith(b"if constexpr"):
            entered = [c for c in children if not c.kind.is_expression()]
            self.gather(cursor, children)
        elif kind == K.MEMBER_REF_EXPR:
            entered = [c for c in children if c.extent.start.offset == cursor.extent.start.offset]
        else:
            entered = children
            self.gather(cursor, children)
        for child in entered:
            if child.kind == K.DECL_REF_EXPR:
                self.name(child)
            self.visit(child)

    def constant(self, cursor):
        start = cursor.extent.start.offset
        if cursor.kind == K.CALL_EXPR and self.text.startswith(b"__builtin_prefetch", start):
            return True
        if cursor.kind in FUNCTIONS:
            return b"consteval" in self.text[start:cursor.location.offset]
        # What specialises a template of variables has no kind of its own.
        if cursor.kind in (K.VAR_DECL, K.FIELD_DECL, K.UNEXPOSED_DECL):
            # Of the second of two names the text begins at the comma.
            begin = max(self.text.rfind(c, 0, start) for c in (b";", b"{", b"}")) + 1
            return re.search(rb"constexpr|constinit", self.text[start:cursor.location.offset]) is not None or \
                re.search(rb"(^|\n) *(static |inline )*(constexpr|constinit) [^;{}]*$", self.text[begin:start]) is not None
        return False

    def is_code(self, cursor):
        begin, end = cursor.extent.start.offset, cursor.extent.end.offset
        files = (cursor.extent.start.file, cursor.extent.end.file)
        if end <= begin or any(f is None or f.name != self.file for f in files):
            return False
        if self.text[begin - 1:begin] == b"<" or self.text[end:end + 1] == b">":
            return False  # an argument of a template
        if re.search(rb"integer_sequence<[^<>;]*$", self.text[max(0, begin - 120):begin]):
            return False  # a part of one
        return not self.is_operand_of_decltype(begin) and not any(a < end and begin < b for a, b in self.macros)

    def is_operand_of_decltype(self, begin):
        at = self.text.rfind(b"decltype(", 0, begin)
        depth = 0
        for c in self.text[at + len(b"decltype"):begin] if at >= 0 else b"":
            depth += (c == ord("(")) - (c == ord(")"))
            if depth == 0:
                return False
        return at >= 0

    # ---- what a node offers

    def gather(self, cursor, children):
        kind = cursor.kind
        if kind == K.BINARY_OPERATOR or (kind == K.CALL_EXPR and len(children) >= 2):
            self.binary(cursor, children)
        if kind == K.UNARY_OPERATOR:
            self.unary(cursor, children)
        elif kind in (K.INTEGER_LITERAL, K.FLOATING_LITERAL):
            self.number(cursor)
        elif kind == K.CXX_BOOL_LITERAL_EXPR:
            self.expression(cursor, "verdict", {b"true": b"false", b"false": b"true"}.get(self.of(cursor)))
        elif kind == K.CALL_EXPR:
            self.call(cursor, children)
        elif kind == K.IF_STMT and not self.of(cursor).startswith(b"if constexpr"):
            self.condition(next((c for c in children if c.kind.is_expression()), None), "negated")
        elif kind == K.CONDITIONAL_OPERATOR:
            self.condition(children[0], "negated")
        elif kind == K.RETURN_STMT and children and children[0].type.kind == TypeKind.BOOL:
            self.condition(children[0], "verdict")
        for child in self.statements(kind, children):
            self.statement(child)

    def of(self, cursor):
        return self.text[cursor.extent.start.offset:cursor.extent.end.offset]

    def add(self, cursor, kind, form, mutated):
        if not self.is_code(cursor):
            return
        begin, end = cursor.extent.start.offset, cursor.extent.end.offset
        self.found.append({
            "file": self.file, "begin": begin, "end": end, "line": cursor.extent.start.line, "kind": kind, "form": form,
            "original": self.text[begin:end].decode(), "mutated": mutated.decode()})

    def expression(self, cursor, kind, mutated):
        if mutated is not None:
            self.add(cursor, kind, "expression", mutated)

    def condition(self, cursor, kind):
        if cursor is not None and cursor.kind.is_expression():
            self.add(cursor, kind, "condition", b"!(" + self.of(cursor) + b")")

    def binary(self, cursor, children):
        left, right = children[0], children[-1]
        a, b = left.extent.end.offset, right.extent.start.offset
        operator = self.text[a:b].strip().decode()
        if left.extent.start.offset != cursor.extent.start.offset or right.extent.end.offset != cursor.extent.end.offset:
            return
        # Numbers of any size have no quotient, nor have lanes.
        divided = operator in "*/" and (cursor.kind == K.CALL_EXPR or re.search("/(exact|filter|kernels)/", self.file))
        for kind, table in (("comparison", COMPARISONS), ("arithmetic", ARITHMETIC), ("logic", LOGIC)):
            for other in [] if divided else table.get(operator, []):
                self.expression(cursor, kind, self.text[cursor.extent.start.offset:a] + b" " + other.encode() + b" " +
                                self.text[b:cursor.extent.end.offset])

    def unary(self, cursor, children):
        operator = self.of(cursor)[:1]
        if operator == b"-" and self.of(cursor)[1:2] != b"-":
            self.expression(cursor, "sign", self.of(children[0]))
        elif operator == b"!":
            self.expression(cursor, "negated", b"static_cast<bool>(" + self.of(children[0]) + b")")

    def number(self, cursor):
        text = self.of(cursor)
        match = NUMBER.match(text)
        if not match or "/lanes/" in self.file:
            return
        if cursor.kind == K.INTEGER_LITERAL:
            self.expression(cursor, "constant", text + b" + 1")
        elif not float.fromhex(text.rstrip(b"fFlL").decode()) if text.startswith(b"0x") else float(text.rstrip(b"fFlL")) == 0:
            self.expression(cursor, "constant", b"1.0" + match[4])
        else:
            self.expression(cursor, "constant", text + b" * 8")
            self.expression(cursor, "constant", text + b" / 8")

    def call(self, cursor, children):
        head = re.match(rb"[\w:]*?(\w+)\s*(<[^()]*>)?\(", self.of(cursor))
        if not head:
            return
        name = head[1].decode()
        for table, kind in ((EXTREMA, "extremum"), (MASKS, "logic")):
            for other in table.get(name, []):
                a, b = head.span(1)
                self.expression(cursor, kind, self.of(cursor)[:a] + other.encode() + self.of(cursor)[b:])
        number = re.search(r"(-?\d+)>$", (head[2] or b"").decode())
        for other in TEMPLATES.get(name, []) if number else []:
            a, b = head.start(2) + number.start(1), head.start(2) + number.end(1)
            self.expression(cursor, "bound", self.of(cursor)[:a] + other.format(number[1]).encode() + self.of(cursor)[b:])
        if name in BOUNDS:
            self.bound(cursor)

    def bound(self, cursor):
        text = self.of(cursor)
        for factor in (b"0.125f", b"4096.0f"):
            self.expression(cursor, "bound", b"std::remove_cvref_t<decltype(" + text + b")>(" + factor + b") * (" + text + b")")

    def name(self, cursor):
        target = cursor.referenced
        if target is None:
            return
        if target.kind == K.ENUM_CONSTANT_DECL:
            names = [c.spelling for c in target.semantic_parent.get_children() if c.kind == K.ENUM_CONSTANT_DECL]
            other = names[(names.index(target.spelling) + 1) % len(names)]
            text = self.of(cursor)
            if text.endswith(target.spelling.encode()) and other != target.spelling:
                self.expression(cursor, "verdict", text[:len(text) - len(target.spelling)] + other.encode())
        elif target.spelling == "roundoff":
            self.bound(cursor)

    @staticmethod
    def statements(kind, children):
        if kind == K.COMPOUND_STMT:
            return children
        if kind == K.IF_STMT:
            return [c for c in children[1:] if c.kind != K.COMPOUND_STMT]
        return []

    def statement(self, cursor):
        if cursor.kind in (K.CALL_EXPR, K.COMPOUND_ASSIGNMENT_OPERATOR):
            removable = True
        elif cursor.kind == K.BINARY_OPERATOR:
            children = list(cursor.get_children())
            removable = self.text[children[0].extent.end.offset:children[-1].extent.start.offset].strip() == b"="
        else:
            removable = False
        # Between statements, what precedes one is the end of another or of a condition.
        before = self.text[:cursor.extent.start.offset].rstrip()[-1:]
        if removable and before in (b";", b"{", b"}", b")") and \
                self.text[cursor.extent.end.offset:cursor.extent.end.offset + 1] == b";":
            self.add(cursor, "statement", "statement", b"")

