"""Measures whether each step of a book is whole in a window: its words and its picture, or its picture and its
questions where both do not fit together. Also what is too small to read or lies outside.

Usage: fit_test.py BOOK [--table]   exits 0 when every step fits, 1 with a line for each that does not, 77 without
                                    chromedriver or Chromium
"""

import pathlib
import sys

from browser_test import in_browser

WINDOWS = ((1280, 800), (390, 844))
SMALLEST_OF_PICTURE = 15  # units of a picture: its smallest words
SMALLEST_ON_SCREEN = 11  # pixels

# Everything of the step that is shown stands below the controls and above the window's foot; on a wide window words
# and picture stand side by side, on a narrow one the picture takes at most 55 % of the height.
MEASURE = """
// Pixels for one unit of the picture: that of the window's width, fitted into its box.
const unitOf = (image) => {
  const narrow = image.parentElement.querySelector('source');
  const drawn = narrow && image.currentSrc.endsWith(narrow.srcset) ? narrow : image;
  const box = image.getBoundingClientRect();
  return Math.min(box.width / drawn.getAttribute('width'), box.height / drawn.getAttribute('height'));
};
const measure = () => {
const scrubber = document.querySelector('.scrubber').getBoundingClientRect();
const step = [...document.querySelectorAll('article.step')].find(s => s.getClientRects().length > 0);
const parts = [...step.querySelectorAll('h3, figure, .words, .questions')].filter(e => e.getClientRects().length > 0);
const boxes = parts.map(e => e.getBoundingClientRect());
const image = step.querySelector('img').getBoundingClientRect();
const words = parts.find(e => e.matches('.words, .questions')).getBoundingClientRect();
return {
  step: Number(step.id.slice(5)),
  foot: Math.round(Math.max(...boxes.map(b => b.bottom))),
  head: Math.round(Math.min(...boxes.map(b => b.top)) - scrubber.bottom),
  picture: image.height / innerHeight,
  beside: words.left >= image.right,
  split: step.classList.contains('split'),
  asking: step.classList.contains('asking'),
  wide: document.documentElement.scrollWidth - innerWidth,
  unit: unitOf(step.querySelector('img')),
  height: innerHeight,
};
};
"""
# The longest reply to each question of the step that is shown, as it stands after a wrong answer.
LONGEST_REPLY = """
const answerAtLength = () => {
for (const form of document.querySelectorAll('article.step:not(.away) form.question')) {
  const key = JSON.parse(form.querySelector('.key').textContent);
  const replies = [key.reply ?? '', ...(key.choices ?? key.mistakes).map(c => c.reply)];
  const longest = replies.sort((a, b) => b.length - a.length)[0];
  form.querySelector('.reply').innerHTML = longest + ' <em>Try again, or pass.</em>';
}
dispatchEvent(new Event('resize'));
};
"""
# Each step as it is opened, and with its questions where these are shown apart: [name, what was measured] of each.
ALL_STEPS = MEASURE + LONGEST_REPLY + """
const settled = () => new Promise(done => requestAnimationFrame(() => setTimeout(done)));
const count = document.querySelectorAll('article.step').length;
return (async () => {
  await document.fonts.ready;
  document.querySelectorAll('img').forEach(image => { image.loading = 'eager'; });
  const steps = [];
  for (let number = 1; number <= count; ++number) {
    location.hash = `#step-${number}`;
    await settled();
    answerAtLength();
    document.querySelector('section.steps').scrollIntoView({ behavior: 'instant' });
    await settled();
    const views = [['whole', measure()]];
    if (views[0][1].split) {
      views[0][0] = 'words';
      document.querySelector('.scrubber .next').click();
      answerAtLength();
      await settled();
      views.push(['question', measure()]);
    }
    steps.push(views);
  }
  return steps;
})();
"""


def faults_of(found, width):
    faults = []
    if found["foot"] > found["height"]:
        faults.append(f"ends {found['foot'] - found['height']} px below the window")
    if found["head"] < -1:
        faults.append("begins behind the controls")
    if found["wide"] > 0:
        faults.append("is wider than the window")
    if found["unit"] * SMALLEST_OF_PICTURE < SMALLEST_ON_SCREEN:
        faults.append(f"has words of {found['unit'] * SMALLEST_OF_PICTURE:.1f} px in its picture")
    if width >= 1000 and not found["beside"]:
        faults.append("words and picture are not side by side")
    if width < 1000 and found["picture"] > 0.55:
        faults.append(f"picture takes {found['picture']:.0%} of the height")
    return faults


def check(browser, book, wants_table):
    faults = []
    for width, height in WINDOWS:
        browser.measure(width, height)
        fitting = steps = 0
        smallest = 100
        for page in sorted(book.glob("*/index.html")):
            browser.open(page)
            for number, views in enumerate(browser.run(ALL_STEPS), 1):
                wrong = [f"{name} {fault}" for name, found in views for fault in faults_of(found, width)]
                steps += 1
                fitting += not wrong
                smallest = min(smallest, *(found["unit"] * SMALLEST_OF_PICTURE for _, found in views))
                faults += [f"{page.parent.name} step {number} at {width}x{height}: {what}" for what in wrong]
                if wants_table:
                    print(page.parent.name, number, f"{width}x{height}", "split" if len(views) > 1 else "whole",
                          max(found["foot"] for _, found in views), "; ".join(wrong) or "fits")
        print(f"{width}x{height}: {fitting} of {steps} steps fit; words in pictures of at least {smallest:.1f} px")
    print("\n".join(faults))
    return len(faults)


def main(book, wants_table):
    return in_browser(lambda browser: check(browser, book, wants_table))


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]), "--table" in sys.argv))
