#!/usr/bin/env python3
"""Checks that a report is one valid page that loads nothing from outside: check_page.py FILE [HEADING]..."""

import html.parser
import json
import sys

VOID = {"meta", "link", "img", "br"}


class Page(html.parser.HTMLParser):
    def __init__(self):
        super().__init__()
        self.open = []
        self.ids = []
        self.links = []
        self.texts = {}
        self.problems = []

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        for name in ("src", "href", "data", "action", "poster", "srcset"):
            value = attributes.get(name, "#")
            if not value.startswith(("#", "data:")):
                self.problems.append(f"{tag} needs {value}")
        if value := attributes.get("href", "").removeprefix("#"):
            self.links.append(value)
        if tag == "img" and not attributes.get("alt"):
            self.problems.append("an image without a text")
        if "id" in attributes:
            self.ids.append(attributes["id"])
        if tag not in VOID:
            self.open.append((tag, attributes.get("id", "")))

    def handle_endtag(self, tag):
        if not self.open or self.open[-1][0] != tag:
            self.problems.append(f"</{tag}> at {self.getpos()} closes {self.open[-1:]}")
        else:
            self.open.pop()

    def handle_data(self, data):
        if self.open:
            self.texts.setdefault(self.open[-1], []).append(data)


def explorer_problems(text):
    data = json.loads(text)
    rows = len(data["x"]["values"])
    for line in data["lines"] + [{"values": values} for values in data["place"].values()]:
        if len(line["values"]) != rows:
            yield f"the explorer has {rows} rows, but a line of {len(line['values'])}"
    if not data["map"]["image"].startswith("data:image/png;base64,"):
        yield "the explorer has no map"


def problems_of(text, headings):
    page = Page()
    page.feed(text)
    page.close()
    yield from page.problems
    if page.open:
        yield f"never closed: {page.open}"
    if len(set(page.ids)) != len(page.ids):
        yield "an id twice"
    for link in page.links:
        if not link.startswith("data:") and link not in page.ids:
            yield f"a link to {link}, which is not there"
    for word in ('<html lang="en">', "<title>", "viewport"):
        if word not in text:
            yield f"no {word}"
    found = [words for (tag, _), texts in page.texts.items() if tag == "h2" for words in texts]
    for heading in headings:
        if heading not in found:
            yield f"no heading '{heading}' among {found}"
    if "explorer-data" in page.ids:
        yield from explorer_problems("".join(page.texts[("script", "explorer-data")]))
    if "@import" in text or "url(" in text:
        yield "a style that loads something"


if __name__ == "__main__":
    with open(sys.argv[1], encoding="utf-8") as file:
        found = list(problems_of(file.read(), sys.argv[2:]))
    print("\n".join(f"{sys.argv[1]}: {problem}" for problem in found) or f"{sys.argv[1]}: sound")
    sys.exit(1 if found else 0)
