"""Execute the notebooks and keep what they show: ``python docs/make_notebooks.py [NAME ...]``.

Each is a script of cells, docs/notebooks/NAME.py, and the notebook made from it, NAME.ipynb, which the site shows. The
tests run the scripts, and hold the cells of the notebooks against them.
"""

from __future__ import annotations

import sys
from pathlib import Path

import jupytext
import nbformat
from nbclient import NotebookClient

FOLDER = Path(__file__).parent / "notebooks"


def execute(script: Path) -> nbformat.NotebookNode:
    """The notebook of a script with what its cells print and draw, and nothing that differs from run to run."""
    notebook = jupytext.read(script)
    NotebookClient(notebook, timeout=300, kernel_name="python3", resources={"metadata": {"path": FOLDER}}).execute()
    for number, cell in enumerate(notebook.cells):
        cell.id = f"cell-{number}"
        cell.metadata = {}
        if cell.cell_type == "code":
            cell.execution_count = None
            cell.outputs = [each for each in cell.outputs if each.get("name") != "stderr"]
            for output in cell.outputs:
                output.pop("execution_count", None)
                output.get("data", {}).pop("text/plain", None) if "image/png" in output.get("data", {}) else None
    notebook.metadata = {"kernelspec": notebook.metadata["kernelspec"]}
    return notebook


def main(names: list[str]) -> None:
    """Execute all notebooks, or those named."""
    for script in sorted(FOLDER.glob("*.py")):
        if not names or script.stem in names:
            nbformat.write(execute(script), script.with_suffix(".ipynb"))
            print(script.with_suffix(".ipynb"), flush=True)


if __name__ == "__main__":
    main(sys.argv[1:])
