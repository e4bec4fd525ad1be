"""Makes live pages, plays with them in headless Chromium as a reader would, and checks what is shown.

Usage: page_test.py LODLAB    exits 0 when all is well, 1 with a line for each fault, 77 when there is no
                              chromedriver or Chromium
"""

import pathlib
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "lessons"))
from browser_test import RIGHT, Report, in_browser  # noqa: E402

HOME, LEFT = "\ue011", "\ue012"
READY = "return !!document.querySelector('.live').live || document.querySelector('.trouble').textContent"
LIVE = "const live = document.querySelector('.live').live; "


class Page:
    """A page of a scene, open in the browser."""

    def __init__(self, browser, path):
        self.browser = browser
        self.path = path
        browser.open(path)
        for _ in range(300):
            self.ready = browser.run(READY)
            if self.ready:
                return
            time.sleep(0.1)

    def state(self):
        return self.browser.run(LIVE + "return live.state")

    def shapes(self):
        return self.browser.run("return [...document.querySelectorAll('.marks path')].map(p => p.getAttribute('d')).join()")

    def text(self, selector):
        return self.browser.run(f"return document.querySelector('{selector}').textContent")

    def place_of(self, body):
        return self.browser.run(LIVE + "const b = live.state.bodies[arguments[0]]; const r = live.svg.getBoundingClientRect();"
                                .replace("arguments[0]", str(body)) +
                                "const [x, y] = live.drawing.map.at([b.x, b.y]); return [r.left + x, r.top + y, live.drawing.map.scale]")

    def drag(self, start, by, kind="mouse"):
        x, y = round(start[0]), round(start[1])
        moves = [{"type": "pointerMove", "x": x, "y": y}, {"type": "pointerDown", "button": 0},
                 {"type": "pointerMove", "x": x + by[0] // 2, "y": y + by[1] // 2},
                 {"type": "pointerMove", "x": x + by[0], "y": y + by[1]}, {"type": "pointerUp", "button": 0}]
        self.browser.call(self.browser.session + "/actions", {"actions": [
            {"type": "pointer", "id": kind, "parameters": {"pointerType": kind}, "actions": moves}]})

    def click(self, selector):
        self.browser.run(f"document.querySelector('{selector}').click()")

    def focus(self, selector):
        self.browser.run(f"document.querySelector('{selector}').focus()")


def near(a, b, by):
    return abs(a - b) <= by


def check_sources(page, report):
    """The page says where its module was made of other sources, and only there."""
    other = page.browser.run(LIVE + "return live.calls.sources() !== lodlabSources")
    if other:
        print("page: the module was made of other sources than this build; scripts/wasm makes it anew")
    report.expect("other sources are told", page.browser.run("return !!document.querySelector('.stale')"), other)
    page.browser.run(LIVE + "live.calls.sources = () => 'others'; live.checkSources()")
    report.expect("and how that is mended", "scripts/wasm" in page.text(".stale"), True)
    page.browser.run("document.querySelector('.stale').remove()")


def check_play(page, report):
    start = page.state()
    page.click(".step")
    report.expect("step", page.state()["frame"], 1)
    page.click(".play")
    time.sleep(0.5)
    page.click(".play")
    later = page.state()
    report.expect("play moves on", later["frame"] > 1, True)
    report.expect("play moves bodies", later["hash"] != start["hash"], True)
    page.click(".reset")
    report.expect("reset", page.state()["hash"], start["hash"])


def check_drag(page, report):
    for kind, by in (("mouse", (80, -40)), ("touch", (-40, 30))):
        before, shapes = page.state()["bodies"][0], page.shapes()
        x, y, scale = page.place_of(0)
        page.drag((x, y), by, kind)
        after = page.state()["bodies"][0]
        report.expect(f"{kind}: dragged along x", near(after["x"] - before["x"], by[0] / scale, 2 / scale), True)
        report.expect(f"{kind}: dragged along y", near(after["y"] - before["y"], -by[1] / scale, 2 / scale), True)
        report.expect(f"{kind}: the picture follows", page.shapes() != shapes, True)
    before = page.state()["bodies"][0]
    turner = page.browser.run("const r = document.querySelector('.turner').getBoundingClientRect();"
                              "return [r.left + r.width / 2, r.top + r.height / 2]")
    page.drag(turner, (-30, -60))
    after = page.state()["bodies"][0]
    report.expect("turned by its dot", abs(after["angle"] - before["angle"]) > 0.1, True)
    report.expect("turned, not moved", (after["x"], after["y"]), (before["x"], before["y"]))
    page.focus(".handle")
    page.browser.press(RIGHT)
    page.browser.press(",")
    keyed = page.state()["bodies"][0]
    report.expect("moved by a key", keyed["x"] > after["x"], True)
    report.expect("turned by a key", keyed["angle"] > after["angle"], True)
    page.click(".reset")


def check_sliders(page, report):
    page.browser.run(LIVE + "const [a, b] = live.state.bodies; live.place(0, b.x, b.y, a.angle)")
    full, shapes = page.state(), page.shapes()
    page.focus(".level")
    page.browser.press(HOME)
    coarse = page.state()
    report.expect("level: set", coarse["level"], 0)
    report.expect("level: fewer tests", coarse["tests"] < full["tests"], True)
    report.expect("level: the picture follows", page.shapes() != shapes, True)
    page.browser.run("const s = document.querySelector('.level'); s.value = s.max; s.dispatchEvent(new Event('input'))")
    page.focus(".budget")
    page.browser.press(HOME)
    for _ in range(8):
        page.browser.press(RIGHT)
    cut = page.state()
    report.expect("budget: set", cut["budget"], 12)
    report.expect("budget: it ends frames", cut["interrupted"], True)
    report.expect("budget: said", "the budget ended first" in page.text(".spending"), True)
    report.expect("budget: a bar", page.browser.run("return document.querySelector('.spent').getBoundingClientRect().width > 0"), True)
    page.browser.run("const s = document.querySelector('.budget'); s.value = s.max; s.dispatchEvent(new Event('input'))")
    report.expect("budget: none", page.state()["budget"], None)
    page.browser.run("const s = document.querySelector('.policy'); s.value = 'perceptual'; s.dispatchEvent(new Event('change'))")
    report.expect("policy: set", page.state()["policy"], "perceptual")
    report.expect("policy: the point looked at", page.browser.run(
        "return getComputedStyle(document.querySelector('.eye')).visibility"), "visible")
    page.focus(".restitution")
    page.browser.press(HOME)
    report.expect("restitution: said", page.text(".restitution-value"), "0.00")


def check_inside(page, report):
    """Forwards, backwards, to an event by its line; by buttons and by keys; the bodies stand still."""
    browser = page.browser
    page.browser.run(LIVE + "const [a, b] = live.state.bodies; live.place(0, b.x - 0.3, b.y, a.angle)")
    before, shapes = page.state(), page.shapes()
    report.expect("inside: not yet", before["event"], None)
    report.expect("inside: no list yet", browser.run("return document.querySelector('.events').hidden"), True)
    page.click(".go-next")
    report.expect("inside: next begins", page.state()["event"], 0)
    report.expect("inside: the picture follows", page.shapes() != shapes, True)
    events = browser.run(LIVE + "return live.events")
    report.expect("inside: kinds in their order", [e["kind"] for e in events][0], "level")
    report.expect("inside: the sentence", page.text(".inside .now"), events[0]["sentence"][0].upper() + events[0]["sentence"][1:] + ".")
    report.expect("inside: the finding", page.text(".finding").startswith("Event 1 of "), True)
    page.click(".go-last")
    report.expect("inside: last", page.state()["event"], len(events) - 1)
    page.click(".go-next")
    report.expect("inside: no further", page.state()["event"], len(events) - 1)
    page.focus(".go-next")
    for key, event in ((LEFT, len(events) - 2), (RIGHT, len(events) - 1), (HOME, 0), (LEFT, 0), (RIGHT, 1)):
        browser.press(key)
        report.expect("inside: by key", page.state()["event"], event)
    report.expect("inside: the focus stays", browser.run("return document.activeElement.className"), "go-next")
    contact = next(i for i, e in enumerate(events) if e["kind"] == "contact")
    browser.run("for (const d of document.querySelectorAll('.events details')) d.open = true")
    time.sleep(0.1)
    page.click(f"[data-event=\"{contact}\"]")
    report.expect("inside: by its line", page.state()["event"], contact)
    report.expect("inside: the line is marked", browser.run("return document.querySelector('.events [aria-current]').dataset.event"), str(contact))
    report.expect("inside: a contact is drawn", browser.run("return !!document.querySelector('.marks .normal')"), True)
    report.expect("inside: no impulse yet", browser.run("return !!document.querySelector('.marks .impulse')"), False)
    report.expect("inside: every event has a line", browser.run("return document.querySelectorAll('[data-event]').length"), len(events))
    report.expect("inside: nothing moves", page.state()["hash"], before["hash"])
    page.click(".go-leave")
    report.expect("inside: left", (page.state()["event"], page.shapes() == shapes), (None, True))
    page.click(".go-next")
    page.click(".step")
    report.expect("inside: a step leaves", page.state()["event"], None)
    page.click(".go-next")
    x, y, _ = page.place_of(0)
    page.drag((x, y), (20, 20))
    report.expect("inside: a drag leaves", page.state()["event"], None)
    browser.run(LIVE + "live.place(0, -50, 0, 0)")
    page.click(".go-next")
    report.expect("inside: nothing happens", page.text(".inside .now").startswith("Nothing happens"), True)
    page.click(".reset")


def check_layout(page, report, width, height):
    browser = page.browser
    browser.measure(width, height)
    browser.open(page.path)
    time.sleep(0.5)
    page.click(".go-last")
    at = f"{width}x{height}"
    report.expect(f"{at}: no sideways scrolling", browser.run(
        "return document.documentElement.scrollWidth - document.documentElement.clientWidth"), 0)
    report.expect(f"{at}: words of 11 px or more", browser.run(
        "return [...document.querySelectorAll('svg.stage text, p, dd, dt, li span, output, label')]"
        ".filter(e => e.textContent && parseFloat(getComputedStyle(e).fontSize) < 11).length"), 0)
    picture, controls = browser.run("return ['svg.stage', '.controls'].map(s => {"
                                    "const r = document.querySelector(s).getBoundingClientRect();"
                                    "return [r.left, r.top, r.right, r.bottom]})")
    beside = controls[0] >= picture[2] - 1
    report.expect(f"{at}: side by side", beside, width >= 1000)
    if not beside:
        report.expect(f"{at}: the picture leaves room", picture[3] - picture[1] <= 0.55 * height, True)


def check_without_script(page, report):
    browser = page.browser
    browser.call(browser.session + "/goog/cdp/execute", {"cmd": "Emulation.setScriptExecutionDisabled", "params": {"value": True}})
    browser.open(page.path)
    size = browser.call(browser.session + "/goog/cdp/execute", {"cmd": "DOM.getDocument", "params": {}})
    still = browser.call(browser.session + "/goog/cdp/execute", {"cmd": "DOM.querySelector", "params": {
        "nodeId": size["root"]["nodeId"], "selector": ".still svg"}})
    box = browser.call(browser.session + "/goog/cdp/execute", {"cmd": "DOM.getBoxModel", "params": {"nodeId": still["nodeId"]}})
    report.expect("without JavaScript a picture stands there", box["model"]["width"] > 250, True)


def check(lodlab, folder, browser):
    report = Report()
    path = folder / "near_miss.html"
    made = subprocess.run([lodlab, "page", "near_miss", "--out", str(path)], capture_output=True, text=True)
    report.expect("the page is made", made.returncode, 0)
    page = Page(browser, path)
    report.expect("the page runs", page.ready, True)
    if report.faults:
        return report
    report.expect("no request to any network", browser.run("return performance.getEntriesByType('resource').length"), 0)
    check_sources(page, report)
    check_play(page, report)
    check_drag(page, report)
    check_sliders(page, report)
    check_inside(page, report)
    for width, height in ((1280, 800), (1000, 700), (390, 844), (320, 600)):
        check_layout(page, report, width, height)
    report.expect("complaints", browser.complaints(), [])
    check_without_script(page, report)
    return report


def main(lodlab):
    with tempfile.TemporaryDirectory() as folder:
        return in_browser(lambda browser: check(lodlab, pathlib.Path(folder), browser).faults)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
