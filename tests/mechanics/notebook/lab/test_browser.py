"""What a reader sees, in a real Chromium."""

import os
import time
import unittest

import browser
from browser import Lab, median

CELLS = [
    "(define ((L m k) (up t x v)) (- (* 1/2 m (square v)) (* 1/2 k (square x))))\n"
    "(((Lagrange-equations (L 'm 'k)) (literal-function 'x)) 't)",
    "(for/sum ([k 14]) (* (expt 'x k) ((literal-function 'f) k)))",
    "(verify-solution (L 'm 'k) (lambda (t) (* 'A (cos t))))",
    "(require mechanics/plot)\n(interact ([k 1 10 #:step 1/10])\n  (define f (frame 0 10 -1 1))\n"
    "  (plot-function f (lambda (x) (sin (* k x))) 0 10 0.05)\n  f)",
    "(interact ([n 0 5]) (/ 'a n))",
    "(display \"so far\")\n(car 5)",
]

ANIMATION = ("(define ((L-pendulum g l) (up t a v)) (+ (* 1/2 (square (* l v))) (* g l (cos a))))\n"
             "(define swing (evolve-trajectory (Lagrangian->state-derivative (L-pendulum 9.8 1))\n"
             "                                 (up 0 1 0) 3))\n"
             "(require mechanics/animate)\n(animate swing (draw-pendulum))")


