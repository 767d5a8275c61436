"""The JSON Schemas of domains, models and reports, judged by a library that had no part in them.

    schemas.py MINDEG_BINARY FOLDER [DOMAIN.json ...]

The examples keep to the schemas, mindeg writes what keeps to them, and what a schema refuses mindeg refuses.
"""

import copy
import json
import subprocess
import sys
from pathlib import Path

from jsonschema import Draft202012Validator

from tally import Tally

ROOT = Path(__file__).resolve().parents[2]

# A domain with every key that exists.
FULL = {
    "name": "a",
    "rectangle": {"width": 9, "height": 9, "origin": [0, 0], "rotation": 360},
    "sides": [
        {"intervals": 3, "spacing": {"bump": {"ratio": 2}}, "name": "b", "kind": "open"},
        {"size": 1, "outside_degree": 1, "max_degree": 9},
        {"spacing": {"parameters": [0.5]}},
        {"intervals": 2, "outside_degree": [1, 2, 3], "spacing": {"first_length": 1}},
    ],
    "holes": [
        {"ring": [[4, 4], [5, 4], [4, 5]]},
        {"corners": [[6, 6]], "sides": [{"intervals": 9, "arc": {"center": [6, 6.5], "clockwise": True}}]},
        {
            "corners": [[2, 6], [3, 6]],
            "sides": [{"intervals": 3, "bezier": [[2, 7], [3, 7]]}, {"intervals": 3, "polyline": [[2.5, 5.5]]}],
        },
    ],
    "vertices": [{"vertex": 1, "max_degree": 9, "outside_degree": 1}],
    "interior": {
        "growth": 0.3,
        "size_inside": 2,
        "sizes": [[4, 6, 0.1]],
        "interior_degree": [5, 7],
        "boundary_degree": 6,
        "target_angle": 20,
        "prefer": "angle",
        "max_points": 1000,
    },
    "lines": [
        {"corners": [[4, 7], [5, 7], [5, 7.5]], "intervals": 2, "name": "c", "kind": "land", "sides": [{}, {"size": 1}]},
        {"points": [[1, 3], [2, 3], [2, 4]], "closed": True},
    ],
    "points": [{"at": [4.5, 7.5], "name": "d", "size": 1}],
    "regions": [{"at": [8, 7], "name": "e", "material": "f"}],
}


def plate(**keys):
    return {"rectangle": {"width": 4, "height": 3}, "size": 1, **keys}


def plate_with_side(**side):
    return plate(sides=[side, {}, {}, {}])


WRONG_DOMAINS = [
    [],
    {"rectangle": {"width": 4}},
    plate(hight=3),
    plate(size="1"),
    plate(size=-1),
    plate(size=0),
    plate(rectangle={"width": 0, "height": 3}),
    plate(rectangle={"width": 4, "height": -3}),
    {"ring": [[0, 0], [1, 0]]},
    {},
    {"size": 1},
    {"ring": [[0, 0], [1, 0], [0, 1]], "rectangle": {"width": 4, "height": 3}},
    {"ring": [[0, 0], [1, 0], [0, 1]], "polygon": {"corners": [[0, 0], [1, 0], [0, 1]]}},
    {"polygon": {"corners": [[0, 0], [1, 0]]}, "size": 1},
    plate(holes=[{"corners": [[1, 1], [2, 1]], "size": 1}]),
    plate(interior={"interior_degree": [7, 5]}),
    {"polygon": {"corners": []}, "size": 1},
    plate(holes=[{"ring": [[1, 1], [2, 1]]}]),
    plate(holes=[{"corners": [[1, 1], [2, 1], [2, 2]], "size": -1}]),
    plate(rectangle=[4, 3]),
    plate(vertices=[{"max_degree": 4}]),
    plate(holes=[{"corners": [[1, 1], [2]]}]),
    plate(interior={"growth": 0}),
    plate(interior={"target_angle": 60}),
    plate(interior={"boundary_degree": 3}),
    plate(interior={"sizes": [[1, 1]]}),
    plate(interior={"interior_degree": [5]}),
    plate(interior={"prefer": "speed"}),
    plate_with_side(intervals=2.9),
    plate_with_side(intervals=0),
    plate_with_side(spacing="even"),
    plate_with_side(spacing={"bump": 2}),
    plate_with_side(spacing={"bump": {"ratio": 2}, "beta": {"beta": 2}}),
    plate_with_side(kind="water"),
    plate_with_side(outside_degree=-1),
    plate_with_side(bezier=[[1, 1]]),
]
WRONG_MODELS = [
    {"corners": [[0, 0, 0]]},
    {"corners": [[0, 0]], "faces": [[0, 0, 0]]},
    {"corners": [[0, 0, 0]], "faces": [{"holes": []}]},
    {"corners": [[0, 0, 0]], "faces": [["a"]]},
    {"corners": [[0, 0, 0]], "faces": [], "edges": [{"corners": [0]}]},
    {"corners": [[0, 0, 0]], "faces": [], "materials": [{"name": "a", "color": [2, 0, 0]}]},
]
# A value that a report must not have, by the keys that lead to it.
WRONG_REPORTS = [
    (["verdict"], None),
    (["domain", "vertices"], -1),
    (["methods", 0, "degree_histogram"], [0, 0, 3]),
    (["methods", 0, "metrics", "shape", "p99"], "1"),
    (["methods", 0, "defects"], [{"kind": "ugly", "count": None, "message": "…"}]),
    (["methods", 0], {}),
]
# Keys that a report must have.
NEEDED = [["domain"], ["methods", 0, "seconds"], ["methods", 0, "defects"]]


