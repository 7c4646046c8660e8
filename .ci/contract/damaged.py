"""Requests that are nearly right: the examples of the contract with a few things wrong.

Schemas lead schemathesis to requests that are right or wrong in one place. Here are those that no schema describes: numbers at the ends
of their range together, names given twice, texts in other encodings, bodies cut or damaged, tables with a bad cell.
"""

import gzip
import json
from urllib.parse import quote

LARGEST = 4 << 20  # of a body: a refused one is read on for a while, not for ever

NUMBERS = ["0", "-0.0", "1", "-1", "0.5", "2", "1e308", "-1e308", "1.7976931348623157e308", "5e-324", "-5e-324", "2.3e-308", "1e-300"]
NUMBERS += ["1e300", "1e-16", "1e16", "9007199254740993", "18446744073709551616", "-9223372036854775809", "1e9", "1e-9", "1e5", "10001"]
NO_NUMBERS = ["1e999", "-1e999", "NaN", "Infinity", "01", "+1", ".5", "1.", "0x10", "1_000", "1e", "--1", "9" * 5000, "0." + "1" * 5000]
TEXTS = ['"\\ud800"', '"\\udc00\\ud800"', '"\\u0000"', '""', '" "', '"\u202e\u0085"', '"' + "x" * 20000 + '"', '"-0"', '"null"', '"\\x"']
OTHERS = ["null", "true", "false", "[]", "{}", "[[]]", "[null]", '{"": 0}', "[1, 2]", '["a", 1]']
CELLS = ["", "nan", "NaN", "inf", "-inf", "1e999", "1,5", "a", '"', '""', "#", "1;2", "\t", "0x1", "é", "\x00", "9" * 400, "1e-400", "-", "+1"]


class Pairs(list):
    """An object whose names may stand twice."""


class Raw(str):
    """A piece of JSON, right or wrong, as it is sent."""


def read(value):
    if isinstance(value, dict):
        return Pairs([name, read(of)] for name, of in value.items())
    return [read(of) for of in value] if isinstance(value, list) else value


def written(value):
    if isinstance(value, Pairs):
        return "{" + ",".join(f"{json.dumps(name)}:{written(of)}" for name, of in value) + "}"
    if isinstance(value, list):
        return "[" + ",".join(map(written, value)) + "]"
    return str(value) if isinstance(value, Raw) else json.dumps(value)


def places(value, name=""):
    """Where something can be changed: containers with an index, and the name of the field."""
    if isinstance(value, Pairs):
        for pair in value:
            yield pair, 1, pair[0]
            yield from places(pair[1], pair[0])
    elif isinstance(value, list):
        for index, of in enumerate(value):
            yield value, index, name
            yield from places(of, name)


def bounds(schema, name="", found=None):
    """The ends of the ranges in a schema, by the name of the field."""
    found = {} if found is None else found
    if isinstance(schema, dict):
        ends = [schema[end] for end in ("minimum", "maximum") if isinstance(schema.get(end), (int, float))]
        found.setdefault(name, []).extend(ends)
        for key, of in schema.items():
            for field, below in of.items() if key == "properties" else [(name, of)]:
                bounds(below, field, found)
    elif isinstance(schema, list):
        for of in schema:
            bounds(of, name, found)
    return found


def is_a_number(value):
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def change(tree, dice, ends):
    """Changes one place of a tree."""
    found = list(places(tree))
    if not found:
        return
    numbers = [place for place in found if is_a_number(place[0][place[1]])]
    around, index, name = dice.choice(numbers if numbers and dice.randrange(3) else found)
    old = around[index]
    is_number = is_a_number(old)
    kind = dice.randrange(20)
    if is_number and kind < 5:
        around[index] = Raw(dice.choice(NUMBERS))
    elif is_number and kind < 10 and ends.get(name):
        around[index] = dice.choice(ends[name])
    elif is_number and kind < 14:
        scaled = old * 10.0 ** dice.uniform(-30, 30) * dice.choice([1, 1, 1, -1])
        around[index] = dice.choice([scaled, old * (1 + 2.0**-52), old * (1 - 2.0**-52), old * dice.uniform(0, 2), int(scaled)])
    elif kind < 15:
        around[index] = Raw(dice.choice(NUMBERS + OTHERS + TEXTS))
    elif kind == 15:
        around[index] = Raw(dice.choice(NO_NUMBERS))
    elif kind == 16:
        depth = dice.choice([2, 20, 127, 128, 129, 3000])
        opening, closing = dice.choice([("[", "]"), ('{"a":', "}"), ('{"wheel":', "}")])
        around[index] = Raw(opening * depth + "1" + closing * depth)
    elif kind == 17 and isinstance(old, list) and not isinstance(old, Pairs) and old:
        around[index] = old * dice.choice([0, 2, 3, 100, 2000]) if len(written(old)) < 300 else old[:-1]
    elif kind == 18:
        other, at, _ = dice.choice(found)
        around[index] = Raw(written(other[at]))
    else:
        objects = [tree, *(container[at] for container, at, _ in found)]
        change_names(dice.choice([of for of in objects if isinstance(of, Pairs)] or [Pairs()]), dice)


def change_names(fields, dice):
    if not fields:
        fields.append(["a", 1])
        return
    pair = dice.choice(fields)
    match dice.randrange(5):
        case 0 | 1:
            fields.remove(pair)
        case 2:
            fields.insert(dice.randrange(len(fields) + 1), list(pair))
        case 3:
            pair[0] = dice.choice([pair[0] + "s", pair[0].upper(), "", "\u202e", "\ud800", "a/b~c", "x" * 5000, pair[0] + "\x00"])
        case 4:
            fields.extend([f"name{number}", number] for number in range(dice.choice([1, 30, 2000])))


