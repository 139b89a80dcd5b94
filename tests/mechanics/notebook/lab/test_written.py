"""Notebooks that are written with their results: valid, run again with the same, and converted."""

import os
import pathlib
import subprocess
import tempfile
import unittest

import browser
import nbformat
from nbclient import NotebookClient
from nbconvert import HTMLExporter

root = pathlib.Path(__file__).parents[4]
examples = root / "examples" / "mechanics"


def command(*arguments):
    subprocess.run([os.environ.get("RACKET", "racket"), "-l-", "mechanics/lang/command/raco",
                    *map(str, arguments)], check=True, stdout=subprocess.DEVNULL)


def output(*arguments):
    return subprocess.run([os.environ.get("RACKET", "racket"), "-l-", "mechanics/lang/command/raco",
                           *map(str, arguments)], stdout=subprocess.PIPE, text=True).stdout


def texts(notebook):
    """What cells print, and the plain texts of their results."""
    return [[output.get("text") or output["data"]["text/plain"] for output in cell.get("outputs", [])
             if output.output_type in ("stream", "display_data")]
            for cell in notebook.cells]


class Written(unittest.TestCase):
    def written(self, name):
        command("notebook", "--run", "-o", self.folder / "made.ipynb", examples / name)
        return nbformat.read(self.folder / "made.ipynb", as_version=4)

    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.folder = pathlib.Path(place.name)

    def test_a_program_gives_the_same_in_the_kernel(self):
        for name in ("chapter-1/driven-pendulum.rkt", "questions/triangle-points.rkt"):
            with self.subTest(name):
                made = self.written(name)
                nbformat.validate(made)
                before = texts(made)
                NotebookClient(made, timeout=120, kernel_name="mechanics",
                               resources={"metadata": {"path": str(examples / name).rsplit("/", 1)[0]}}
                               ).execute()
                self.assertEqual(texts(made), before)

    def test_a_page_of_it_shows_formulas_and_pictures(self):
        page, _ = HTMLExporter().from_notebook_node(self.written("figures/figure-2-2.rkt"))
        self.assertTrue("data:image/svg+xml" in page)
        page, _ = HTMLExporter().from_notebook_node(self.written("chapter-1/driven-pendulum.rkt"))
        self.assertTrue("\\displaystyle" in page)

    def test_a_worksheet_is_judged_in_its_cells_and_by_the_command(self):
        command("worksheet", "-o", self.folder / "student.rkt", examples / "worksheets" / "pendulum.rkt")
        made = nbformat.read(self.folder / "student.ipynb", as_version=4)
        nbformat.validate(made)
        NotebookClient(made, timeout=120, kernel_name="mechanics").execute()
        self.assertIn("not answered", texts(made)[-1][0])
        self.assertTrue("not answered" in HTMLExporter().from_notebook_node(made)[0])


NUMBERS = """#lang mechanics/worksheet
(title "Numbers of one's own")
(deadline "2126-11-20 12:00" #:per-day 1/10)
(credit #:sign 1/2)
(parameters #:seed 7 [l #:from 1 #:to 9 #:step 1/2])
(text "A rod of " l " m.")
(exercise double number (format "Twice ~a?" l) (key (* 2 l)) (points 2))
(exercise root expression "The frequency?" (key (sqrt (/ 'g l))) (points 2))
"""


@unittest.skipUnless(browser.CHROMIUM, "there is no Chromium")
class Answered(unittest.TestCase):
    """A worksheet answered in a browser, saved, and graded from its file."""

    def opened(self, worksheet, *options):
        lab = browser.Lab()
        self.addCleanup(lab.close)
        (lab.folder / "mine.rkt").write_text(worksheet)
        command("worksheet", *options, "-o", lab.folder / "student.rkt", lab.folder / "mine.rkt")
        lab.page.goto(lab.address("lab/tree/student.ipynb"))
        lab.page.wait_for_selector(".jp-Notebook-ExecutionIndicator[data-status=idle]",
                                   timeout=120_000, state="attached")
        lab.page.wait_for_timeout(3000)
        return lab

    def answer(self, lab, number, answer):
        """In the hole of that number; the name of its exercise."""
        made = nbformat.read(lab.folder / "student.ipynb", as_version=4)
        codes = [cell.source for cell in made.cells if cell.cell_type == "code"]
        place = [k for k, code in enumerate(codes) if " unanswered)" in code][number]
        name = codes[place].split()[1]
        lab.cell(place).locator(".cm-content").click()
        lab.page.keyboard.press("Control+a")
        lab.page.keyboard.insert_text(f"(define {name} {answer})\n(check {name})")
        return name

    def judged(self, lab, text):
        found = lab.page.get_by_text(text).first
        found.wait_for(timeout=120_000)
        return found.inner_text()

    def graded(self, lab, answer, *options):
        lab.page.keyboard.press("Control+s")
        for _ in range(100):
            if answer in (lab.folder / "student.ipynb").read_text():
                break
            lab.page.wait_for_timeout(200)
        return output("check", lab.folder / "student.ipynb", *options).splitlines()

    def test_worksheet(self):
        lab = self.opened((examples / "worksheets" / "pendulum.rkt").read_text())
        name = self.answer(lab, 0, "'nonsense")
        lab.run_all()
        said = self.judged(lab, f"1. {name}: ")
        self.assertRegex(said, "refuted|trivial|no answer could be had")
        if os.environ.get("MECHANICS_LAB_PICTURE"):
            lab.page.screenshot(path=os.environ["MECHANICS_LAB_PICTURE"])
        self.assertEqual(self.graded(lab, "nonsense")[0], said.splitlines()[0])

    def test_numbers_of_ones_own(self):
        lab = self.opened(NUMBERS, "--student", "ann@uni.edu")
        for text in ("A rod of ", "costs 10 % of the points"):
            lab.page.locator(".jp-RenderedMarkdown").get_by_text(text).first.wait_for(timeout=120_000)
        self.answer(lab, 0, "(* 2 l)")
        self.answer(lab, 1, "(* -1 (sqrt (/ 'g l)))")
        lab.run_all()
        said = [self.judged(lab, "1. double: "), self.judged(lab, "2. root: ")]
        self.assertIn("1. double: right (2 of 2 points)", said[0])
        self.assertIn("2. root: partly right (1 of 2 points)\n   the sign is the opposite", said[1])
        graded = self.graded(lab, "sqrt (/ 'g l)", "--worksheet", lab.folder / "mine.rkt",
                             "--student", "ann@uni.edu")
        self.assertEqual(graded[:2], ["1. double: right (2 of 2 points)",
                                      "2. root: partly right (1 of 2 points)"])
        self.assertEqual(graded[-1], "3 of 4 points.")


if __name__ == "__main__":
    unittest.main()
