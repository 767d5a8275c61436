"""docs/python-api.md says what the package has: it is made of its signatures, its stubs and its documentation.

``MINDEG_BLESS=1`` writes the page anew.
"""

import ast
import inspect
import os
import re
from pathlib import Path

import mindeg
from mindeg import batch

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs" / "python-api.md"
STUBS = ast.parse((Path(mindeg.__file__).parent / "_mindeg.pyi").read_text(encoding="utf-8"))
WIDTH = 100

FUNCTIONS = {
    "Domains": ["rectangle", "polygon"],
    "Meshes": ["mesh", "read", "improve", "remesh", "fill", "bridge", "stitch"],
    "Questions": ["inspect", "verify"],
    "Loops in space": ["fill_loop", "bridge_loops"],
    "Long work": ["progress"],
}
CLASSES = ["Domain", "Mesh", "Degree", "TradeOffPoint", "Suggestion"]
CONSTANTS = {
    "GOALS": "The goals of a mesh of boundary points: for each a dict with its `key`, its `value` and its `help`.",
    "PRESETS": "The programs whose rules `inspect` and `verify` check, and these rules, by name.",
    "__version__": "The version.",
}


def plain(text):
    """Names of the stubs as a reader imports them."""
    return re.sub(r"\b(npt\.|np\.|_mindeg\.|os\.|typing\.)", "", text).replace("_Domain", "Domain").replace("PathLike[str]", "PathLike")


def signature(name, arguments, gives):
    """A signature on one line, or with a line for each argument."""
    line = f"{name}({', '.join(arguments)}){gives}"
    if len(line) <= WIDTH:
        return line
    return f"{name}(\n" + "".join(f"    {argument},\n" for argument in arguments) + f"){gives}"


def of_stub(node, name):
    """The signature of a function of the stubs."""
    given, arguments = node.args, []
    positional = [*given.posonlyargs, *given.args]
    defaults = [None] * (len(positional) - len(given.defaults)) + given.defaults
    for argument, default in [*zip(positional, defaults), ("*", None), *zip(given.kwonlyargs, given.kw_defaults)]:
        if argument == "*":
            arguments += ["*"] if given.kwonlyargs else []
        elif argument.arg not in ("self", "cls"):
            text = ast.unparse(argument) + ("" if default is None else f" = {ast.unparse(default)}")
            arguments.append(plain(text))
    return signature(name, arguments, f" -> {plain(ast.unparse(node.returns))}" if node.returns else "")


def of_python(function, name):
    """The signature of a function that is written in Python."""
    found = inspect.signature(function)
    arguments, is_keyword = [], False
    for parameter in found.parameters.values():
        if parameter.name in ("self", "cls"):
            continue
        if parameter.kind is parameter.KEYWORD_ONLY and not is_keyword:
            is_keyword = True
            arguments.append("*")
        arguments.append(plain(str(parameter)))
    gives = found.return_annotation
    return signature(name, arguments, "" if gives is found.empty else f" -> {plain(str(gives) if isinstance(gives, str) else repr(gives))}")


def stub(name, among=STUBS.body):
    return next((node for node in among if getattr(node, "name", None) == name), None)


def documented(thing, what):
    text = inspect.cleandoc(thing.__doc__ or "")
    assert text, f"{what} has no documentation"
    text = re.sub(r"``([^`]+)``", r"`\1`", text)
    # Examples as blocks of code.
    return re.sub(r"(?m)^((?:>>>|\.\.\. ).*(?:\n(?!\n).*)*)", r"```python\n\1\n```", text)


def function(name, of=mindeg, qualified="mindeg"):
    found = getattr(of, name)
    node = stub(name)
    text = of_stub(node, name) if node is not None and of is mindeg else of_python(found, name)
    return f"### `{qualified}.{name}`\n\n```python\n{text}\n```\n\n{documented(found, name)}\n"


def members(kind):
    """Properties and methods of a class with their signatures, in the order of the stubs."""
    name = kind.__name__
    nodes = [*(stub(name) or stub(f"_{name}")).body]
    own = [] if stub(name) else [member for member in vars(kind) if not member.startswith("_")]
    nodes = [node for node in nodes if isinstance(node, ast.FunctionDef) and not node.name.startswith("_") and node.name not in own]
    lines = []
    for node in nodes:
        doc = documented(getattr(kind, node.name), f"{name}.{node.name}")
        if any(getattr(mark, "id", "") == "property" for mark in node.decorator_list):
            lines.append(f"#### `{node.name}: {plain(ast.unparse(node.returns))}`\n\n{doc}\n")
        else:
            lines.append(f"#### `{node.name}`\n\n```python\n{of_stub(node, node.name)}\n```\n\n{doc}\n")
    for member in own:
        found = getattr(kind, member)
        lines.append(f"#### `{member}`\n\n```python\n{of_python(found, member)}\n```\n\n{documented(found, f'{name}.{member}')}\n")
    return lines


def of_class(name):
    kind = getattr(mindeg, name)
    lines = [f"### `mindeg.{name}`\n"]
    if name == "Domain":
        lines.append(f"```python\n{of_python(kind.__new__, name)}\n```\n")
    elif (new := stub("__new__", stub(name).body)) is not None:
        lines.append(f"```python\n{of_stub(new, name)}\n```\n")
    return [*lines, documented(kind, name) + "\n", *members(kind)]


def page():
    lines = [
        "# Python: every name\n",
        "Made of the package's signatures, stubs and documentation by `python/tests/test_api_page.py`; [python.md](python.md) has recipes.\n",
    ]
    for title, names in FUNCTIONS.items():
        lines += [f"## {title}\n", *(function(name) for name in names)]
    lines.append("## Classes\n")
    for name in CLASSES:
        lines += of_class(name)
    lines += ["## Constants\n", *(f"- `mindeg.{name}`: {text}" for name, text in CONSTANTS.items()), ""]
    lines += ["## Batches\n", function("mesh_files", batch, "mindeg.batch")]
    return "\n".join(lines)


def test_the_page_has_every_name_as_it_is():
    named = {*CLASSES, *CONSTANTS, *(name for names in FUNCTIONS.values() for name in names)}
    assert named == set(mindeg.__all__)
    made = page()
    if os.environ.get("MINDEG_BLESS"):
        PAGE.write_text(made, encoding="utf-8")
    assert PAGE.read_text(encoding="utf-8") == made, "run it with MINDEG_BLESS=1, and read the difference"


def test_signatures_at_run_time_are_those_of_the_stubs():
    """What help() shows of functions in Rust, beside the stubs of which the page is made."""
    for node in STUBS.body:
        if isinstance(node, ast.FunctionDef) and not node.name.startswith("_"):
            shown = list(inspect.signature(getattr(mindeg, node.name)).parameters)
            given = node.args
            assert shown == [one.arg for one in [*given.args, *given.kwonlyargs]], node.name


def test_help_shows_options_and_not_their_machinery():
    for thing in (mindeg.mesh, mindeg.Domain, mindeg.Domain.mesh, mindeg.improve, mindeg.polygon):
        text = str(inspect.signature(thing))
        assert "Unpack" not in text and "'" not in text.replace("['", "").replace("']", "").replace("', '", ""), text
        assert "options" not in inspect.signature(thing).parameters
    assert "growth: float | None = None" in str(inspect.signature(mindeg.Domain.mesh))
