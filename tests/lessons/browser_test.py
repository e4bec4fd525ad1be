"""Opens every lesson of a book in headless Chromium, presses keys as a reader would, and checks what is
shown. Speaks the W3C WebDriver protocol to chromedriver; needs nothing but the standard library.

Usage: browser_test.py BOOK    exits 0 when all is well, 1 with a line for each fault, 77 when there is no
                               chromedriver or Chromium
"""

import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import urllib.error
import urllib.request

SKIPPED = 77
LEFT, RIGHT, END, HOME, ENTER = "\ue012", "\ue014", "\ue010", "\ue011", "\ue007"

ARGUMENTS = [
    "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
    "--disable-background-networking", "--disable-component-update", "--disable-sync",
    "--window-size=1280,900", "--allow-file-access-from-files",
]

DIRECT = urllib.request.build_opener(urllib.request.ProxyHandler({}))  # never by a proxy

# What a reader sees of the steps: which is visible, what the controls and the screen reader are told.
STATE = """
const visible = [...document.querySelectorAll('article.step')]
    .filter(step => step.getClientRects().length > 0);
const image = visible[0].querySelector('img');
return {
  visible: visible.map(step => step.id),
  title: visible[0].querySelector('h3').textContent,
  slider: document.querySelector('.scrubber input').value,
  spoken: document.querySelector('.scrubber input').getAttribute('aria-valuetext'),
  count: document.querySelector('.scrubber output').textContent,
  back: document.querySelector('.back').getAttribute('aria-disabled') === 'true',
  next: document.querySelector('.next').getAttribute('aria-disabled') === 'true',
  hash: location.hash,
  drawn: image.complete && image.naturalWidth > 0,
  wide: document.documentElement.scrollWidth - document.documentElement.clientWidth,
};
"""


# Passes every question, so that none keeps the reader.
PASS_ALL = "document.querySelectorAll('form.question .pass').forEach(button => button.click()); scrollTo(0, 0);"

# What a reader sees of the questions of the step that is shown.
QUESTIONS = """
const step = document.querySelector('article.step:not(.away)');
return {
  step: Number(step.id.slice(5)),
  states: [...step.querySelectorAll('form.question')].map(form => form.dataset.state ?? ''),
  replies: [...step.querySelectorAll('.reply')].map(reply => reply.textContent),
  tally: document.querySelector('.tally').textContent.replace('Begin again', '').trim(),
  focus: document.activeElement.tagName,
};
"""

# Answers the first open question of the step that is shown, by its key: rightly, or by a mistake that is foreseen.
ANSWER = """
const form = [...document.querySelectorAll('article.step:not(.away) form.question')]
    .find(one => !one.querySelector('.acts').hidden);
const key = JSON.parse(form.querySelector('.key').textContent);
const rightly = RIGHTLY;
if (key.picks) {
  const marks = [...document.querySelectorAll(`svg.picks[data-question=${form.id}] .pick`)];
  const wanted = key.picks.filter((pick) => pick.right).slice(0, rightly ? undefined : 1).map((pick) => pick.name);
  for (const mark of marks)
    if ((mark.getAttribute('aria-checked') === 'true') !== wanted.includes(mark.dataset.name))
      mark.dispatchEvent(new MouseEvent('click'));
} else if (key.choices) {
  const i = key.choices.findIndex(choice => rightly ? choice.right : !choice.right && choice.reply !== '');
  form.querySelectorAll('input')[i].checked = true;
} else {
  const mistake = key.mistakes.find(one => one.kind === 'value');
  form.querySelector('input').value = String(rightly ? key.value : mistake.value);
}
form.requestSubmit();
return true;
"""


