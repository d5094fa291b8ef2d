"""The manual as a site: ``make docs`` builds it from these pages and the faces of the rooms, without a network.

Sphinx with MyST reads the same Markdown that is read on the forge, links every name of ours to its entry, and its
search runs from a folder on disk, where a page may not fetch a second file. Equations become MathML when the site is
built, and the theme takes the fonts of the reader's system: a page of the site asks no other host for anything.
"""

from __future__ import annotations

import sys
from importlib.metadata import version as version_of
from pathlib import Path

HERE = Path(__file__).parent
sys.path[:0] = [str(HERE.parent), str(HERE), str(HERE / "site")]

project = "acoustic-fem"
author = "acoustic-fem developers"
copyright = author
release = version = version_of("acoustic-fem")

extensions = [
    "sphinx.ext.autodoc",
    "sphinx.ext.napoleon",
    "myst_nb",
    "sphinx_copybutton",
    "accessible",
    "cards",
    "equations",
    "fields",
    "models",
    "names",
    "reference",
    "search_words",
]
exclude_patterns = ["site", "build", "examples", "notebooks/*.py"]
templates_path: list[str] = []
language = "en"
# Quotes and dashes stay as they are typed: options and commands are copied from the pages.
smartquotes = False

# Notebooks are shown as docs/make_notebooks.py left them; the tests execute them.
nb_execution_mode = "off"
myst_enable_extensions = ["dollarmath", "deflist", "attrs_inline"]
myst_heading_anchors = 4
copybutton_exclude = ".linenos, .gp, .go"

autodoc_typehints = "signature"
autodoc_typehints_format = "short"
autodoc_member_order = "bysource"
autodoc_preserve_defaults = True
autodoc_default_options = {"members": True}
python_use_unqualified_type_names = True
python_maximum_signature_line_length = 100
napoleon_google_docstring = True
napoleon_numpy_docstring = False
napoleon_use_rtype = False
default_role = "code"
toc_object_entries_show_parents = "hide"

html_theme = "furo"
html_title = f"acoustic-fem {release}"
html_static_path = ["site/static"]
html_css_files = ["manual.css"]
html_js_files = [("gallery.js", {"defer": "defer"})]
html_copy_source = False
html_show_sphinx = False
html_math_renderer = "mathml"
html_theme_options = {
    "light_css_variables": {"color-brand-primary": "#0b5cad", "color-brand-content": "#0b5cad"},
    "dark_css_variables": {"color-brand-primary": "#7db8f0", "color-brand-content": "#7db8f0"},
}
pygments_style = "a11y-high-contrast-light"
pygments_dark_style = "a11y-high-contrast-dark"
