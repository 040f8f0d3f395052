# SPDX-License-Identifier: Apache-2.0
"""TypeScript's view of the WebAssembly module, and the constants, with JSDoc."""
from description import HEAD, WIDTH, broken, filled

OPENING = "".join(f"// {line}\n" for line in HEAD) + "\n"
ABOUT = "The module's exports: the C library. Pointers are addresses in `memory`, int64_t are bigint."


def type_of(declaration):
    """Pointers are addresses in the module's memory."""
    return "bigint" if declaration.base == "int64_t" and not declaration.is_pointer else "number"


def comment(text, indent=""):
    lines = "\n".join(f"{indent} * {line}".rstrip() for line in filled(text, WIDTH - 3 - len(indent)).split("\n"))
    return f"{indent}/**\n{lines}\n{indent} */\n"


def function(entry):
    parameters = ", ".join(f"{each.name}: {type_of(each)}" for each in entry.parameters)
    declared = broken(f"  {entry.name}({parameters}): {type_of(entry.returns)};", "  ")
    return f"{comment(entry.comment, '  ')}{declared}\n"


def constant(entry):
    about = f"/** {entry.comment} */\n" if entry.comment else ""
    return f"{about}export const {entry.short} = {entry.value};\n"


def files(description):
    functions = "".join(map(function, description.functions))
    return {
        "bindings/javascript/c.d.ts": f"{OPENING}{comment(ABOUT)}export interface C {{\n"
        f"  memory: WebAssembly.Memory;\n{functions}}}\n",
        "bindings/javascript/constants.mjs": OPENING + "".join(map(constant, description.constants)),
    }
