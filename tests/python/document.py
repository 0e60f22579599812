"""Runs the code of a document as a reader would, from top to bottom in an empty folder: document.py DOCUMENT

The code is that of the blocks fenced with `python`, one after the other in one interpreter. Where a block ends with lines
that begin with `#>`, these are what it prints; three dots stand for any text."""

import contextlib
import io
import os
import re
import sys
import tempfile

document = open(sys.argv[1], encoding="utf-8").read()
blocks = re.findall(r"^```python\n(.*?)^```", document, flags=re.M | re.S)
assert blocks, "the document has no code"
names: dict[str, object] = {"__name__": "__main__"}
with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    for block in blocks:
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            exec(compile(block, sys.argv[1], "exec"), names)
        said = "".join(line + "\n" for line in re.findall(r"^#> (.*)", block, flags=re.M))
        pattern = re.escape(said).replace(re.escape("..."), ".*")
        assert re.fullmatch(pattern, printed.getvalue()), f"{block}printed:\n{printed.getvalue()}"
    os.chdir("/")
print(f"{len(blocks)} blocks")
