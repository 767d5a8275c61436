"""The page docs/gmsh.md, from front to back: its script for Gmsh, its commands and its Python.

    gmsh_page.py MINDEG_BINARY FOLDER [DOMAIN.json ...]
"""

import os
import re
import subprocess
import sys
from pathlib import Path

from tally import Tally

PAGE = Path(__file__).resolve().parents[2] / "docs" / "gmsh.md"


def main():
    mindeg, folder = Path(sys.argv[1]), Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    programs = folder / "bin"
    programs.mkdir(exist_ok=True)
    (programs / "mindeg").unlink(missing_ok=True)
    (programs / "mindeg").symlink_to(mindeg)
    # The gmsh of the environment that runs this.
    gmsh = Path(sys.executable).parent / "gmsh"
    (programs / "gmsh").write_text(f'#!/bin/sh\nexec "{sys.executable}" "{gmsh}" "$@"\n')
    (programs / "gmsh").chmod(0o755)
    for stale in folder.glob("*.msh"):
        stale.unlink()
    blocks = re.findall(r"^```(.+)\n((?:.*\n)*?)```$", PAGE.read_text(encoding="utf-8"), re.MULTILINE)
    tally = Tally()
    for number, (kind, text) in enumerate(blocks, 1):
        if kind == "geo":
            (folder / "fibre.geo").write_text(text, encoding="utf-8")
            continue
        command = [sys.executable, "-c", text] if kind == "python" else ["sh", "-ec", text]
        path = f"{programs}{os.pathsep}{os.environ['PATH']}"
        ran = subprocess.run(command, cwd=folder, env={**os.environ, "PATH": path}, capture_output=True, text=True)
        tally.record(f"docs/gmsh.md, block {number} ({kind})", ran.returncode == 0, ran.stderr[-600:])
    tally.record("docs/gmsh.md has its four blocks", [kind for kind, _ in blocks] == ["geo", "sh with gmsh", "python", "python"])
    tally.finish()


if __name__ == "__main__":
    main()
