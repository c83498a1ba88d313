"""Units of length and time by the names that programs give them."""

from __future__ import annotations

PIXEL = 0.0254 / 96  # as browsers have it [m]
METRES = {"m": 1.0, "dm": 0.1, "cm": 0.01, "mm": 0.001, "um": 1e-6, "µm": 1e-6, "himetric": 1e-5}
METRES |= {"meter": 1.0, "centimeter": 0.01, "millimeter": 0.001}
METRES |= {"metre": 1.0, "centimetre": 0.01, "millimetre": 0.001}
METRES |= {"in": 0.0254, "inch": 0.0254, "inches": 0.0254, "pt": 0.0254 / 72, "pc": 0.0254 / 6}
METRES |= {"px": PIXEL, "pixel": PIXEL, "pixels": PIXEL, "q": 0.00025}
SECONDS = {"s": 1.0, "ms": 0.001, "us": 1e-6, "µs": 1e-6, "ns": 1e-9, "min": 60.0}
SECONDS |= dict.fromkeys(("sec", "secs", "second", "seconds"), 1.0)
SECONDS |= dict.fromkeys(("msec", "millis", "milliseconds"), 0.001)
