"""The page: one file of HTML that needs nothing else."""
import datetime
import html
import json
import pathlib
import string

from . import figures
from .run import drawing

HERE = pathlib.Path(__file__).resolve().parent
SCRIPTS = ("axes.js", "view.js", "chart.js", "states.js", "map.js", "page.js")
DIGITS = 3  # of metres and seconds; more for what is small
FIRST_DATE = 1e9  # [s]
HINT = ("Errors are horizontal. An estimate is beyond its own 3 sigma where the truth lies outside the 3 sigma ellipse of "
        "its covariance. NEES and NIS say how well claimed and true errors, claimed and seen innovations agree.")


def rounded(value):
    """The same without digits nobody sees, which make most of a page's size."""
    if isinstance(value, dict):
        return {key: rounded(item) for key, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [rounded(item) for item in value]
    if isinstance(value, float):
        return round(value, DIGITS) if abs(value) >= 0.1 else float(f"{value:.3g}")
    return value


def as_data(drawn):
    """JSON that may stand within a script element."""
    text = json.dumps(rounded(drawn), separators=(",", ":"), allow_nan=False)
    return text.replace("<", "\\u003c")


def table_of(rows):
    head = "".join(f"<th scope=\"col\">{html.escape(cell)}</th>" for cell in rows[0])
    lines = [f"<table>\n<thead><tr>{head}</tr></thead>\n<tbody>"]
    for title, *cells in rows[1:]:
        values = "".join(f"<td>{html.escape(cell)}</td>" for cell in cells)
        lines.append(f"<tr><th scope=\"row\">{html.escape(title)}</th>{values}</tr>")
    return "\n".join(lines + ["</tbody>\n</table>"])


def tiles_of(tiles):
    return "\n".join(f"<div><b>{value} <small>{unit}</small></b><span>{html.escape(what)}</span></div>"
                     for value, unit, what in tiles)


def since(stamp):
    """When a recording began; stamps of a simulation begin near 0."""
    if stamp < FIRST_DATE:
        return ""
    return datetime.datetime.fromtimestamp(stamp, datetime.timezone.utc).strftime(", recorded from %Y-%m-%d %H:%M:%S UTC on")


def about(recording):
    names = ", ".join(run["name"] for run in recording["runs"])
    truth = "scored against the truth" if recording["streams"][0]["truth"] else "without truth"
    return f"Localisation by {names}, {truth}{since(recording['start'])}."


def short(recording):
    """Of whom the tiles are, where there are several."""
    runs = recording["runs"]
    return f"<p class=\"about\">In short, of {html.escape(runs[0]['name'])}:</p>" if len(runs) > 1 else ""


def page(recording):
    """The text of the page about a recording as run.py has it."""
    notes = "\n".join(f"<p class=\"note\">{html.escape(note)}</p>" for note in recording["notes"])
    return string.Template((HERE / "page.html").read_text()).substitute(
        title=html.escape(recording["title"]), about=html.escape(about(recording)), notes=notes, short=short(recording),
        tiles=tiles_of(figures.tiles(recording)), table=table_of(figures.table(recording)), hint=HINT,
        style=(HERE / "page.css").read_text(), data=as_data(drawing(recording)),
        script="\n".join((HERE / name).read_text() for name in SCRIPTS))
