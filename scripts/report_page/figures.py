"""The table of figures: what evaluate scored, or the same reckoned here, and how the run went."""
import math

from .run import POSITIONS, STATES, distances, error_column, sigma_of
from .series import intervals, length, quantile

NIS_95 = 5.991  # of 2 degrees of freedom, below which 95 % should lie
RAD = 180.0 / math.pi
STANDING_BY = ("unused", "not needed")  # of kinds the estimator does without

# title, key of `evaluate --json`, factor, digits, key of the fixes
SCORES = [
    ("Root mean square error [m]", "rmse_m", 1.0, 2, "fix_rmse_m"),
    ("  where fixes are biased [m]", "rmse_shadow_m", 1.0, 2, "fix_rmse_shadow_m"),
    ("  under open sky [m]", "rmse_open_m", 1.0, 2, "fix_rmse_open_m"),
    ("Median error [m]", "median_m", 1.0, 2, "fix_median_m"),
    ("95 % of errors below [m]", "p95_m", 1.0, 2, "fix_p95_m"),
    ("Largest error [m]", "max_m", 1.0, 2, "fix_max_m"),
    ("RMS error of the heading [deg]", "heading_rmse_rad", RAD, 2, None),
    ("Longest time off, by 2 m or --off-from [s]", "longest_off_s", 1.0, 1, None),
    ("Longest time beyond its own 3 sigma [s]", "longest_beyond_3_sigma_s", 1.0, 1, None),
    ("NEES (2 is ideal)", "nees_mean", 1.0, 2, None),
    ("Way until aligned [m]", "way_to_alignment_m", 1.0, 1, None),
    ("Processor time [s]", "cpu_s", 1.0, 2, None),
]


def scores(errors, prefix=""):
    if not errors:
        return {}
    return {f"{prefix}rmse_m": math.sqrt(sum(e * e for e in errors) / len(errors)),
            f"{prefix}median_m": quantile(errors, 0.5), f"{prefix}p95_m": quantile(errors, 0.95), f"{prefix}max_m": max(errors)}


def scored(run, recording):
    """The figures of evaluate, or those of them that can be reckoned here."""
    if run["figures"]:
        return run["figures"]
    stream = recording["streams"][run["stream"]]
    errors, beyond = error_column(run, stream["truth"])
    known = [error for error in errors if error is not None]
    if not known:
        return {}
    times = run["estimates"]["t"]
    off = intervals(times, [error is not None and error >= 2.0 for error in errors])
    return {**scores(known), **scores(stream["fix_errors"]["error"], "fix_"),
            "longest_off_s": longest(off), "longest_beyond_3_sigma_s": longest(beyond)}


def longest(spans):
    return max((end - begin for begin, end in spans), default=0.0)


def text(value, digits, factor=1.0):
    return "–" if value is None else f"{value * factor:.{digits}f}"


def rows_of_scores(found):
    """Rows of (title, fixes, one for each run); those that apply to no run are left out."""
    for title, key, factor, digits, of_fixes in SCORES:
        values = [scores_of_run.get(key) for scores_of_run in found]
        if any(value is not None for value in values):
            fixes = found[0].get(of_fixes) if of_fixes else None
            yield [title, text(fixes, digits)] + [text(value, digits, factor) for value in values]


def shares_of_states(estimates):
    """{state: share of the time}, by the times up to the next estimate."""
    held = [0.0] * len(STATES)
    times = estimates["t"]
    for state, time, following in zip(estimates["state"], times, times[1:]):
        if state is not None:
            held[state] += min(following - time, 1.0)
    whole = sum(held) or 1.0
    return [part / whole for part in held]


def rows_of_states(runs):
    shares = [shares_of_states(run["estimates"]) for run in runs]
    for i, state in enumerate(STATES):
        if any(share[i] > 0.0 for share in shares):
            yield [f"Time {state.replace('_', ' ')} [%]", ""] + [text(share[i], 1, 100.0) for share in shares]


def nis_of(weighings):
    return [nis for nis, kind in zip(weighings["nis"], weighings["kind"]) if nis is not None and kind in POSITIONS]


