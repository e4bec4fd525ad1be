"""Plays with the live parts of a book's lessons in headless Chromium, as a reader would.

Usage: live_test.py BOOK PLAYED    PLAYED: what play_lessons wrote. Exits 0 when all is well, 1 with a line for each
                                   fault, 77 when there is no chromedriver or Chromium, or a book without live parts
"""

import pathlib
import sys
import time

from browser_test import HOME, RIGHT, SKIPPED, Report, in_browser

ROOT = "const root = document.querySelector('section.live'); const live = root.live; "
READY = "return !!document.querySelector('section.live').live || document.querySelector('.live .trouble').textContent"
SCRIPTS = "return [...document.scripts].filter(s => s.src.endsWith('/lodlab.js')).length"
WITH_INSIDE = {"traversal", "interruption", "contact_and_impulse"}
WITH_LIVE_PART = {"distance_test", "cover", "circle_tree", "traversal", "interruption", "contact_and_impulse",
                  "many_contacts", "graceful_degradation", "scheduler", "beside_box2d", "too_early"}


def begin(browser, page, report):
    """Opens a lesson and comes to its live part, which is loaded then and no sooner."""
    name = page.parent.name
    browser.open(page)
    report.expect(f"{name}: the module waits for its reader", browser.run(SCRIPTS), 0)
    browser.run("document.querySelector('section.live').scrollIntoView()")
    for _ in range(300):
        ready = browser.run(READY)
        if ready:
            break
        time.sleep(0.1)
    report.expect(f"{name}: the live part runs", ready, True)
    report.expect(f"{name}: loaded once", browser.run(SCRIPTS), 1)
    report.expect(f"{name}: nothing from any network", browser.run(
        "return performance.getEntriesByType('resource').filter(e => !e.name.startsWith('file:')).map(e => e.name)"), [])
    return ready is True


def state(browser):
    return browser.run(ROOT + "return live.state")


def slide(browser, name, key, times=1):
    browser.run(f"document.querySelector('.live .{name}').focus()")
    for _ in range(times):
        browser.press(key)


def has(browser, name):
    return browser.run(f"return !!document.querySelector('.live .{name}')")


def check_bits(browser, name, played, report):
    """The same state as in a program of this machine, at the start and after a hundred frames."""
    wanted = [line.split()[0] for line in (played / f"{name}.txt").read_text().splitlines()[:2]]
    report.expect(f"{name}: the start", state(browser)["hash"], wanted[0])
    browser.run(ROOT + "live.step(100)")
    report.expect(f"{name}: after 100 frames", state(browser)["hash"], wanted[1])
    browser.run("document.querySelector('.live .reset').click()")
    report.expect(f"{name}: put back", state(browser)["hash"], wanted[0])


def check_drag(browser, name, report):
    browser.run("document.querySelector('.live .stage').scrollIntoView({ block: 'center' })")
    before = state(browser)["bodies"][0]
    x, y, scale = browser.run(ROOT + "const b = live.state.bodies[0]; const r = live.svg.getBoundingClientRect();"
                              "const [x, y] = live.drawing.map.at([b.x, b.y]); return [r.left + x, r.top + y, live.drawing.map.scale]")
    browser.call(browser.session + "/actions", {"actions": [
        {"type": "pointer", "id": "hand", "parameters": {"pointerType": "mouse"}, "actions": [
            {"type": "pointerMove", "x": round(x), "y": round(y)}, {"type": "pointerDown", "button": 0},
            {"type": "pointerMove", "x": round(x) + 30, "y": round(y) - 20},
            {"type": "pointerMove", "x": round(x) + 60, "y": round(y) - 40}, {"type": "pointerUp", "button": 0}]}]})
    after = state(browser)["bodies"][0]
    report.expect(f"{name}: dragged", (round((after["x"] - before["x"]) * scale), round((after["y"] - before["y"]) * scale)),
                  (60, 40))
    report.expect(f"{name}: the place in the lesson is kept", browser.run("return document.querySelector('article.step:not(.away)').id"),
                  "step-1")


def check_controls(browser, name, report):
    """Every control that the lesson has changes what it says."""
    if has(browser, "level"):
        slide(browser, "level", HOME)
        report.expect(f"{name}: level", state(browser)["level"], 0)
        report.expect(f"{name}: level in words", browser.run("return document.querySelector('.level-value').textContent"), "level 0")
        slide(browser, "level", RIGHT)
        report.expect(f"{name}: level by a key", state(browser)["level"], 1)
    if has(browser, "budget"):
        slide(browser, "budget", HOME)
        report.expect(f"{name}: budget", state(browser)["budget"], 0)
        report.expect(f"{name}: the bar is told", "of 0" in browser.run("return document.querySelector('.spending').textContent"), True)
    for what in ("policy", "contact_model", "response"):
        if not has(browser, what):
            continue
        for value in browser.run(f"return [...document.querySelector('.live .{what}').options].map(o => o.value)"):
            browser.run(f"const s = document.querySelector('.live .{what}'); s.value = '{value}'; s.dispatchEvent(new Event('change'))")
            report.expect(f"{name}: {what}", state(browser)[what], value)
    if has(browser, "inside"):
        check_inside(browser, name, report)
    if has(browser, "equation"):
        browser.run(ROOT + "const [a, b] = live.state.bodies; live.place(1, a.x + 0.8, a.y, b.angle)")
        contact = state(browser)["contact"]
        report.expect(f"{name}: the equation holds", abs(contact["j"] + (1 + contact["e"]) * contact["closing"] / contact["K"]) < 1e-12
                      or contact["closing"] >= 0, True)
        report.expect(f"{name}: the equation is told", browser.run("return document.querySelectorAll('.equation dd').length"), 4)