class Browser:
    """One session of headless Chromium with a profile of its own."""

    def __init__(self, driver, browser, profile):
        self.process = subprocess.Popen([driver, "--port=0"], stdout=subprocess.PIPE,
                                        stderr=subprocess.DEVNULL, text=True)
        for line in self.process.stdout:
            found = re.search(r"successfully on port (\d+)", line)
            if found:
                self.address = f"http://127.0.0.1:{found.group(1)}"
                break
        else:
            raise RuntimeError("chromedriver does not say its port")
        try:
            self.begin_session(browser, profile)
        except Exception:
            self.close()
            raise

    def begin_session(self, browser, profile):
        options = {"binary": browser, "args": ARGUMENTS + [f"--user-data-dir={profile}"]}
        answer = self.call("/session", {"capabilities": {"alwaysMatch": {
            "browserName": "chrome", "goog:chromeOptions": options,
            "goog:loggingPrefs": {"browser": "ALL"}}}})
        self.session = f"/session/{answer['sessionId']}"

    def call(self, path, body=None, method="POST"):
        request = urllib.request.Request(
            self.address + path, method=method, headers={"Content-Type": "application/json"},
            data=None if body is None else json.dumps(body).encode())
        try:
            with DIRECT.open(request, timeout=60) as answer:
                return json.load(answer)["value"]
        except urllib.error.HTTPError as refusal:
            raise RuntimeError(json.load(refusal)["value"]["message"]) from None

    def open(self, path, fragment=""):
        self.call(self.session + "/url", {"url": "about:blank"})
        self.call(self.session + "/url", {"url": path.resolve().as_uri() + fragment})

    def run(self, script):
        return self.call(self.session + "/execute/sync", {"script": script, "args": []})

    def press(self, key):
        self.call(self.session + "/actions", {"actions": [{"type": "key", "id": "keys", "actions": [
            {"type": "keyDown", "value": key}, {"type": "keyUp", "value": key}]}]})

    def resize(self, width, height):
        self.call(self.session + "/window/rect", {"width": width, "height": height})

    def measure(self, width, height, dark=False):
        """A window of just this size inside; narrow ones are a telephone's."""
        self.command("Emulation.setDeviceMetricsOverride",
                     {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": width < 600})
        self.command("Emulation.setEmulatedMedia", {"features": [
            {"name": "prefers-color-scheme", "value": "dark" if dark else "light"}]})

    def command(self, name, parameters):
        return self.call(self.session + "/goog/cdp/execute", {"cmd": name, "params": parameters})

    def complaints(self):
        log = self.call(self.session + "/se/log", {"type": "browser"})
        return [entry["message"] for entry in log if entry["level"] == "SEVERE"]

    def close(self):
        try:
            self.call(self.session, method="DELETE")
        except (OSError, AttributeError):
            pass
        self.process.terminate()
        self.process.wait(timeout=30)


class Report:
    def __init__(self):
        self.faults = 0

    def expect(self, what, found, wanted):
        if found != wanted:
            self.faults += 1
            print(f"{what}: found {found!r}, expected {wanted!r}")


def check_steps(browser, page, report):
    name = page.parent.name
    steps = len(re.findall(r'<article class="step"', page.read_text()))
    browser.open(page)
    browser.run(PASS_ALL)
    browser.run("document.querySelector('section.steps').scrollIntoView()")
    titles = {}

    def look(what, number):
        state = browser.run(STATE)
        report.expect(f"{name}, {what}: visible", state["visible"], [f"step-{number}"])
        report.expect(f"{name}, {what}: slider", state["slider"], str(number))
        report.expect(f"{name}, {what}: count", state["count"], f"{number} / {steps}")
        report.expect(f"{name}, {what}: at the start", state["back"], number == 1)
        report.expect(f"{name}, {what}: at the end", state["next"], number == steps)
        report.expect(f"{name}, {what}: spoken", state["spoken"].startswith(f"Step {number} of {steps}: "), True)
        report.expect(f"{name}, {what}: title", titles.setdefault(number, state["title"]), state["title"])
        return state

    look("opened", 1)
    browser.press(LEFT)
    look("left at the start", 1)
    for number in range(2, steps + 1):
        browser.press(RIGHT)
        report.expect(f"{name}: hash", look("right", number)["hash"], f"#step-{number}")
    browser.press(RIGHT)
    look("right at the end", steps)
    browser.run("document.querySelector('.next').focus(); document.querySelector('.next').click()")
    report.expect(f"{name}: the focus stays at the end", browser.run("return document.activeElement.className"), "next")
    browser.run("document.activeElement.blur(); scrollTo(0, document.body.scrollHeight)")
    browser.press(LEFT)
    look("left where the steps are out of sight", steps)
    browser.run("document.querySelector('section.steps').scrollIntoView()")
    for number in range(steps - 1, 0, -1):
        browser.press(LEFT)
        look("left", number)
    browser.run("document.querySelector('.scrubber .next').click()")
    look("button", 2)
    browser.run("document.querySelector('.scrubber input').focus()")
    browser.press(RIGHT)
    look("right on the slider", 3)
    browser.press(END)
    look("end", steps)
    browser.press(HOME)
    look("home", 1)
    browser.open(page, "#step-3")
    look("opened at step 3", 3)
    report.expect(f"{name}: all titles differ", len(set(titles.values())), steps)


def check_questions(browser, page, report):
    """Every question: a foreseen mistake, then the right answer; all of it kept for the next visit."""
    name = page.parent.name
    asked = page.read_text().count('<form class="question"')
    browser.open(page)
    browser.run("localStorage.clear()")
    browser.open(page)
    report.expect(f"{name}: no word before the first answer", browser.run(QUESTIONS)["tally"], "")
    steps = len(re.findall(r'<article class="step"', page.read_text()))
    for number in range(1, steps):
        while "" in (seen := browser.run(QUESTIONS))["states"] or "unclear" in seen["states"]:
            browser.run("document.querySelector('.scrubber .next').click()")
            seen = browser.run(QUESTIONS)
            report.expect(f"{name}, step {number}: the question blocks", seen["step"], number)
            report.expect(f"{name}, step {number}: the question has the focus", seen["focus"] in ("INPUT", "circle"), True)
            for rightly, state in ((False, "wrong"), (True, "right")):
                browser.run(ANSWER.replace("RIGHTLY", json.dumps(rightly)))
                report.expect(f"{name}, step {number}: an answer is {state}", state in browser.run(QUESTIONS)["states"],
                              True)
        report.expect(f"{name}, step {number}: replies", all(browser.run(QUESTIONS)["replies"]), True)
        report.expect(f"{name}, step {number}: a focus after it", browser.run(QUESTIONS)["focus"] != "", True)
        browser.run("document.querySelector('.scrubber .next').click()")
        report.expect(f"{name}: on to", browser.run(QUESTIONS)["step"], number + 1)
    wanted = f"Of {asked} questions: {asked} after a mistake."
    report.expect(f"{name}: the word at the end", browser.run(QUESTIONS)["tally"], wanted)
    browser.open(page)
    report.expect(f"{name}: kept", browser.run(QUESTIONS)["tally"], wanted)
    browser.open(page.parent.parent / "index.html")
    report.expect(f"{name}: kept on the index", browser.run(
        f"return document.querySelector('[data-lesson={name}]').textContent"), wanted)
    browser.open(page)
    browser.run("document.querySelector('.tally button').click()")
    report.expect(f"{name}: begun again", browser.run(QUESTIONS), {
        "step": 1, "states": [""] * len(browser.run(QUESTIONS)["states"]),
        "replies": [""] * len(browser.run(QUESTIONS)["states"]), "tally": "", "focus": "BUTTON"})


def check_picks(browser, page, report):
    """A question that is answered in the picture: by the mouse, by a finger and by keys."""
    name = page.parent.name
    browser.open(page)
    browser.run("localStorage.clear()")
    for width, height in ((1280, 800), (390, 844)):
        hand = "touch" if width < 600 else "mouse"
        browser.measure(width, height)
        browser.open(page)
        number = browser.run("return Number(document.querySelector('svg.picks').closest('article').id.slice(5))")
        browser.open(page, f"#step-{number}")
        browser.run("document.querySelector('article.step:not(.away) svg.picks').scrollIntoView({ block: 'center' })")
        marks = browser.run("return [...document.querySelectorAll('article.step:not(.away) .pick')].map((mark) => {"
                            "const box = mark.getBoundingClientRect(); return [mark.dataset.name, box.left + box.width / 2,"
                            "box.top + box.height / 2, document.elementFromPoint(box.left + box.width / 2, box.top + box.height / 2) === mark]; })")
        report.expect(f"{name}, {width}: the marks lie over the picture", browser.run(
            "const step = document.querySelector('article.step:not(.away)');"
            "const [a, b] = ['img', 'svg.picks'].map((part) => step.querySelector(part).getBoundingClientRect());"
            "return Math.max(Math.abs(a.left - b.left), Math.abs(a.top - b.top), Math.abs(a.right - b.right), Math.abs(a.bottom - b.bottom)) < 1.5"), True)
        report.expect(f"{name}, {width}: each mark is there to be hit", [hit for *_, hit in marks], [True] * len(marks))
        for mark, x, y, _ in marks[:2]:
            browser.call(browser.session + "/actions", {"actions": [
                {"type": "pointer", "id": hand, "parameters": {"pointerType": hand}, "actions": [
                    {"type": "pointerMove", "x": round(x), "y": round(y)}, {"type": "pointerDown", "button": 0},
                    {"type": "pointerUp", "button": 0}]}]})
        picked = "return document.querySelector('article.step:not(.away) .picked output').textContent"
        report.expect(f"{name}, {width}: picked", browser.run(picked), ", ".join(sorted((mark for mark, *_ in marks[:2]), key=int)))
        browser.run("document.querySelectorAll('article.step:not(.away) .pick')[0].focus()")
        browser.press(ENTER)
        report.expect(f"{name}, {width}: dropped by Enter", browser.run(picked), marks[1][0])
        browser.press(" ")
        report.expect(f"{name}, {width}: picked by the space bar", browser.run(picked) != marks[1][0], True)
        report.expect(f"{name}, {width}: still at the step", browser.run("return location.hash"), f"#step-{number}")
    browser.command("Emulation.clearDeviceMetricsOverride", {})


def check_typing(browser, page, report):
    """Letters and arrows in a question's field are an answer; End goes no further than an open question."""
    browser.open(page)
    browser.run("localStorage.clear()")
    browser.open(page)
    browser.run("document.querySelector('.scrubber .next').click()")
    for key in ("q", LEFT, "n"):
        browser.press(key)
    report.expect("typed", browser.run("return document.activeElement.value"), "nq")
    browser.press(ENTER)
    report.expect("unclear", browser.run(QUESTIONS)["states"], ["unclear"])
    browser.run("document.querySelector('.scrubber input').focus()")
    browser.press(END)
    report.expect("end is blocked", browser.run(QUESTIONS)["step"], 1)
    browser.run("document.querySelector('form.question .pass').click()")
    report.expect("passed", browser.run(QUESTIONS)["states"], ["passed"])
    browser.run("document.querySelector('.scrubber input').focus()")
    browser.press(END)
    report.expect("end goes to the next question", browser.run(QUESTIONS)["step"], 2)


def check_looks(browser, page, report):
    name = page.parent.name
    browser.resize(390, 844)
    browser.open(page)
    report.expect(f"{name}: no sideways scrolling on a telephone", browser.run(STATE)["wide"], 0)
    report.expect(f"{name}: every equation is drawn", browser.run(
        "return [...document.querySelectorAll('math')].filter(m => m.getBoundingClientRect().width < 4).length"), 0)
    report.expect(f"{name}: every control has a name", browser.run(
        "return [...document.querySelectorAll('button, input, video')]"
        ".filter(e => !e.getAttribute('aria-label') && !e.labels?.length && !e.textContent.trim()).length"), 0)
    report.expect(f"{name}: no picture without an alt text", browser.run(
        "return [...document.querySelectorAll('img')].filter(i => !i.alt).length"), 0)
    report.expect(f"{name}: pictures are drawn", browser.run(
        "document.querySelectorAll('img').forEach(i => i.loading = 'eager');"
        "return Promise.all([...document.querySelectorAll('img')].map(i => i.decode().then(() => 1, () => 0)))"
        ".then(all => all.includes(0))"), False)
    browser.resize(1280, 900)
    report.expect(f"{name}: nothing is complained of", browser.complaints(), [])


def in_browser(work):
    """The number of faults that work(browser) finds as an exit code; SKIPPED, with a word, where there is no browser."""
    driver = shutil.which("chromedriver")
    chromium = shutil.which("chromium") or shutil.which("google-chrome")
    if not driver or not chromium:
        print("skipped: install chromium and chromium-driver")
        return SKIPPED
    with tempfile.TemporaryDirectory() as profile:
        browser = Browser(driver, chromium, profile)
        try:
            return 1 if work(browser) else 0
        finally:
            browser.close()


def check(browser, book):
    pages = sorted(book.glob("*/index.html"))
    report = Report()
    report.expect("lessons", len(pages), 14)
    for page in pages:
        check_steps(browser, page, report)
        check_questions(browser, page, report)
        check_looks(browser, page, report)
    for lesson in ("distance_test", "traversal"):
        check_picks(browser, book / lesson / "index.html", report)
    check_typing(browser, book / "distance_test/index.html", report)
    browser.open(book / "index.html")
    report.expect("index: links", browser.run(
        "return document.querySelectorAll('.lessons a').length"), len(pages))
    return report.faults


def main(book):
    return in_browser(lambda browser: check(browser, book))


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
