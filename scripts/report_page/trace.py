"""Reads a trace that `evaluate --report` hands on."""
import json
import pathlib

from .run import STATES
from .series import BadRun, check_columns, check_times, in_order, is_number


def part(owner, name, kind, of):
    """An entry of an object of JSON, or BadRun."""
    value = owner.get(name) if isinstance(owner, dict) else None
    if not isinstance(value, kind):
        raise BadRun(f"{of} has no '{name}' as evaluate writes it")
    return value


def columns_of(owner, of, names, late=True):
    """Columns of numbers; with `late` rows may stand out of order, as measurements come."""
    found = {name: part(owner, name, list, of) for name in names}
    check_columns(of, found)
    if late:
        return in_order(found)
    check_times(of, found["t"])
    return found


def read_states(run, of):
    states = part(run, "state", list, of)
    for state in states:
        if state not in STATES:
            raise BadRun(f"{of}: {str(state)[:40]} is no state")
    return [STATES.index(state) for state in states]


def read_weighings(run, of):
    """Numbers are null where a measurement was not compared."""
    of = f"{of}, weighings"
    owner = part(run, "weighings", dict, of)
    found = {name: part(owner, name, list, of) for name in ("t", "kind", "reason", "nis")}
    if len({len(column) for column in found.values()}) > 1:
        raise BadRun(f"{of}: the columns differ in length")
    for name in ("t", "nis"):
        if not all(is_number(value) or (value is None and name != "t") for value in found[name]):
            raise BadRun(f"{of}: {name} holds what is no number to be drawn")
    return found


def read_run(run):
    name = part(run, "estimator", str, "a run")
    of = f"run {name}"
    estimates = columns_of(run, of, ("t", "x", "y", "yaw"), late=False)
    estimates.update(columns_of({"t": estimates["t"], **part(run, "covariance", dict, of)}, f"{of}, covariance",
                                ("t", "xx", "xy", "yy")))
    estimates["state"] = read_states(run, of)
    if len(estimates["state"]) != len(estimates["t"]):
        raise BadRun(f"{of}: there are {len(estimates['state'])} states at {len(estimates['t'])} times")
    figures = {key: value for key, value in part(run, "figures", dict, of).items() if is_number(value)}
    headings = columns_of(part(run, "heading_errors_deg", dict, of), f"{of}, heading errors", ("t", "error"))
    return {"name": name, "estimates": estimates, "headings": headings, "weighings": read_weighings(run, of),
            "figures": figures, "drive": run.get("drive")}


def read_stream(owner, of):
    truth = columns_of(part(owner, "truth", dict, of), f"{of}, truth", ("t", "x", "y", "shadow"))
    return {"truth": truth if truth["t"] else None,
            "fixes": columns_of(part(owner, "fixes", dict, of), f"{of}, fixes", ("t", "x", "y")),
            "fix_errors": columns_of(part(owner, "fix_errors", dict, of), f"{of}, errors of fixes", ("t", "error")),
            "odometry": columns_of(part(owner, "odometry", dict, of), f"{of}, odometry", ("t", "speed"))}


def read_streams(data, runs):
    """The streams; tells each run the number of its own."""
    streams = [read_stream(data, "the trace")]
    for run in runs:
        stream = read_stream(run["drive"], f"run {run['name']}") if run["drive"] else streams[0]
        if stream not in streams:
            streams.append(stream)
        run["stream"] = streams.index(stream)
    return streams


def load(file):
    try:
        return json.loads(pathlib.Path(file).read_text())
    except OSError as error:
        raise BadRun(f"cannot be read: {error.strerror}") from None
    except ValueError as error:
        raise BadRun(f"is neither a bag nor JSON: {error}") from None


def read_trace(file):
    """A recording as run.py has it. Throws BadRun."""
    data = load(file)
    of = "the trace"
    runs = [read_run(run) for run in part(data, "runs", list, of)]
    notes = [f"{run['name']} never had an estimate and is left out." for run in runs if not run["estimates"]["t"]]
    runs = [run for run in runs if run["estimates"]["t"]]
    if not runs:
        raise BadRun("no run of it has an estimate")
    streams = read_streams(data, runs)
    if len(streams) > 1:
        notes.append("Each estimator steered the robot by itself, another way than the others: truth and fixes shown are "
                     "those of the one chosen above the map.")
    return {"title": part(data, "title", str, of), "start": 0.0, "notes": notes, "streams": streams, "runs": runs}
