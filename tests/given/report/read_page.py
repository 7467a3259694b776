"""read_page.py FILE: what a page says and is, as JSON, by Python's own HTML parser.

problems: what must not be in any page of ours; text: what is to be read, blanks run together; rows: the cells of the table
with id "class"; sheets: the text of each <article> by its id; pages: the links to files of the folder feedback; policy: the Content-Security-Policy; counts of elements.
"""
import base64
import hashlib
import json
import re
import sys
from collections import Counter
from html.parser import HTMLParser

VOID = {"meta", "input", "br", "hr", "img", "link", "col"}
# Written so that no browser takes anything in it for the beginning of something else.
PAGE = re.compile(r"feedback/[A-Za-z0-9._~%-]+\.html")
REFERRING = {"src", "srcset", "action", "formaction", "data", "poster", "background", "ping", "xlink:href"}


class Page(HTMLParser):
    def __init__(self):
        super().__init__(convert_charrefs=True)
        self.open, self.problems, self.ids, self.links = [], [], Counter(), []
        self.texts, self.rows, self.sheets, self.pages, self.counts = [], [], {}, [], Counter()
        self.policy, self.blocks, self.in_class, self.sheet = None, {"style": [], "script": []}, False, None

    def handle_starttag(self, tag, attributes):
        self.begin(tag, attributes)
        if tag in VOID:
            self.open.pop()

    def handle_startendtag(self, tag, attributes):
        self.begin(tag, attributes)
        self.open.pop()

    def begin(self, tag, attributes):
        self.open.append(tag)
        self.counts[tag] += 1
        for name, value in attributes:
            if tag == "a" and name == "href" and PAGE.fullmatch(value):
                self.pages.append(value)
                continue
            if name.startswith("on") or name == "style":
                self.problems.append(f"<{tag} {name}>: a strict policy forbids it")
            if name in REFERRING or (name == "href" and not value.startswith("#")):
                self.problems.append(f"<{tag} {name}={value}>: refers to elsewhere")
            if name == "id":
                self.ids[value] += 1
            if name == "href":
                self.links.append(value[1:])
            if name in ("aria-labelledby", "aria-describedby"):
                self.links.extend(value.split())
        named = dict(attributes)
        if tag == "meta" and named.get("http-equiv") == "Content-Security-Policy":
            self.policy = named["content"]
        if tag == "table":
            self.in_class = named.get("id") == "class"
        if tag == "tr" and self.in_class:
            self.rows.append([])
        if tag in ("td", "th") and self.in_class:
            self.rows[-1].append("")
        if tag == "article":
            self.sheet = named["id"]
            self.sheets[self.sheet] = ""

    def handle_endtag(self, tag):
        if not self.open or self.open.pop() != tag:
            self.problems.append(f"</{tag}> in line {self.getpos()[0]} ends what is not open")
        if tag == "table":
            self.in_class = False
        if tag == "article":
            self.sheet = None

    def handle_data(self, data):
        if self.open and self.open[-1] in self.blocks:
            self.blocks[self.open[-1]].append(data)
            return
        self.texts.append(data)
        if self.in_class and self.rows and self.rows[-1]:
            self.rows[-1][-1] += data
        if self.sheet:
            self.sheets[self.sheet] += data

    def finish(self):
        self.problems += [f"<{tag}> is never ended" for tag in self.open]
        self.problems += [f"id {name} is there {n} times" for name, n in self.ids.items() if n > 1]
        self.problems += [f"nothing has the id {name}" for name in self.links if name and name not in self.ids]
        if not (self.policy or "").startswith("default-src 'none';"):
            self.problems.append(f"no strict policy: {self.policy}")
        for kind, blocks in self.blocks.items():
            for block in blocks:
                digest = base64.b64encode(hashlib.sha256(block.encode()).digest()).decode()
                if f"'sha256-{digest}'" not in (self.policy or ""):
                    self.problems.append(f"the policy does not know the <{kind}> {block[:40]!r}")


def plain(text):
    return " ".join(text.split())


page = Page()
page.feed(open(sys.argv[1], encoding="utf-8", errors="strict").read())
page.close()
page.finish()
json.dump(
    {
        "problems": page.problems,
        "text": plain("".join(page.texts)),
        "rows": [[plain(cell) for cell in row] for row in page.rows],
        "sheets": {name: plain(text) for name, text in page.sheets.items()},
        "pages": page.pages,
        "policy": page.policy,
        "counts": page.counts,
    },
    sys.stdout,
)
