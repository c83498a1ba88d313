"""Files of our own with the quirks of the field's: InkML of tablets and offices, MATLAB sets."""

import io

import numpy as np
import scipy.io

SPACE = "http://www.w3.org/2003/InkML"
PLAIN = '<channel name="X" type="decimal" units="mm"/><channel name="Y" type="decimal" units="mm"/>'
TIMED = PLAIN + '<channel name="T" type="decimal" units="ms"/>'
FORCED = TIMED + '<channel name="F" type="integer" min="0" max="1000"/>'


def inkml(body, channels=FORCED, *, extra="", prefix="", root=""):
    """An InkML document of traces (`body`); `extra` stands beside the format in the context."""
    space = f'xmlns:{prefix[:-1]}="{SPACE}"' if prefix else f'xmlns="{SPACE}"'
    text = (
        f'<ink {space}{root}><context xml:id="c">{extra}<traceFormat>{channels}</traceFormat>'
        f"</context>{body}</ink>"
    )
    if prefix:
        for tag in (
            "ink",
            "context",
            "traceFormat",
            "channel",
            "traceGroup",
            "trace",
            "annotation",
            "inkSource",
        ):
            text = text.replace(f"<{tag} ", f"<{prefix}{tag} ").replace(
                f"<{tag}>", f"<{prefix}{tag}>"
            )
            text = text.replace(f"</{tag}>", f"</{prefix}{tag}>")
    return text


def d_strokes(rate=100.0):
    """The strokes of a D as (t [s], x, y [m] with y up, pressure 0 to 1), at rest at both ends."""
    s = np.linspace(0, 1, 81)
    ease = s - np.sin(2 * np.pi * s) / (2 * np.pi) * 0.9
    bar = np.column_stack([s * 80 / rate, 0 * s, 0.06 - 0.06 * ease, 0.2 + 0.5 * np.sin(np.pi * s)])
    angle = np.pi / 2 - np.pi * ease
    bowl = np.column_stack(
        [1.2 + s * 80 / rate, 0.035 * np.cos(angle), 0.03 + 0.03 * np.sin(angle), 0.3 + 0.6 * s]
    )
    return [bar, bowl]


def trace(stroke, form="{x:.4f} {y:.4f} {t:.3f} {f:.0f}", attributes="", left=12.5, top=91.0):
    """One trace in millimetres with y down the page, as on a tablet."""
    rows = [
        form.format(x=left + 1000 * x, y=top - 1000 * y, t=1000 * t, f=1000 * force)
        for t, x, y, force in stroke
    ]
    return f"<trace{attributes}>{', '.join(rows)}</trace>"


def d_inkml(**how):
    """A plain file with the D in it."""
    return inkml("".join(trace(stroke) for stroke in d_strokes()), **how)


def mat(variables, compressed=True):
    """A MATLAB file by SciPy, which we do not read with."""
    file = io.BytesIO()
    scipy.io.savemat(file, variables, do_compression=compressed)
    return file.getvalue()


def cells(values):
    """A cell array of 1 x N."""
    array = np.empty((1, len(values)), dtype=object)
    for k, value in enumerate(values):
        array[0, k] = value
    return array


def loop(turns=1.0, samples=160, size=1.0):
    """A pen that rests at both ends, at 200 Hz, shape (T, 2): a loop that drifts to the right."""
    s = np.linspace(0, 1, samples)
    angle = 2 * np.pi * turns * (s - np.sin(2 * np.pi * s) / (2 * np.pi))
    return size * np.column_stack([np.sin(angle) + 0.1 * angle, 1 - np.cos(angle)])


def uci(paths, labels=(1, 2, 1), key=("a", "d"), pad=(7, 11), force="rate"):
    """Character Trajectories: speeds of the paths, zeros before and after, force or its rate."""
    mixout = []
    for path in paths:
        speed = np.diff(path, axis=0, prepend=path[:1]) * 200
        press = np.sin(np.linspace(0.1, np.pi - 0.1, len(path)))
        row = np.gradient(press) if force == "rate" else press
        mixout.append(np.pad(np.column_stack([speed, row]).T, ((0, 0), pad)))
    consts = {
        "charlabels": np.array([labels]),
        "key": cells(list(key)),
        "datanorm": np.array([[1.0, 1.0, 1.0]]),
    }
    return {"mixout": cells(mixout), "consts": consts}


def lasa(paths, dt=0.004):
    """LASA: positions in millimetres that end at the origin, times, speeds, accelerations."""
    demos = []
    for path in paths:
        pos = 1000 * (path - path[-1]).T
        t = np.arange(len(path))[None] * dt
        vel = np.gradient(pos, axis=1) * 250
        demos.append(
            {"pos": pos, "t": t, "vel": vel, "acc": np.gradient(vel, axis=1) * 250, "dt": dt}
        )
    return {"demos": cells(demos), "dt": dt}
