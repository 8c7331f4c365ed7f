"""The comments of headers in the words of Doxygen.

Headers here are written to be read as they are: the comment at the top says what the file is, `///` what a declaration is, and
neither has commands. So what Doxygen would take for a command, a tag or a link is escaped, but between backticks. Lines that
are indented further than the text are a list, or stand as they are, as paragraphs with columns do.
"""

import re

LIST_ITEM = re.compile(r"(\d+\.|[-*]) ")
COMMENT = re.compile(r"^ */// ?(?P<text>[^<].*|)$")
BESIDE = re.compile(r"(?P<before>.*///< )(?P<text>.*)$")
NAMESPACE = re.compile(r"^namespace ocelli(::\w+)* \{")
COLUMNS = re.compile(r"^\w[\w -]*\w {2,}\S|^ {6,}\S")
END_OF_NAMESPACE = re.compile(r"^\}  // namespace ocelli")


def escaped(text):
    parts = text.split("`")
    for outside in range(0, len(parts), 2):
        parts[outside] = re.sub(r"([\\@<>#&])", r"\\\1", parts[outside]).replace("*", "&lowast;")
    return "`".join(parts)


def paragraphs(lines):
    """Lists of lines, an empty line by itself."""
    together = []
    for line in lines + [""]:
        if line.strip():
            together.append(line)
            continue
        if together:
            yield together
        yield [""]
        together = []


def is_table(paragraph):
    """Whether columns are aligned by spaces, from its first line on."""
    if any(LIST_ITEM.match(line.lstrip()) for line in paragraph):
        return False
    return COLUMNS.search(paragraph[0]) is not None and sum(COLUMNS.search(line) is not None for line in paragraph) >= 2


def marked(lines):
    """The lines of a comment, without their slashes."""
    result = []
    for paragraph in paragraphs(lines):
        verbatim = in_list = False
        table = is_table(paragraph)
        for line in paragraph:
            text = line.lstrip()
            indented = len(line) - len(text) >= 2
            item = LIST_ITEM.match(text) is not None
            if verbatim and not indented and not table:
                verbatim = False
                result += ["~~~", ""]
            if not verbatim and (table or (indented and not in_list and not item)):
                verbatim = True
                result += ["", "~~~{.txt}"]
            if in_list and not indented and not item:
                result.append("")
            in_list = not verbatim and (item or (in_list and indented))
            result.append(line if verbatim else line[: len(line) - len(text)] + escaped(text))
        result += ["~~~"] * verbatim
    return result[:-1]


def comment(lines):
    return [f"/// {line}".rstrip() for line in marked(lines)]


def for_doxygen(text, group):
    """A header as Doxygen reads it: all that it declares is in the group."""
    lines = text.split("\n")
    result, block = [], []
    top = next((i for i, line in enumerate(lines) if not line.startswith("//")), len(lines))
    result += ["/// \\file", f"/// \\ingroup {group}", "///"] + comment([line[3:] for line in lines[:top]]) + [""]
    for line in lines[top:] + [""]:
        match = COMMENT.match(line)
        if match:
            block.append(match["text"])
            continue
        result += comment(block)
        block = []
        beside = BESIDE.match(line)
        result.append(beside["before"] + escaped(beside["text"]) if beside else line)
        if NAMESPACE.match(line):
            result.append(f"/** \\addtogroup {group}\n@{{ */")
        elif END_OF_NAMESPACE.match(line):
            result.insert(-1, "/** @} */")
    return "\n".join(result)
