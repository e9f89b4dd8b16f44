#!/usr/bin/env python3
"""The page of the Python API, from the sources and the stub of the package: prints it.

Nothing is imported, so that no wheel is needed: signatures and texts are read from the syntax trees. Python's standard library only.
"""

import ast
import inspect
from pathlib import Path

PACKAGE = Path(__file__).resolve().parents[2] / "crates/loosepin-python/python/loosepin"
# The order of the page; modules that are not here come behind, in the order of their names.
ORDER = (
    *("_model", "_mechanism.run_records", "_mechanism.without_runs", "_mechanism.sweep", "_mechanism.wear", "_study", "_result", "_records"),
    *("_evaluation", "_design", "_function_bounds", "_inputs", "_surrogates", "_loosepin", "_objects.errors", "_warning"),
)
# Docstrings of modules that would not do as headings.
HEADINGS = {"_loosepin": "Errors", "_objects.errors": "Errors that are also exceptions of Python", "_warning": "Warnings"}
WIDEST_SIGNATURE = 100

Definition = ast.ClassDef | ast.FunctionDef


def parsed(module: str) -> ast.Module:
    name = module.replace(".", "/")
    path = next(path for path in (PACKAGE / f"{name}.py", PACKAGE / f"{name}.pyi") if path.exists())
    return ast.parse(path.read_text(encoding="utf-8"))


def docstring(node: ast.Module | Definition) -> str:
    return inspect.cleandoc(ast.get_docstring(node, clean=False) or "")


def public_names() -> dict[str, list[str]]:
    """The names of `__all__` by the module that defines them."""
    package = parsed("__init__")
    exported: list[str] = []
    origin: dict[str, str] = {}
    for node in package.body:
        if isinstance(node, ast.ImportFrom):
            origin |= {alias.asname or alias.name: str(node.module) for alias in node.names}
        elif isinstance(node, ast.Assign) and ast.unparse(node.targets[0]) == "__all__":
            exported = ast.literal_eval(node.value)
    found: dict[str, list[str]] = {}
    for name in exported:
        if not name.startswith("__"):
            found.setdefault(origin[name], []).append(name)
    return found


def signature(function: ast.FunctionDef, prefix: str, *, is_method: bool) -> str:
    """`Study.run(folder=None, *, resume=False) -> StudyResult`, over several lines where it is long."""
    arguments = function.args
    if is_method and arguments.args:
        arguments = ast.arguments(
            arguments.posonlyargs, arguments.args[1:], arguments.vararg, arguments.kwonlyargs, arguments.kw_defaults,
            arguments.kwarg, arguments.defaults,
        )
    returns = f" -> {ast.unparse(function.returns)}" if function.returns else ""
    line = f"{prefix}{function.name}({ast.unparse(arguments)}){returns}"
    if len(line) <= WIDEST_SIGNATURE:
        return line
    parts: list[str] = []
    plain = len(arguments.args) - len(arguments.defaults)
    for position, argument in enumerate(arguments.args):
        default = "" if position < plain else f" = {ast.unparse(arguments.defaults[position - plain])}"
        parts.append(ast.unparse(argument) + default)
    if arguments.vararg:
        parts.append(f"*{ast.unparse(arguments.vararg)}")
    elif arguments.kwonlyargs:
        parts.append("*")
    for argument, value in zip(arguments.kwonlyargs, arguments.kw_defaults):
        parts.append(ast.unparse(argument) + (f" = {ast.unparse(value)}" if value else ""))
    if arguments.kwarg:
        parts.append(f"**{ast.unparse(arguments.kwarg)}")
    return f"{prefix}{function.name}(\n" + "".join(f"    {part},\n" for part in parts) + f"){returns}"


def fields(body: list[ast.stmt]) -> list[tuple[str, str, str]]:
    """Name, type and text of the fields of a dataclass; the text stands behind the field."""
    found = []
    for position, node in enumerate(body):
        if isinstance(node, ast.AnnAssign) and not ast.unparse(node.target).startswith("_"):
            after = body[position + 1] if position + 1 < len(body) else None
            text = ""
            if isinstance(after, ast.Expr) and isinstance(after.value, ast.Constant) and isinstance(after.value.value, str):
                text = " ".join(after.value.value.split())
            default = f" = {ast.unparse(node.value)}" if node.value else ""
            found.append((ast.unparse(node.target), ast.unparse(node.annotation) + default, text))
    return found


