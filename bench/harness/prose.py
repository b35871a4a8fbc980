# SPDX-License-Identifier: Apache-2.0
"""The prose of a page in lines of at most 120 columns; headings, tables and pictures stay as they are."""

import itertools
import textwrap

COLUMNS = 120


def wrapped(page):
    lines = []
    for prose, group in itertools.groupby(page.split("\n"), _is_prose):
        lines += [line for text in _paragraphs(group) for line in _fill(text)] if prose else group
    return "\n".join(lines)


def _is_prose(line):
    return bool(line.strip()) and not line.startswith(("|", "#", "!", "<"))


def _paragraphs(lines):
    """An item of a list is a paragraph of its own."""
    paragraph = []
    for line in lines:
        if line.startswith("- ") and paragraph:
            yield " ".join(paragraph)
            paragraph = []
        paragraph.append(line.strip())
    yield " ".join(paragraph)


def _fill(text):
    indent = "  " if text.startswith("- ") else ""
    return textwrap.wrap(text, COLUMNS, subsequent_indent=indent, break_long_words=False, break_on_hyphens=False)