def row(title, runs, figure):
    """figure(run): text of a cell"""
    return [title, ""] + [figure(run) for run in runs]


def used(run):
    reasons = [reason for reason, kind in zip(run["weighings"]["reason"], run["weighings"]["kind"])
               if kind in POSITIONS and reason not in STANDING_BY]
    return f"{sum(reason == 'accepted' for reason in reasons)} of {len(reasons)}" if reasons else "–"


def share_below(values, limit):
    return text(sum(value <= limit for value in values) / len(values), 1, 100.0) if values else "–"


def median(values, digits=2):
    return text(quantile(values, 0.5), digits) if values else "–"


def rows_of_measurements(runs, streams):
    def to_fixes(run):
        return distances(run["estimates"], streams[run["stream"]]["fixes"])["error"]

    yield row("Way of the estimate [m]", runs, lambda run: text(length(run["estimates"]), 0))
    if any(stream["fixes"]["t"] for stream in streams):
        yield row("Median distance to the fixes [m]", runs, lambda run: median(to_fixes(run)))
    if any(run["weighings"]["t"] for run in runs):
        yield row("Measurements of position used", runs, used)
        yield row("Median NIS (1.4 is ideal)", runs, lambda run: median(nis_of(run["weighings"])))
        yield row("NIS below its 95 % [%]", runs, lambda run: share_below(nis_of(run["weighings"]), NIS_95))


def table(recording):
    """Rows of texts, the first one the head: figure, fixes, and each estimator."""
    runs = recording["runs"]
    rows = [["", "fixes as they came"] + [run["name"] for run in runs]]
    rows += rows_of_scores([scored(run, recording) for run in runs])
    rows += [*rows_of_states(runs), *rows_of_measurements(runs, recording["streams"])]
    with_fixes = any(cells[1] not in ("", "–") for cells in rows[1:])
    return rows if with_fixes else [[cells[0]] + cells[2:] for cells in rows]


def driven(run, recording):
    """The way of the truth or, without, of the odometry [m]."""
    stream = recording["streams"][run["stream"]]
    if stream["truth"]:
        return length(stream["truth"])
    times, speeds = stream["odometry"]["t"], stream["odometry"]["speed"]
    return sum(abs(speed) * min(after - before, 1.0) for speed, before, after in zip(speeds, times, times[1:]))


def tiles(recording):
    """(value, unit, what it is) of the first estimator, for the head of the page."""
    run = recording["runs"][0]
    found = scored(run, recording)
    shares = shares_of_states(run["estimates"])
    span = run["estimates"]["t"][-1] - run["estimates"]["t"][0]
    shown = [(text(driven(run, recording), 0), "m", "driven"), (duration(span), "", "recorded")]
    for key, what in (("rmse_m", "root mean square error"), ("fix_rmse_m", "the same of the fixes"),
                      ("max_m", "largest error"), ("longest_beyond_3_sigma_s", "longest beyond its 3 sigma")):
        if found.get(key) is not None:
            shown.append((text(found[key], 1 if key.endswith("_s") else 2), "s" if key.endswith("_s") else "m", what))
    if found.get("rmse_m") is None:
        shown += tiles_without_truth(run, recording["streams"][run["stream"]])
    if sum(shares) > 0.0:
        aligned = sum(shares[STATES.index(state)] for state in ("GOOD", "MULTIPATH"))
        shown.append((text(aligned, 0, 100.0), "%", "of the time GOOD or MULTIPATH"))
    return shown


def tiles_without_truth(run, stream):
    sigmas = [3.0 * sigma_of(*P) for P in zip(*(run["estimates"][key] for key in ("xx", "xy", "yy")))]
    yield median(distances(run["estimates"], stream["fixes"])["error"]), "m", "median distance to the fixes"
    yield used(run), "", "measurements used"
    yield text(quantile(sigmas, 0.5), 2), "m", "median of the 3 sigma it claims"
    yield text(max(sigmas), 1), "m", "largest 3 sigma"


def duration(seconds):
    minutes, rest = divmod(round(seconds), 60)
    hours, minutes = divmod(minutes, 60)
    return f"{hours}:{minutes:02d}:{rest:02d} h" if hours else f"{minutes}:{rest:02d} min"