@unittest.skipUnless(browser.CHROMIUM, "there is no Chromium")
class Browser(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.lab = Lab()
        cls.lab.open("cells.ipynb", CELLS)
        cls.lab.run_all()
        cls.lab.cell(5).locator(".jp-OutputArea-output").first.wait_for(timeout=120_000)
        time.sleep(1)
        if os.environ.get("MECHANICS_LAB_PICTURE"):
            cls.lab.page.screenshot(path=os.environ["MECHANICS_LAB_PICTURE"])

    @classmethod
    def tearDownClass(cls):
        cls.lab.close()

    def test_formulas_are_typeset_within_their_cells(self):
        for number in (0, 1):
            formula = self.lab.cell(number).locator("mjx-container").first
            area = self.lab.cell(number).locator(".jp-OutputArea").first
            self.assertGreater(formula.bounding_box()["width"], 40)
            self.assertLessEqual(formula.bounding_box()["width"], area.bounding_box()["width"])

    def test_verdict_has_words_and_formulas(self):
        output = self.lab.cell(2).locator(".jp-OutputArea-output").first
        self.assertIn("refuted: the residual is not zero", output.inner_text())
        self.assertGreaterEqual(output.locator("mjx-container").count(), 5)

    def test_error_is_marked(self):
        text = self.lab.cell(5).inner_text()
        self.assertIn("so far", text)
        self.assertIn("in line 2:", text)

    def picture(self):
        return self.lab.cell(3).locator("img").first.get_attribute("src")

    def test_slider_changes_the_picture(self):
        page, seconds = self.lab.page, []
        self.lab.cell(3).locator(".noUi-handle").first.focus()
        for _ in range(20):
            before, began = self.picture(), time.monotonic()
            page.keyboard.press("ArrowRight")
            while self.picture() == before:
                self.assertLess(time.monotonic() - began, 30, "the picture did not change")
                time.sleep(0.002)
            seconds.append(time.monotonic() - began)
        print(f"\n  a slider's move: median {1000 * median(seconds):.0f} ms ", end="", flush=True)

    def test_error_of_a_body_stands_in_its_place(self):
        cell = self.lab.cell(4)
        self.assertIn("division by zero", cell.inner_text())
        cell.locator(".noUi-handle").first.focus()
        self.lab.page.keyboard.press("ArrowRight")
        cell.locator("mjx-container").first.wait_for(timeout=60_000)
        self.assertNotIn("division by zero", cell.inner_text())

    def test_cell_that_is_typed(self):
        page = self.lab.page
        last = self.lab.cell(len(CELLS) - 1)
        last.locator(".cm-content").click()
        page.keyboard.press("Escape")
        page.keyboard.press("b")
        page.keyboard.press("Enter")
        page.keyboard.type("(sqrt (square 'm))", delay=5)
        page.keyboard.press("Shift+Enter")
        formula = self.lab.cell(len(CELLS)).locator("mjx-container").first
        formula.wait_for(timeout=60_000)


PORTRAITS = [
    "(require mechanics/plot)\n"
    "(define ((L-pendulum g l) (up t a v)) (+ (* 1/2 (square (* l v))) (* g l (cos a))))\n"
    "(define (portrait g)\n"
    "  (plot-phase-portrait (frame -3.2 3.2 -8 8) (Lagrangian->energy (L-pendulum g 1))))\n"
    "(portrait 10)",
    "(interact ([g 1 10 #:step 1/10]) (portrait g))",
    "Lagrange-equations",
]

# Notes the pictures of the second cell that are seen, with their times in ms.
WATCH = """() => {
  const cell = document.querySelectorAll('.jp-Notebook .jp-CodeCell')[1]; let last = '';
  window.seen = [];
  const look = () => {
    const image = cell.querySelector('img');
    if (image && image.complete && image.src != last)
      window.seen.push([performance.now(), last = image.src]);
    requestAnimationFrame(look);
  };
  look();
}"""


@unittest.skipUnless(browser.CHROMIUM, "there is no Chromium")
class Portraits(unittest.TestCase):
    """Phase portraits in default quality, under a slider; a card."""

    @classmethod
    def setUpClass(cls):
        cls.lab = Lab()
        cls.lab.open("portraits.ipynb", PORTRAITS)
        cls.lab.run_all()
        cls.lab.cell(1).locator("img").first.wait_for(timeout=60_000)
        cls.lab.page.evaluate(WATCH)

    @classmethod
    def tearDownClass(cls):
        cls.lab.close()

    def seen(self):
        return self.lab.page.evaluate("window.seen")

    def move(self):
        seconds = []
        self.lab.cell(1).locator(".noUi-handle").first.focus()
        for _ in range(20):
            before, began = len(self.seen()), time.monotonic()
            self.lab.page.keyboard.press("ArrowRight")
            while len(self.seen()) == before:
                self.assertLess(time.monotonic() - began, 30, "the picture did not change")
            seconds.append(time.monotonic() - began)
        print(f"\n  a portrait: median {1000 * median(seconds):.0f} ms ", end="", flush=True)

    def test_moves_and_a_drag_end_with_the_picture_of_the_last_value(self):
        self.move()
        handle = self.lab.cell(1).locator(".noUi-handle").first.bounding_box()
        track = self.lab.cell(1).locator(".noUi-target").first.bounding_box()
        x, y = handle["x"] + handle["width"] / 2, handle["y"] + handle["height"] / 2
        way, mouse = track["x"] + track["width"] + 20 - x, self.lab.page.mouse
        mouse.move(x, y)
        mouse.down()
        before, began = len(self.seen()), time.monotonic()
        for k in range(60):
            mouse.move(x + way * (k + 1) / 60, y)
            time.sleep(0.05)
        shown = (len(self.seen()) - before) / (time.monotonic() - began)
        mouse.up()
        print(f"\n  a drag: {shown:.1f} portraits a second ", end="", flush=True)
        time.sleep(2)
        last = self.lab.cell(0).locator("img").first.get_attribute("src")
        self.assertEqual(self.seen()[-1][1], last)

    def test_card_with_its_formula_typeset(self):
        self.lab.cell(2).locator(".cm-content").click()
        self.lab.page.keyboard.press("End")
        self.lab.page.keyboard.press("Shift+Tab")
        card = self.lab.page.locator(".jp-Tooltip")
        card.locator("mjx-container").first.wait_for(timeout=60_000)
        self.assertIn("(Lagrange-equations L", card.inner_text())
        self.lab.page.keyboard.press("Escape")


@unittest.skipUnless(browser.CHROMIUM, "there is no Chromium")
class OneCell(unittest.TestCase):
    @staticmethod
    def pictures(frame):
        """Those of two seconds."""
        seen = set()
        for _ in range(10):
            seen.add(frame.locator("svg").first.inner_html())
            time.sleep(0.2)
        return seen

    def test_animation_plays(self):
        lab = Lab()
        try:
            lab.open("animation.ipynb", [ANIMATION])
            lab.run_all()
            lab.cell(0).locator("iframe").first.wait_for(timeout=60_000)
            frame = lab.cell(0).locator("iframe").first.content_frame
            frame.locator("svg").first.wait_for(timeout=60_000)
            if len(self.pictures(frame)) == 1:
                frame.locator("button").first.click()
            self.assertGreater(len(self.pictures(frame)), 3)
        finally:
            lab.close()

    def test_a_cell_that_draws_is_run_again(self):
        lab = Lab()
        try:
            lab.open("again.ipynb", ["(require mechanics/plot)\n(define g (frame 0 1 0 1))",
                                     "(plot-point g 0.5 0.5)"])
            lab.run_all()
            lab.cell(1).locator("img").first.wait_for(timeout=60_000)
            lab.cell(1).locator(".cm-content").click()
            lab.page.keyboard.press("Shift+Enter")
            time.sleep(3)
            self.assertEqual(lab.cell(1).locator("img").count(), 1)
        finally:
            lab.close()

    def test_map_explored_by_clicks(self):
        lab = Lab()
        try:
            lab.open("map.ipynb", ["(require mechanics/plot mechanics/book)\n"
                                   "(define win (frame 0 :2pi 0 :2pi))\n"
                                   "(explore-map win (standard-map 0.6) 100)"])
            lab.run_all()
            picture = lab.cell(0).locator("img[draggable=false]").first
            picture.wait_for(timeout=60_000)
            time.sleep(2)
            box, mouse = picture.bounding_box(), lab.page.mouse

            def place(across, down):
                return box["x"] + across * box["width"], box["y"] + down * box["height"]

            def wait_for(text):
                lab.cell(0).get_by_text(text).first.wait_for(timeout=60_000)

            mouse.click(*place(0.5, 0.5))
            wait_for("1 orbit, 101 points")
            mouse.click(*place(0.6, 0.3))
            wait_for("2 orbits, 202 points")
            whole = picture.get_attribute("src")
            mouse.move(*place(0.4, 0.4))
            mouse.down()
            mouse.move(*place(0.7, 0.7), steps=4)
            mouse.up()
            self.until(lambda: picture.get_attribute("src") != whole)
            lab.cell(0).get_by_role("button", name="Whole").click()
            self.until(lambda: picture.get_attribute("src") == whole)
            lab.cell(0).get_by_role("button", name="Undo").click()
            lab.cell(0).get_by_role("button", name="Undo").click()
            lab.cell(0).get_by_role("button", name="Undo").click()
            wait_for("1 orbit, 101 points")
            lab.page.keyboard.press("Control+s")
            saved = lab.folder / "map.ipynb"
            self.until(lambda: '"image/png"' in saved.read_text())
        finally:
            lab.close()

    def until(self, true):
        began = time.monotonic()
        while not true():
            self.assertLess(time.monotonic() - began, 60)
            time.sleep(0.05)

    def test_restart_and_run_again(self):
        lab = Lab()
        try:
            lab.open("restart.ipynb", ["(define k 2)\n(* k 'a)"])
            lab.run_all()
            lab.cell(0).locator("mjx-container").first.wait_for(timeout=60_000)
            lab.menu("Kernel", "Restart Kernel and Clear Outputs of All Cells…")
            lab.page.click(".jp-Dialog button.jp-mod-warn")
            lab.cell(0).locator("mjx-container").first.wait_for(state="detached", timeout=60_000)
            lab.run_all()
            lab.cell(0).locator("mjx-container").first.wait_for(timeout=60_000)
        finally:
            lab.close()