def inside(document, keys):
    for key in keys:
        document = document[key]
    return document


def main():
    mindeg, folder = sys.argv[1], Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    tally = Tally()

    def run(*arguments):
        return subprocess.run([mindeg, *arguments], capture_output=True, text=True, timeout=300)

    def validator(name, text):
        schema = json.loads(text)
        Draft202012Validator.check_schema(schema)
        tally.record(f"{name}: a JSON Schema", True)
        return Draft202012Validator(schema)

    def keeps(name, judge, document):
        faults = [f"{list(fault.absolute_path)}: {fault.message[:200]}" for fault in judge.iter_errors(document)]
        tally.record(f"{name} keeps to its schema", not faults, faults[:3])

    domains = validator("domains", run("schema").stdout)
    models = validator("models", run("schema", "--model").stdout)
    for kind, judge, wrong in (("domains", domains, WRONG_DOMAINS), ("models", models, WRONG_MODELS)):
        examples = sorted((ROOT / "assets" / kind).glob("*.json"))
        tally.record(f"{kind}: examples", len(examples) > 2, len(examples))
        for example in examples:
            keeps(example.name, judge, json.loads(example.read_text()))
        for number, document in enumerate(wrong):
            file = folder / f"wrong-{kind}-{number}.json"
            file.write_text(json.dumps(document))
            tally.record(f"{kind}: the schema refuses {document}", not judge.is_valid(document), "it takes it")
            refused = run("degree", file).returncode == 2
            tally.record(f"{kind}: mindeg refuses {document}", refused, "it takes it")

    keeps("a domain with every key", domains, FULL)
    full = folder / "full.json"
    full.write_text(json.dumps(FULL))
    copied = folder / "written.json"
    written = run("domain", full, "-o", copied)
    if written.returncode:
        tally.record("the domain with every key is written", False, written.stderr)
    else:
        keeps("the domain with every key, as mindeg writes it,", domains, json.loads(copied.read_text()))

    reports = validator("reports", (ROOT / "docs" / "report.schema.json").read_text())
    corners, good = [[0, 0], [4, 0], [1, 3]], None
    # A plain one; one in which the fan is missing; one in which nothing was in time.
    for intervals, limit in (([2, 1, 1], 60), ([8, 8, 8], 60), ([8, 8, 8], 0)):
        domain = folder / "triangle.json"
        sides = [{"intervals": count} for count in intervals]
        domain.write_text(json.dumps({"polygon": {"corners": corners}, "sides": sides}))
        report = folder / "report.json"
        made = run("compare", domain, "-o", report, "--quiet", "--time-limit", str(limit))
        if made.returncode:
            tally.record(f"a report of {intervals} in {limit} s", False, made.stderr)
            continue
        document = json.loads(report.read_text())
        keeps(f"a report of {intervals} in {limit} s", reports, document)
        good = document if limit and intervals[0] == 8 else good
    for keys, value in WRONG_REPORTS:
        wrong = copy.deepcopy(good)
        inside(wrong, keys[:-1])[keys[-1]] = value
        tally.record(f"the schema refuses a report with {keys} = {value}", not reports.is_valid(wrong), "it takes it")
    for keys in NEEDED:
        wrong = copy.deepcopy(good)
        del inside(wrong, keys[:-1])[keys[-1]]
        tally.record(f"the schema refuses a report without {keys}", not reports.is_valid(wrong), "it takes it")
    tally.finish()


if __name__ == "__main__":
    main()
