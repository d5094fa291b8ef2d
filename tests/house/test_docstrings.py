"""Docstrings as a reference needs them: shapes of every array that is returned, kept or taken by what is public,
numbers that it takes in words, fields documented in one way.

Read from the sources, without importing them.
"""

import ast
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
PACKAGES = ("geometry", "acoustic_fem", "localize", "studies")

ARRAYS = frozenset({"NDArray", "ndarray", "DataArray", "Tensor", "Array", "ComplexArray", "NumpyOrTorch"})
# A length: 3, 2 n, n_freq, k + 1, ..., *shape, a constant's name, or one of the named dimensions of labelled arrays and
# of numbers that a caller gives.
_NAMED = (
    "point|microphone|microphone_2|axis|frequency|sample|channel|count|modes|points|microphones|channels|words|window|rank|top"
    "|[A-Z]{2}[A-Z_]*"
)
_ONE = rf"(?:\d+ )?(?:[a-vA-V]|n_\w+|{_NAMED})|\d+|\.\.\.|\*\w+"
_LENGTH = rf"(?:{_ONE})(?: [-+*/] (?:{_ONE}))*"
_SHAPE = re.compile(
    rf"\({_LENGTH},(?: {_LENGTH},)*(?: {_LENGTH})?\)|[Ss]calar|[Ss]ame shape as|[Ss]hape of|[Bb]roadcast|any shape"
)


def _sources(package: str) -> list[tuple[str, ast.Module]]:
    return [
        (path.relative_to(ROOT).as_posix(), ast.parse(path.read_text(encoding="utf-8")))
        for path in sorted((ROOT / package).rglob("*.py"))
    ]


def _aliases(modules: list[tuple[str, ast.Module]]) -> frozenset[str]:
    """Names that stand for an array itself, such as ``Complex = NDArray[np.complex128]``."""
    found = set()
    for _, module in modules:
        for node in module.body:
            if isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name):
                name, value = node.targets[0].id, node.value
            elif isinstance(node, ast.AnnAssign) and isinstance(node.target, ast.Name) and node.value is not None:
                name, value = node.target.id, node.value
            else:
                continue
            if isinstance(value, ast.Subscript) and ast.unparse(value.value) == "NDArray":
                found.add(name)
    return frozenset(found)


def _is_array(annotation: ast.expr | None, arrays: frozenset[str]) -> bool:
    if annotation is None or (isinstance(annotation, ast.Subscript) and ast.unparse(annotation.value) == "Callable"):
        return False
    return any(
        (isinstance(node, ast.Name) and node.id in arrays) or (isinstance(node, ast.Attribute) and node.attr in arrays)
        for node in ast.walk(annotation)
    )


def _holds_fields(node: ast.ClassDef) -> bool:
    decorators = [ast.unparse(decorator) for decorator in node.decorator_list]
    return any(text.startswith("dataclass") for text in decorators) or any(
        ast.unparse(base) == "NamedTuple" for base in node.bases
    )


def _documented(body: list[ast.stmt], arrays: frozenset[str], prefix: str = "") -> Iterator[tuple[str, int, str]]:
    """Name, line and docstring of everything public that returns or keeps an array."""
    for node in body:
        if isinstance(node, ast.FunctionDef) and not node.name.startswith("_") and _is_array(node.returns, arrays):
            yield prefix + node.name, node.lineno, ast.get_docstring(node) or ""
        elif isinstance(node, ast.ClassDef) and not node.name.startswith("_"):
            inner = f"{prefix}{node.name}."
            yield from _documented(node.body, arrays, inner)
            if _holds_fields(node):
                yield from _fields(node.body, arrays, inner)


def _fields(body: list[ast.stmt], arrays: frozenset[str], prefix: str) -> Iterator[tuple[str, int, str]]:
    for node, after in zip(body, [*body[1:], None], strict=True):
        if not (isinstance(node, ast.AnnAssign) and isinstance(node.target, ast.Name)):
            continue
        if not node.target.id.startswith("_") and _is_array(node.annotation, arrays):
            text = after.value.value if isinstance(after, ast.Expr) and isinstance(after.value, ast.Constant) else ""
            yield prefix + node.target.id, node.lineno, str(text)


def without_shape(name: str, module: ast.Module, arrays: frozenset[str]) -> list[str]:
    """What of a module returns or keeps an array and does not say of which shape."""
    return [
        f"{name}:{line} {what}"
        for what, line, text in _documented(module.body, arrays)
        if not _SHAPE.search(" ".join(text.split()))
    ]


def _public(package: str) -> frozenset[str]:
    """Names that the faces of a package hand on."""
    return frozenset(
        alias.asname or alias.name
        for stub in (ROOT / package).rglob("__init__.pyi")
        for node in ast.parse(stub.read_text(encoding="utf-8")).body
        if isinstance(node, ast.ImportFrom)
        for alias in node.names
    )


def _taking(module: ast.Module, public: frozenset[str]) -> Iterator[tuple[str, ast.FunctionDef, str]]:
    """Name, definition and docstring of public functions, of methods of public classes, and of their makers."""
    for node in module.body:
        if not isinstance(node, (ast.FunctionDef, ast.ClassDef)) or node.name not in public:
            continue
        words = ast.get_docstring(node) or ""
        if isinstance(node, ast.FunctionDef):
            yield node.name, node, words
            continue
        for each in node.body:
            if isinstance(each, ast.FunctionDef) and (each.name == "__init__" or not each.name.startswith("_")):
                own = ast.get_docstring(each) or ""
                yield f"{node.name}.{each.name}", each, f"{words}\n\n{own}" if each.name == "__init__" else own