def damaged(body, dice):
    """A body with some of its bytes wrong."""
    at = dice.randrange(len(body) + 1)
    match dice.randrange(7):
        case 0:
            return body[:at]
        case 1:
            return body[:at] + bytes(dice.randrange(256) for _ in range(dice.choice([1, 4]))) + body[at + 1 :]
        case 2:
            return body[:at] + dice.choice([b"\xff\xfe", b"\xed\xa0\x80", b"\xc0\xaf", b"\x00", b"\xef\xbb\xbf"]) + body[at:]
        case 3:
            return body.decode(errors="replace").encode(dice.choice(["utf-16", "utf-32", "utf-7", "utf-8-sig"]))
        case 4:
            return body + dice.choice([b"x", b"{}", b"\n", b" " * 10**6, body])
        case 5:
            return body[:at] + b" " * dice.choice([10**4, 2**20, 2**21]) + body[at:]
        case _:
            return b""


def text_of_cells(columns, media_type, dice):
    """Columns as a table or as an object a line, mostly with a cell that is wrong."""
    names = list(columns)
    rows = [list(map(json.dumps, row)) for row in zip(*columns.values())] * dice.choice([1, 1, 50])
    for _ in range(dice.randrange(3)):
        row = dice.choice(rows)
        row[dice.randrange(len(row))] = dice.choice(CELLS + NUMBERS)
    if media_type == "text/csv":
        between = dice.choice([",", ",", ";", "\t"])
        return dice.choice(["\n", "\r\n", "\r"]).join(between.join(row) for row in [names, *rows])
    return "\n".join("{" + ",".join(f'"{name}":{cell}' for name, cell in zip(names, row)) + "}" for row in rows)


def flat(fields, around=""):
    """The parameters that stand for an object in a query."""
    for name, value in fields:
        if isinstance(value, Pairs):
            yield from flat(value, f"{around}{name}.")
        else:
            yield around + name, value if isinstance(value, str) else written(value)


def in_a_query(fields):
    return "&".join(f"{quote(name, errors='replace')}={quote(value[:4000], errors='replace')}" for name, value in flat(fields))


class Sources:
    """The examples of a contract, from which requests are made, and wheels and soils that are spelled out."""

    def __init__(self, contract, measured):
        self.pairs = [{"wheel": of["wheel"], "soil": of["soil"]} for of in measured]
        self.ends = bounds(contract["components"])
        self.bodies = []
        self.queries = []
        for path, operations in contract["paths"].items():
            contents = operations.get("post", {}).get("requestBody", {}).get("content", {})
            if contents and "application/json" not in contents:
                continue  # rows of a table, which tests of the service damage
            content = contents.get("application/json", {})
            examples = [content["example"]] if "example" in content else []
            examples += [of["value"] for of in content.get("examples", {}).values()]
            assert examples or "post" not in operations, f"{path} has no example"
            self.bodies += [(path, example) for example in examples]
            if "{" in path:
                self.queries.append((path.split("{")[0], {}))
            elif "get" in operations:
                # What a body takes stands in a query as well.
                self.queries.append((path, examples[0] if examples else {}))

    def request(self, dice):
        """Method, path with query, headers, body."""
        if dice.randrange(5) == 0:
            path, example = dice.choice(self.queries)
            tree = read(example)
            for _ in range(dice.randrange(4)):
                change(tree, dice, self.ends)
            if path.endswith("/"):
                path += quote(dice.choice(["letter", "x" * 3000, "\x00", "..", "\u202e", "a/b"])) + dice.choice(["", "%ff", "%", "%2"])
            query = in_a_query(tree) + dice.choice(["", "", "&", "&=&=", "&%ff=%fe", "&a.b.c.d.e=1", "&format=csv", "&a=1" * 200])
            return "GET", f"{path}?{query}", {}, None
        path, example = dice.choice(self.bodies)
        if "soil" in example and dice.randrange(2):
            example = {**example, **{name: of for name, of in dice.choice(self.pairs).items() if name in example}}
        headers = {"Content-Type": "application/json"}
        tree = read(example)
        if path == "/v1/track" and dice.randrange(2):
            headers["Content-Type"] = dice.choice(["text/csv", "application/x-ndjson"])
            settings = Pairs(pair for pair in tree if pair[0] != "columns")
            if dice.randrange(3) == 0:
                change(settings, dice, self.ends)
            path += "?" + in_a_query(settings)
            body = text_of_cells(example["columns"], headers["Content-Type"], dice).encode(errors="replace")
        else:
            for _ in range(dice.choice([1, 1, 1, 2, 3, 6, 12])):
                change(tree, dice, self.ends)
            body = written(tree).encode(errors="surrogatepass")
        if dice.randrange(8) == 0:
            body = damaged(body, dice)
        match dice.randrange(40):
            case 0:
                headers["Content-Type"] = dice.choice(["", "text/plain", "application/json; charset=latin-1", "text/csv; charset=utf-16"])
            case 1:
                headers["Content-Encoding"] = dice.choice(["gzip", "deflate", "br", "identity"])
            case 2 | 3:
                body = gzip.compress(body)
                headers["Content-Encoding"] = "gzip"
                body = damaged(body, dice) if dice.randrange(2) else body
            case 4:
                headers["Accept"] = dice.choice(["text/csv", "*/*;q=0", "text/csv;q=1e999", ",;,", "application/x-ndjson"])
        return "POST", path, headers, body[:LARGEST]
