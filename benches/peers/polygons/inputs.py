#!/usr/bin/env python3
"""Writes the rings of country outlines and icons, for programs that take points.

    inputs.py FOLDER [--full]

The outlines are those of benches/outlines/rings.py. Of every 31st icon of the npm package @mdi/svg it is the
polygon with the most points of those without holes, where it has 30 or more, with the points that mindeg
puts on its curves; MINDEG names the program.
"""

import json
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
OUTLINES = ROOT / "target" / "outlines"
ICONS = "@mdi/svg@7.4.47"
EVERY = 31
LEAST = 30
COUNTRIES = {
    "50m": ["Croatia", "Greece", "Indonesia", "Germany", "France", "Norway", "Chile", "Canada"],
}
MORE = {"10m": ["Switzerland", "United Kingdom", "Chile", "Canada"]}


def main():
    folder = Path(sys.argv[1])
    full = "--full" in sys.argv
    shutil.rmtree(folder, ignore_errors=True)
    for part in ("outlines", "icons"):
        (folder / part).mkdir(parents=True)
    for resolution, names in {**COUNTRIES, **(MORE if full else {})}.items():
        files = {name: OUTLINES / f"{name.replace(' ', '_')}_{resolution}.txt" for name in names}
        missing = [name for name, file in files.items() if not file.exists()]
        if missing:
            subprocess.run([ROOT / "benches" / "outlines" / "rings.py", resolution, *missing], check=True)
        for file in files.values():
            shutil.copy(file, folder / "outlines")
    subprocess.run(["npm", "install", "--silent", "--prefix", OUTLINES, ICONS], check=True)
    icons = sorted((OUTLINES / "node_modules" / "@mdi" / "svg" / "svg").glob("*.svg"))
    for icon in icons[::EVERY]:
        ring = largest_ring(icon)
        if ring:
            (folder / "icons" / f"{icon.stem}.txt").write_text("\n".join(ring) + "\n")


def largest_ring(icon):
    with tempfile.TemporaryDirectory() as scratch:
        command = [os.environ["MINDEG"], "mesh", icon, "--json", "-q", "-o", f"{scratch}/meshes/"]
        process = subprocess.run(command, capture_output=True, text=True)
        answers = [json.loads(line) for line in process.stdout.splitlines()]
        whole = [answer for answer in answers if answer["triangles"] == answer["vertices"] - 2]
        best = max(whole, key=lambda answer: answer["vertices"], default=None)
        if best is None or best["vertices"] < LEAST:
            return None
        lines = Path(best["files"][0]).read_text().splitlines()
        return [" ".join(line.split()[1:3]) for line in lines if line.startswith("v ")]


if __name__ == "__main__":
    main()
