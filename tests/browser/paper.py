"""What stands on which sheet of a printed page, from the structure that Chromium writes into a PDF: standard library only."""

import re

OBJECT = re.compile(rb"(\d+) 0 obj\n(.*?)\nendobj", re.DOTALL)
SHEET = re.compile(rb"/Type\s*/Page\b")
HEADS = {b"H1", b"H2", b"H3"}


class Paper:
    """The sheets of a PDF, and its elements in their order."""

    def __init__(self, data):
        self.elements, self.sheets = {}, []
        for number, body in OBJECT.findall(data):
            if b"/StructElem" in body:
                self.elements[int(number)] = _element(body)
            elif SHEET.search(body):
                self.sheets.append(int(number))
        if not self.elements or not self.sheets:
            raise ValueError("the PDF has no structure that can be read")
        self.sheets.sort()

    def sheets_of(self, number):
        """The sheets on which something of an element is printed."""
        element = self.elements.get(number)
        if element is None:
            return set()
        own = {self.sheets.index(sheet) + 1 for sheet in element["printed_on"]}
        return own.union(*(self.sheets_of(child) for child in element["children"]))

    def of_kind(self, kind):
        return [number for number, element in self.elements.items() if element["kind"] == kind]

    def torn_rows(self):
        """Rows of tables that begin on one sheet and end on another. A row of heads alone is printed again on every sheet."""
        rows = [row for row in self.of_kind(b"TR") if any(self.elements[cell]["kind"] == b"TD" for cell in self.elements[row]["children"])]
        return [sorted(sheets) for sheets in map(self.sheets_of, rows) if len(sheets) > 1]

    def lonely_heads(self):
        """Sheets at whose foot stands a head whose text begins on the next one."""
        found = []
        for element in self.elements.values():
            children = [child for child in element["children"] if self.sheets_of(child)]
            for head, text in zip(children, children[1:]):
                if self.elements[head]["kind"] in HEADS and max(self.sheets_of(head)) < min(self.sheets_of(text)):
                    found.append(max(self.sheets_of(head)))
        return found


def _element(body):
    kind = re.search(rb"/S /(\w+)", body).group(1)
    sheet = re.search(rb"/Pg (\d+) 0 R", re.sub(rb"/K.*", b"", body, flags=re.DOTALL))
    kids = re.search(rb"/K (\[.*?\]|<<.*?>>|\d+ 0 R|\d+)", body, re.DOTALL)
    text = kids.group(1) if kids else b""
    # A mark names its sheet, or stands on that of its element.
    marks = re.findall(rb"<<.*?>>", text, re.DOTALL)
    named = [re.search(rb"/Pg (\d+) 0 R", mark) for mark in marks]
    printed_on = {int(name.group(1)) for name in named if name}
    rest = re.sub(rb"<<.*?>>", b"", text, flags=re.DOTALL)
    children = [int(number) for number in re.findall(rb"(\d+) 0 R", rest)]
    has_own = None in named or re.search(rb"\d", re.sub(rb"\d+ 0 R", b"", rest))
    if sheet and has_own:
        printed_on.add(int(sheet.group(1)))
    return {"kind": kind, "children": children, "printed_on": printed_on}