def attributes(node: ast.ClassDef) -> list[tuple[str, str, str]]:
    """Name, type and text of what `__init__` gives an object; the text stands behind it."""
    init = next((part for part in node.body if isinstance(part, ast.FunctionDef) and part.name == "__init__"), None)
    if init is None:
        return []
    return fields([named(part) for part in init.body])


def named(part: ast.stmt) -> ast.stmt:
    """`self.name: type = value` as the field `name: type` of a dataclass; any other statement as it is."""
    if isinstance(part, ast.AnnAssign) and isinstance(part.target, ast.Attribute):
        return ast.AnnAssign(ast.Name(part.target.attr), part.annotation, None, 1)
    return part


def decorators(function: ast.FunctionDef) -> set[str]:
    return {ast.unparse(decorator) for decorator in function.decorator_list}


def described(node: ast.ClassDef) -> list[str]:
    """The paragraphs of a class."""
    bases = [ast.unparse(base) for base in node.bases]
    lines = [f"### {node.name}", ""]
    if any(base.endswith(("Error", "Exception", "Warning")) for base in bases):
        lines += [f"An exception, kind of `{', '.join(bases)}`.", ""]
    lines += [docstring(node), ""]
    listed = fields(node.body) + attributes(node)
    methods = [part for part in node.body if isinstance(part, ast.FunctionDef) and not part.name.startswith("_")]
    for method in methods:
        if decorators(method) & {"property", "cached_property"}:
            listed.append((method.name, ast.unparse(method.returns) if method.returns else "", " ".join(docstring(method).split())))
    if listed:
        lines += ["| | type | |", "|---|---|---|"]
        lines += [f"| `{name}` | `{cell(kind)}` | {cell(text)} |" for name, kind, text in listed]
        lines.append("")
    for method in methods:
        if decorators(method) & {"property", "cached_property"}:
            continue
        is_static = "staticmethod" in decorators(method)
        prefix = f"{node.name}." if decorators(method) & {"classmethod", "staticmethod"} else "."
        lines += ["```python", signature(method, prefix, is_method=not is_static), "```", "", docstring(method), ""]
    return lines


def cell(text: str) -> str:
    """Text that stays in its cell."""
    return text.replace("|", "\\|")


def table_row(name: str, node: ast.ClassDef) -> str:
    arguments = ", ".join(f"{field}={kind.split(' = ', 1)[1]}" if " = " in kind else field for field, kind, _ in fields(node.body))
    return f"| `{name}({arguments})` | {' '.join(docstring(node).split())} |"


def api_page() -> str:
    """The page, as Markdown."""
    names = public_names()
    lines = [
        "# The Python API",
        "",
        "Every public name of the package `loosepin`, from its sources. [The Python package](python.md) shows how they go together.",
        "",
        docstring(parsed("__init__")),
        "",
    ]
    for module in sorted(names, key=lambda module: (ORDER.index(module) if module in ORDER else len(ORDER), module)):
        tree = parsed(module)
        definitions = {node.name: node for node in tree.body if isinstance(node, (ast.ClassDef, ast.FunctionDef))}
        text = docstring(tree)
        heading, _, rest = text.partition("\n")
        lines += [f"## {HEADINGS.get(module, heading.rstrip('.'))}", ""]
        if module not in HEADINGS and rest.strip():
            lines += [rest.strip(), ""]
        if module == "_inputs":
            lines += ["| | |", "|---|---|"]
            lines += [table_row(name, definition) for name in names[module] if isinstance(definition := definitions[name], ast.ClassDef)]
            lines.append("")
            continue
        for name in names[module]:
            node = definitions[name]
            if isinstance(node, ast.ClassDef):
                lines += described(node)
            else:
                lines += [f"### {name}", "", "```python", signature(node, "", is_method=False), "```", "", docstring(node), ""]
    return "\n".join(lines).rstrip() + "\n"


if __name__ == "__main__":
    print(api_page(), end="")