def _entries(words: str) -> dict[str, str]:
    """Argument -> what its section says of it."""
    found: dict[str, str] = {}
    for section in re.findall(r"^Args:\n((?:[ \t]+.*\n?|\n)*)", words, re.MULTILINE):
        for name, text in re.findall(r"^ {4}(\w+):((?:.*\n?)(?: {5,}.*\n?)*)", section, re.MULTILINE):
            found[name] = " ".join(text.split())
    return found


def _is_number(annotation: ast.expr) -> bool:
    return any(isinstance(node, ast.Name) and node.id in ("float", "complex") for node in ast.walk(annotation))


def not_told(name: str, module: ast.Module, arrays: frozenset[str], public: frozenset[str]) -> list[str]:
    """Numbers and arrays that something public takes and does not speak of; arrays without a shape.

    An argument is told of in ``Args``, or in running text by a word that begins as its name does; the shape of an array
    in its own entry, or in that text.
    """
    arrays = arrays - {node.name for node in module.body if isinstance(node, ast.ClassDef)}  # a class of that name
    found = []
    for what, node, words in _taking(module, public):
        entries = _entries(words)
        for each in (*node.args.posonlyargs, *node.args.args, *node.args.kwonlyargs):
            if each.annotation is None or "Callable" in ast.unparse(each.annotation):
                continue
            is_array = _is_array(each.annotation, arrays | {"ArrayLike"})
            if not is_array and not _is_number(each.annotation):
                continue
            word = rf"\b{re.escape(each.arg.split('_')[0])}"
            text = entries.get(each.arg, words if re.search(word, words, re.IGNORECASE) else "")
            if not text:
                found.append(f"{name}:{node.lineno} {what} {each.arg}: not told of")
            elif is_array and not _SHAPE.search(" ".join(text.split())):
                found.append(f"{name}:{node.lineno} {what} {each.arg}: no shape")
    return found


def with_section(name: str, module: ast.Module) -> list[str]:
    """Classes that document their fields in a section instead of under each field."""
    return [
        f"{name}:{node.lineno} {node.name}"
        for node in ast.walk(module)
        if isinstance(node, ast.ClassDef) and "Attributes:" in (ast.get_docstring(node) or "").split()
    ]


@pytest.mark.parametrize("package", PACKAGES)
def test_every_array_returned_or_kept_has_its_shape_in_its_docstring(package: str) -> None:
    modules = _sources(package)
    arrays = ARRAYS | _aliases(modules)
    assert [line for name, module in modules for line in without_shape(name, module, arrays)] == []


@pytest.mark.parametrize("package", PACKAGES)
def test_every_number_and_array_that_is_taken_is_told_of_and_arrays_have_a_shape(package: str) -> None:
    # Verbs of the command line have names of public calls and say what they take in --help.
    modules = [(name, module) for name, module in _sources(package) if not name.startswith("studies/cli/")]
    public = _public(package)
    arrays = ARRAYS | _aliases(modules)
    assert [line for name, module in modules for line in not_told(name, module, arrays, public)] == []


@pytest.mark.parametrize("package", PACKAGES)
def test_fields_are_documented_under_their_names(package: str) -> None:
    assert [line for name, module in _sources(package) for line in with_section(name, module)] == []


_PLANTED = '''
Array = NDArray[np.float64]

@dataclass(frozen=True)
class Result:
    """Kept values.

    Attributes:
        kept: (n,) values.
    """

    kept: Array
    told: Array
    """(n, 3) float64, mm."""

    @property
    def frequency(self) -> xr.DataArray:
        """The grid (x, y, z), Hz (Welch 1967)."""

def scaled(values: Array) -> dict[str, NDArray[np.float64]]:
    """Values by name (largest, smallest)."""

def shaped(values: Array) -> tuple[Array, float]:
    """Values (..., 2 n), by the formula (largest, one)."""

def chooser() -> Callable[[Array], Array]:
    """No array."""

def _hidden() -> Array:
    """Not public."""

def mean(values: Array, over: float, weight: Array, power: float, count: int) -> float:
    """Mean of values, to a power.

    Args:
        over: s.
        weight: of each.
    """

def private(values: Array) -> float:
    """On no face."""
'''


def test_a_planted_violation_of_each_kind_is_found() -> None:
    module = ast.parse(_PLANTED)
    found = without_shape("planted.py", module, ARRAYS | _aliases([("planted.py", module)]))
    assert [line.split()[1] for line in found] == ["Result.frequency", "Result.kept", "scaled"]
    assert [line.split()[1] for line in with_section("planted.py", module)] == ["Result"]
    taking = not_told("planted.py", module, ARRAYS | _aliases([("planted.py", module)]), frozenset({"mean", "shaped"}))
    assert [line.partition(" ")[2] for line in taking] == ["mean values: no shape", "mean weight: no shape"]
    silent = ast.parse(_PLANTED.replace(", to a power", ""))
    assert "mean power: not told of" in " ".join(not_told("planted.py", silent, ARRAYS, frozenset({"mean"})))
