"""A hook of MkDocs: what a browser of the repository shows, and MkDocs does not.

Links that leave docs/, to sources and to pages of cases, become the name of the
file, because the site does not hold it. In formulas, <h> is no HTML and the
asterisk of E* no emphasis. A notebook is a page: its texts, its code, and what it
printed and drew when it was last stored, which a test compares with a new run.
"""
import base64
import posixpath
import re

from mkdocs.structure.files import File
from nbconvert import MarkdownExporter

CODE = re.compile(r"(?ms)(^ *```.*?^ *```$|^(?: {4}[^\n]*\n?)+|`[^`]+`)")
STAR = re.compile(r"(?<![A-Za-z*])([A-Za-z])\*(?!\*)")
LINK = re.compile(r"(?<!!)\[([^\]]+)\]\(((?:\.\./)+[^)\s#]+)(#[^)\s]*)?\)")


def without_outside_links(markdown, page):
    """The text of the page with the path `page`, relative to docs/."""
    def shown(link):
        path = posixpath.normpath(posixpath.join("docs", posixpath.dirname(page), link[2]))
        if path.startswith("docs/"):
            return link[0]
        return f"`{path}`" if path.endswith(link[1]) else f"{link[1]} (`{path}`)"
    return LINK.sub(shown, markdown)


def with_plain_formulas(markdown):
    parts = CODE.split(markdown)
    for i in range(0, len(parts), 2): # the others are code
        parts[i] = STAR.sub(r"\1\*", parts[i].replace("<", "&lt;"))
    return "".join(parts)


class Notebook(File):
    def is_documentation_page(self):
        return True


def on_files(files, config):
    for file in list(files):
        if file.src_uri.endswith(".ipynb"):
            files.remove(file)
            files.append(Notebook(file.src_uri, config["docs_dir"], config["site_dir"],
                                  config["use_directory_urls"]))
    return files


def on_page_read_source(page, **_):
    if not isinstance(page.file, Notebook):
        return None
    text, resources = MarkdownExporter().from_filename(page.file.abs_src_path)
    for name, picture in resources["outputs"].items():
        text = text.replace(f"({name})", f"(data:image/png;base64,{base64.b64encode(picture).decode()})")
    return text


def on_page_markdown(markdown, page, **_):
    return with_plain_formulas(without_outside_links(markdown, page.file.src_uri))


assert without_outside_links("[a](../b.md#c)", "d/e.md") == "[a](../b.md#c)"
assert without_outside_links("[a](../../b.cpp)", "d/e.md") == "a (`b.cpp`)"
assert without_outside_links("[c.cpp](../../b/c.cpp)", "d/e.md") == "`b/c.cpp`"
assert with_plain_formulas("<h> of E* or *our* `E*`") == "&lt;h> of E\\* or *our* `E*`"
assert with_plain_formulas("a\n\n    E* <h>\n\nE* of E*\n") == "a\n\n    E* <h>\n\nE\\* of E\\*\n"
