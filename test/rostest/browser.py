"""Opens a page in a browser without a window, where one is installed, and uses it like a hand at mouse and keyboard."""
import html
import json
import pathlib
import re
import shutil
import subprocess
import tempfile

BROWSER = next(filter(None, map(shutil.which, ('chromium', 'chromium-browser', 'google-chrome'))), None)
# A browser that has only to tell its page makes no frames.
FRAMES = "<head><script>window.requestAnimationFrame = (draw) => setTimeout(draw, 10);</script>"
USE = """<script>
const found = {errors: []};
window.addEventListener('error', (event) => found.errors.push(event.message));
const all = (selector) => [...document.querySelectorAll(selector)];
const later = (frames, action) => requestAnimationFrame(() => frames > 1 ? later(frames - 1, action) : action());
const point = (type, element, part) => {
  const box = element.getBoundingClientRect();
  const place = {clientX: box.left + part * box.width, clientY: box.top + 50};
  element.dispatchEvent(new PointerEvent(type, {bubbles: true, ...place}));
};
const pixels = (canvas) => canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
const drawn = (canvas) => pixels(canvas).some((part) => part > 0);
const steps = [
  () => { found.charts = all('figcaption b').map((title) => title.textContent);
          found.drawn = all('.plot, #map').map((plot) => drawn(plot.querySelector('canvas'))); },
  () => point('pointermove', all('.plot')[0], 0.5),
  () => { found.pointed = document.getElementById('readout').textContent;
          found.marked = all('.plot, #map').map((plot) => drawn(plot.querySelectorAll('canvas')[1])); },
  () => point('pointerdown', all('.plot')[0], 0.3),
  () => point('pointermove', all('.plot')[0], 0.6),
  () => point('pointerup', all('.plot')[0], 0.6),
  () => { found.window = view.window.map((time) => Math.round(time)); },
  () => document.getElementById('map').dispatchEvent(new WheelEvent('wheel', {deltaY: -200, clientX: 300, clientY: 400})),
  () => { all('#legend button, .tools button, .mapbuttons button').forEach((button) => button.click()); },
  () => { for (const key of ['ArrowRight', 'Escape']) {
            document.getElementById('charts').dispatchEvent(new KeyboardEvent('keydown', {key, bubbles: true})); } },
  () => { found.whole = view.window.map((time) => Math.round(time)); found.theme = document.documentElement.dataset.theme; },
  () => { document.body.dataset.found = JSON.stringify(found); },
];
const next = () => { if (steps.length > 0) { steps.shift()(); later(3, next); } };
later(3, next);
</script></body>"""


def used(page):
    """What was seen of a page while it was used, and what the browser's console said of it. Throws on a timeout."""
    with tempfile.TemporaryDirectory() as folder:
        copy = pathlib.Path(folder) / 'page.html'
        copy.write_text(pathlib.Path(page).read_text().replace('<head>', FRAMES).replace('</body>', USE))
        command = [BROWSER, '--headless', '--no-sandbox', '--disable-gpu', '--disable-dev-shm-usage',
                   f'--user-data-dir={folder}/profile', '--window-size=1400,1600', '--virtual-time-budget=8000',
                   '--enable-logging=stderr', '--dump-dom', copy.as_uri()]
        done = subprocess.run(command, capture_output=True, text=True, timeout=90)
    found = re.search(r'data-found="([^"]*)"', done.stdout)
    return (json.loads(html.unescape(found[1])) if found else {},
            [line for line in done.stderr.splitlines() if 'CONSOLE' in line])
