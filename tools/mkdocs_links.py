"""A hook of MkDocs: links that leave docs/ become the name of the file.

Pages link to sources and to pages of cases by relative paths, which a browser
of the repository follows. The site does not hold those files.
"""
import posixpath
import re

LINK = re.compile(r"(?<!!)\[([^\]]+)\]\(((?:\.\./)+[^)\s#]+)(#[^)\s]*)?\)")


def without_outside_links(markdown, page):
    """The text of the page with the path `page`, relative to docs/."""
    def shown(link):
        path = posixpath.normpath(posixpath.join("docs", posixpath.dirname(page), link[2]))
        if path.startswith("docs/"):
            return link[0]
        return f"{link[1]} (`{path}`)"
    return LINK.sub(shown, markdown)


def on_page_markdown(markdown, page, **_):
    return without_outside_links(markdown, page.file.src_uri)


assert without_outside_links("[a](../b.md#c)", "d/e.md") == "[a](../b.md#c)"
assert without_outside_links("[a](../../b.cpp)", "d/e.md") == "a (`b.cpp`)"