def check_inside(browser, name, report):
    """Event by event through the frame, by keys; the page's own steps stay where they are."""
    browser.run("for (const what of ['level', 'budget']) { const s = document.querySelector(`.live .${what}`);"
                "if (s) { s.value = s.max; s.dispatchEvent(new Event('input')); } }")
    browser.run(ROOT + "const [a, b] = live.state.bodies; live.place(1, a.x + 0.8, a.y, b.angle)")
    browser.run("document.querySelector('.live .go-next').focus()")
    browser.press(RIGHT)
    events = browser.run(ROOT + "return live.events")
    report.expect(f"{name}: inside, levels first", [event["kind"] for event in events[:2]], ["level", "level"])
    for number in range(1, min(len(events), 8)):
        browser.press(RIGHT)
        report.expect(f"{name}: inside, event {number}", state(browser)["event"], number)
        report.expect(f"{name}: inside, its sentence", browser.run("return document.querySelector('.live .finding').textContent"),
                      f"Event {number + 1} of {len(events)}: {events[number]['short']}.")
    browser.press(HOME)
    report.expect(f"{name}: inside, the first", state(browser)["event"], 0)
    report.expect(f"{name}: the lesson's step is kept", browser.run("return document.querySelector('article.step:not(.away)').id"), "step-1")
    browser.run("document.querySelector('.live .go-leave').click()")
    report.expect(f"{name}: inside, left", state(browser)["event"], None)
    browser.run("document.querySelector('.live .reset').click()")


def check_eye(browser, report):
    """The point that is looked at is moved by keys, and the levels follow."""
    browser.run("const s = document.querySelector('.live .policy'); s.value = 'perceptual'; s.dispatchEvent(new Event('change'));"
                "const b = document.querySelector('.live .budget'); b.value = Math.round(b.max * 0.75); b.dispatchEvent(new Event('input'))")
    before = [pair["level"] for pair in state(browser)["pairs"]]
    browser.run("document.querySelector('.live .eye').focus()")
    for _ in range(30):
        browser.press(RIGHT)
    after = [pair["level"] for pair in state(browser)["pairs"]]
    report.expect("scheduler: the levels follow the look", before != after, True)


def check_layout(browser, page, report):
    name = page.parent.name
    for width, height in ((1280, 800), (390, 844)):
        browser.measure(width, height)
        if not begin(browser, page, report):
            continue
        at = f"{name}, {width}"
        report.expect(f"{at}: no sideways scrolling", browser.run(
            "return document.documentElement.scrollWidth - document.documentElement.clientWidth"), 0)
        report.expect(f"{at}: words of 11 px or more", browser.run(
            "return [...document.querySelectorAll('.live :is(svg text, p, dd, dt, span, output, label)')]"
            ".filter(e => e.textContent && parseFloat(getComputedStyle(e).fontSize) < 11).length"), 0)
        stage, controls = browser.run("return ['.stage', '.controls'].map(s => { const r = document.querySelector('.live ' + s)"
                                      ".getBoundingClientRect(); return [r.left, r.top, r.right, r.bottom]; })")
        report.expect(f"{at}: side by side", controls[0] >= stage[2] - 1, width >= 1000)
        report.expect(f"{at}: the stage fits", stage[3] - stage[1] <= (0.55 if width < 1000 else 0.9) * height, True)


def check(browser, book, played):
    report = Report()
    pages = [page for page in sorted(book.glob("*/index.html")) if 'class="live"' in page.read_text()]
    report.expect("lessons with a live part", {page.parent.name for page in pages}, WITH_LIVE_PART)
    for page in pages:
        name = page.parent.name
        browser.measure(1280, 800)
        if not begin(browser, page, report):
            continue
        check_bits(browser, name, played, report)
        check_drag(browser, name, report)
        report.expect(f"{name}: inside is offered", has(browser, "inside"), name in WITH_INSIDE)
        check_controls(browser, name, report)
        if name == "scheduler":
            check_eye(browser, report)
        check_layout(browser, page, report)
    report.expect("complaints", browser.complaints(), [])
    browser.command("Emulation.setScriptExecutionDisabled", {"value": True})
    browser.open(pages[0])
    root = browser.command("DOM.getDocument", {})["root"]["nodeId"]
    node = browser.command("DOM.querySelector", {"nodeId": root, "selector": "section.live"})["nodeId"]
    try:
        browser.command("DOM.getBoxModel", {"nodeId": node})
        report.expect("without scripts", "a box", "nothing")
    except RuntimeError:
        pass  # it has no box: it is not there
    return report.faults


def main(book, played):
    if not (book / "lodlab.js").exists():
        print("skipped: the book has no live parts, for lodlab was built without their module")
        return SKIPPED
    return in_browser(lambda browser: check(browser, book, played))


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])))
