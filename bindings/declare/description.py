# SPDX-License-Identifier: Apache-2.0
"""What the declarations of every language are made from: ../vesica.json, read once."""
import json
import pathlib
import re
import textwrap

REPOSITORY = pathlib.Path(__file__).resolve().parent.parent.parent
DESCRIPTION = REPOSITORY / "capi" / "vesica.json"
# The named methods are another library, which no package has.
LIBRARY = "libvesica.so"
HEAD = "SPDX-License-Identifier: Apache-2.0", "Written by bindings/declare from capi/vesica.json: not to be edited."
GROUPS = {
    "KINDS": (
        *("POINT", "SEGMENT", "CIRCLE", "AABB", "RECT", "ELLIPSE", "CAPSULE", "ROUND_RECT"),
        *("POLYGON", "POLYLINE"),
    ),
    "RELATIONS": ("DISJOINT", "TOUCH", "CROSS", "INSIDE", "INSIDE_TOUCH", "CONTAINS", "CONTAINS_TOUCH", "EQUAL"),
}
#: The stems of the structs of one shape that are numbers.
SHAPES = tuple(kind.lower() for kind in GROUPS["KINDS"] if not kind.startswith("POLY"))
PREFIXES = {
    "ANGLE_": "ANGLES",
    "CAST_": "CASTS",
    "DECAY_": "DECAYS",
    "E_": "ERRORS",
    "FUSED_": "FUSED_SCORES",
    "JOIN_": "JOINS",
    "MATCH_": "MATCH_RULES",
    "OUTCOME_": "OUTCOMES",
    "PRECISION_": "PRECISION_RULES",
    "RATIO_": "RATIOS",
    "TRUTH_": "TRUTHS",
    "VERSION": "VERSIONS",
    "WITHIN_": "WITHINS",
}
#: Groups that languages have an enum for: its name, and what it tells.
ENUMS = {
    "KINDS": ("Kind", "The kinds of shapes."),
    "RELATIONS": ("Relation", "How a shape a relates to a shape b: the eight relations of RCC-8."),
    "JOINS": ("JoinQuery", "What makes item a of one index and item b of another a pair of a join."),
    "RATIOS": ("Ratio", "What a shared area is compared with."),
    "ANGLES": ("Angle", "How angles are told. They turn from +x towards +y."),
    "DECAYS": ("Decay", "How soft suppression lowers scores."),
    "WITHINS": ("Within", "Whether two shapes are at most so far apart."),
    "CASTS": ("Cast", "What a cast finds."),
    "FUSED_SCORES": ("FusedScore", "The score of a cluster of boxes that were fused."),
    "MATCH_RULES": ("MatchRule", "Which truth a detection takes, of those whose value is at least the threshold."),
    "TRUTHS": ("Truth", "The part of a truth in the result."),
    "OUTCOMES": ("Outcome", "What a detection is."),
    "PRECISION_RULES": ("PrecisionRule", "How precision is averaged over recall."),
    "ERRORS": ("ErrorCode", "Why the library has no answer."),
}
SCALARS = {"f64": "double", "f32": "float"}
#: The longest line of what is written.
WIDTH = 120

_PARTS = re.compile(r"\n(?=(?:Requires|Returns|Errors|Accuracy|Cost|Since): )")


