"""A run as the page draws it: an estimator's way beside truth, how sure it was, in which state, and its measurements.

A recording is a dict: title, start (stamp of time 0), notes, streams and runs.
A stream, over which one run or several went: truth (t, x, y, shadow; None without), fixes (t, x, y), fix_errors (t, error) and
odometry (t, speed).
A run: name, stream (its number), estimates (t, x, y, yaw, state: a number, None where it is not known, xx, xy, yy: covariance
[m^2]), headings (t, error [deg]), weighings (t, kind, reason, nis: None where nothing was compared) and figures as
`evaluate --json` names them, or {} for those that are to be reckoned here.
"""
import math

from . import series

STATES = ["NOT_READY", "ALIGNING", "GOOD", "MULTIPATH", "DEAD_RECKONING", "LOST"]
POSITIONS = ("fix", "dual", "epoch")  # kinds of measurements that tell where the robot is


def sigma_of(xx, xy, yy):
    """Standard deviation in the direction in which it is largest [m]."""
    middle, apart = 0.5 * (xx + yy), math.hypot(0.5 * (xx - yy), xy)
    return math.sqrt(max(0.0, middle + apart))


def is_beyond(error, xx, xy, yy):
    """Whether an error lies outside the 3 sigma ellipse, to which a millimetre is added as in evaluate."""
    xx, yy = xx + 1e-6, yy + 1e-6
    determinant = xx * yy - xy * xy
    x, y = error
    return determinant > 0.0 and yy * x * x - 2.0 * xy * x * y + xx * y * y > 9.0 * determinant


def check_covariances(name, estimates):
    for time, xx, xy, yy in zip(*(estimates[key] for key in ("t", "xx", "xy", "yy"))):
        if min(xx, yy) < 0.0 or xy * xy > xx * yy * (1.0 + 1e-6) + 1e-12:
            raise series.BadRun(f"{name}: at {time:.3f} s the covariance [{xx:g} {xy:g}; {xy:g} {yy:g}] is none")


def errors_of(track, truth):
    """The errors as (x, y), None where there is no truth."""
    found = []
    for time, x, y in zip(track["t"], track["x"], track["y"]):
        place = series.at(truth, time) if truth else None
        found.append((x - place[0], y - place[1]) if place else None)
    return found


def error_column(run, truth):
    """How far each estimate was off [m], None where truth does not tell; and when it was beyond its 3 sigma."""
    estimates = run["estimates"]
    errors = errors_of(estimates, truth)
    covariances = zip(estimates["xx"], estimates["xy"], estimates["yy"])
    beyond = [error is not None and is_beyond(error, *P) for error, P in zip(errors, covariances)]
    return [error and math.hypot(*error) for error in errors], series.intervals(estimates["t"], beyond)


def compared(weighings):
    """t and NIS of the positions that were compared with the estimate, and whether they were used."""
    rows = [(time, nis, int(reason == "accepted")) for time, kind, reason, nis in zip(*weighings.values())
            if nis is not None and kind in POSITIONS]
    columns = {key: [row[i] for row in rows] for i, key in enumerate(("t", "nis", "used"))}
    return series.thinned(columns, columns["nis"])


def distances(estimates, fixes):
    """How far each fix, which is where the antenna is, lay from the estimate [m]."""
    pairs = [(time, math.hypot(*error)) for time, error in zip(fixes["t"], errors_of(fixes, estimates)) if error]
    return {"t": [time for time, _ in pairs], "error": [error for _, error in pairs]}


def drawn(run, stream):
    """The run with all that the page shows of it over time."""
    estimates, truth = run["estimates"], stream["truth"]
    check_covariances(run["name"], estimates)
    errors, beyond = error_column(run, truth)
    columns = dict(estimates, error=errors)
    columns["sigma3"] = [3.0 * sigma_of(*P) for P in zip(estimates["xx"], estimates["xy"], estimates["yy"])]
    weights = [sigma if error is None else error for error, sigma in zip(errors, columns["sigma3"])]
    return {"name": run["name"], "stream": run["stream"], "beyond": beyond, **series.thinned(columns, weights),
            "speeds": thinned_speeds(estimates),
            "headings": thinned_errors(run["headings"]),
            "nis": compared(run["weighings"]), "distances": thinned_errors(distances(estimates, stream["fixes"]))}


def thinned_errors(columns):
    return series.thinned(columns, [abs(error) for error in columns["error"]])


def thinned_speeds(track):
    found = series.speeds(track)
    return series.thinned(found, found["speed"])


def drawn_truth(truth):
    if not truth:
        return None
    track = {key: truth[key] for key in ("t", "x", "y")}
    return {**series.thinned(track, [0.0] * len(track["t"])), "speeds": thinned_speeds(track),
            "shadow": series.intervals(truth["t"], truth["shadow"])}


def drawn_stream(stream):
    fixes, odometry = stream["fixes"], stream["odometry"]
    return {"truth": drawn_truth(stream["truth"]), "fixes": series.thinned(fixes, [0.0] * len(fixes["t"])),
            "fix_errors": thinned_errors(stream["fix_errors"]),
            "odometry": series.thinned(odometry, [abs(speed) for speed in odometry["speed"]])}


def drawing(recording):
    """All that the page draws, to become its JSON."""
    streams, runs = recording["streams"], recording["runs"]
    times = [run["estimates"]["t"] for run in runs]
    return {"states": STATES, "span": [min(t[0] for t in times), max(t[-1] for t in times)],
            "streams": [drawn_stream(stream) for stream in streams],
            "runs": [drawn(run, streams[run["stream"]]) for run in runs]}
