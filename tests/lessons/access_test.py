"""Asks axe-core what of a book a reader cannot use who sees, hears or moves otherwise: the index and every step of every
lesson with its live part, on a wide and on a narrow window, in both colour schemes.

Usage: access_test.py BOOK AXE [PAGE ...]   AXE: axe.min.js of axe-core; PAGE: further pages, such as live ones. Exits 0
                                            when there is no violation, 1 with a line for each, 77 without AXE,
                                            chromedriver or Chromium
"""

import pathlib
import sys
import time

from browser_test import SKIPPED, in_browser

WINDOWS = ((1280, 800), (390, 844))
RUN = """
const done = arguments[arguments.length - 1];
axe.run(WHERE, { resultTypes: ['violations'] }).then(
  (found) => done(found.violations.map((one) => `${one.id}: ${one.nodes[0].html.slice(0, 160)}`)),
  (error) => done([String(error)]));
"""


def wait_for_live_part(browser):
    if not browser.run("return !!document.querySelector('section.live')"):
        return
    browser.run("document.querySelector('section.live').scrollIntoView()")
    for _ in range(300):
        if browser.run("return !!document.querySelector('section.live').live"):
            return
        time.sleep(0.1)


def violations_of(browser, page, axe):
    browser.open(page)
    wait_for_live_part(browser)
    browser.run(axe + "; window.axe = axe;")
    steps = browser.run("return document.querySelectorAll('article.step').length")
    found = {}
    for step in range(1, max(steps, 1) + 1):
        if steps > 0:
            browser.run(f"location.hash = '#step-{step}'")
        where = "document" if step == 1 else "document.querySelector('article.step:not(.away)')"
        said = browser.call(browser.session + "/execute/async", {"script": RUN.replace("WHERE", where), "args": []})
        for violation in said:
            found.setdefault(violation, step)
    return found


def check(browser, book, axe, more):
    faults = 0
    browser.call(browser.session + "/timeouts", {"script": 60000})
    for width, height in WINDOWS:
        for dark in (False, True):
            browser.measure(width, height, dark)
            for page in [book / "index.html", *sorted(book.glob("*/index.html")), *more]:
                for violation, step in violations_of(browser, page, axe.read_text()).items():
                    faults += 1
                    scheme = "dark" if dark else "light"
                    print(f"{page.parent.name}/{page.name}, {width}, {scheme}, step {step}: {violation}")
    return faults


def main(book, axe, more):
    if not axe.is_file():
        print("skipped: name axe.min.js of axe-core by LODLAB_AXE")
        return SKIPPED
    return in_browser(lambda browser: check(browser, book, axe, more))


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), [pathlib.Path(page) for page in sys.argv[3:]]))
