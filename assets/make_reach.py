"""Try where the usual pages can lie, and write what is found to `reach.json` beside this file.

    python assets/make_reach.py

A minute or two of one processor; `tests/robot/test_reach_map.py` holds it.
"""

from __future__ import annotations

import json

import numpy as np

from dmp_teach.robot import KNOWN_REACH, USUAL_PAGES, reach_around

AHEAD = np.round(np.arange(0.30, 1.201, 0.05), 2)
LEFT = np.round(np.arange(-0.90, 0.901, 0.05), 2)

if __name__ == "__main__":
    known: dict[str, object] = {"x": AHEAD.tolist(), "y": LEFT.tolist()}
    for name, page in USUAL_PAGES.items():
        found = reach_around(page, AHEAD, LEFT)
        effort = np.where(found.reached, found.effort, 0)
        known[name] = {
            "effort": np.round(effort, 2).tolist(),
            "residual": np.round(1000 * found.residual, 2).tolist(),
        }
        print(name, found)
    KNOWN_REACH.write_text(json.dumps(known, separators=(",", ":")) + "\n", encoding="utf-8")
