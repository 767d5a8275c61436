"""How a viewer's script hands over what it read: a file with one line of JSON a mesh."""

import json
import sys


def write_readings(read):
    """Runs `read` on every file named on the command line: SCRIPT READINGS.jsonl FILE..."""
    readings_path, *paths = sys.argv[1:]
    with open(readings_path, "w", encoding="utf-8") as readings:
        for path in paths:
            try:
                reading = read(path)
            except Exception as problem:  # whatever the viewer says is the reading
                reading = {"error": str(problem).strip()}
            # Flushed a line at a time: if the viewer crashes, the lines show on which file.
            print(json.dumps({"file": path, **reading}), file=readings, flush=True)