class Entry:
    """A constant, a struct or a function."""

    def __init__(self, entry):
        self.name = entry["name"]
        self.comment = entry["comment"]
        self.value = entry.get("value")
        self.fields = [Declaration(field) for field in entry.get("fields", ())]
        self.returns = Declaration({"name": "", "type": entry.get("returns", "void")})
        self.parameters = [Declaration(parameter) for parameter in entry.get("parameters", ())]
        for parameter, following in zip(self.parameters, self.parameters[1:]):
            parameter.is_sets = parameter.is_shapes and following.name.startswith("set_count")

    @property
    def short(self):
        """The name without the library's."""
        return self.name.removeprefix("vesica_").removeprefix("VESICA_")

    @property
    def own(self):
        """A constant's name without its group's."""
        prefix = next((each for each in PREFIXES if each.endswith("_") and self.short.startswith(each)), "")
        return self.short.removeprefix(prefix)

    @property
    def meaning(self):
        """A constant's text; of one that says all by its name, that."""
        return self.comment or self.own.lower().replace("_", " ")

    @property
    def scalar(self):
        """f64, f32, or None."""
        return self.name[-3:] if self.name.endswith(("_f64", "_f32")) else None

    @property
    def has_pointers(self):
        """True if a struct leads to other memory."""
        return any(field.is_pointer for field in self.fields)

    @property
    def is_of_scalars(self):
        """True if all fields of a struct are numbers of its scalar type."""
        return all(field.base in ("double", "float") and not field.is_pointer for field in self.fields)

    @property
    def stem(self):
        """The name that the forms in double and in float share."""
        return self.short[:-4] if self.scalar else self.short

    @property
    def paragraphs(self):
        """The text: paragraphs of the description, and one for each part."""
        return [paragraph for text in self.comment.split("\n\n") for paragraph in _PARTS.split(text)]


class Declaration:
    """A field, a parameter or a result."""

    def __init__(self, declaration):
        self.name = declaration["name"]
        self.type = declaration["type"]
        self.count = declaration.get("count")
        self.is_const = self.type.startswith("const ")
        self.base = self.type.removeprefix("const ").rstrip(" *")
        self.is_pointer = "*" in self.type
        #: An array of shapes that is read; of several sets the first.
        self.is_shapes = self.is_const and self.base.startswith("vesica_shapes_")
        self.is_sets = False
        #: One shape of any kind: a pointer to its struct.
        self.is_shape = self.type == "const void *" and self.name in ("a", "b", "shape")


class Description:
    """What libvesica has: constants, structs and functions, in the headers' order."""

    def __init__(self):
        description = json.loads(DESCRIPTION.read_text())
        self.version = description["version"]
        headers = [header for header, library in description["libraries"].items() if library.startswith(LIBRARY)]
        for part in ("constants", "structs", "functions"):
            entries = [Entry(entry) for entry in description[part] if entry["header"] in headers]
            setattr(self, part, entries)

    def constants_of(self, group):
        """The constants of a group: a key of GROUPS or a value of PREFIXES."""
        return [entry for entry in self.constants if group_of(entry) == group]

    def in_double(self, part):
        """The entries of a part that have a form in double, and one in float of the same stem."""
        return [entry for entry in getattr(self, part) if entry.scalar == "f64"]


def group_of(constant):
    """Which constants belong together, by their names; other groups have the first word of theirs."""
    for group, names in GROUPS.items():
        if constant.short in names:
            return group
    for prefix, group in PREFIXES.items():
        if constant.short.startswith(prefix):
            return group
    return constant.short.split("_")[0]


def camel(name, first=True):
    """closest_points as ClosestPoints, or closestPoints."""
    words = name.lower().split("_")
    return "".join(word.capitalize() if i or first else word for i, word in enumerate(words))


def filled(text, width):
    """A text without a line longer than that: the paragraphs, and parts such as Returns:, that had one are laid out
    anew."""
    pieces = []
    for piece in re.split(r"(\n\n|\n(?=[A-Z][a-z]+: ))", text):
        if any(len(line) > width for line in piece.split("\n")):
            words = " ".join(piece.split("\n"))
            piece = "\n".join(textwrap.wrap(words, width, break_long_words=False, break_on_hyphens=False))
        pieces.append(piece)
    return "".join(pieces)


def broken(line, step="    "):
    """A statement on one line, or where it is too long on several: broken after commas, and further ones indented."""
    indent = line[: len(line) - len(line.lstrip())]
    lines, parts = [], line.split(", ")
    for i, part in enumerate(parts):
        part += ", " if i + 1 < len(parts) else ""
        if lines and len(lines[-1] + part.rstrip()) <= WIDTH:
            lines[-1] += part
        else:
            lines.append(part if not lines else indent + step + part)
    return "\n".join(each.rstrip() for each in lines)
