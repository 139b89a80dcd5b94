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


@unittest.skipUnless(browser.CHROMIUM, "there is no Chromium")
class Answered(unittest.TestCase):
    """A worksheet answered in a browser, saved, and graded from its file."""

    def test_worksheet(self):
        lab = browser.Lab()
        self.addCleanup(lab.close)
        command("worksheet", "-o", lab.folder / "student.rkt", examples / "worksheets" / "pendulum.rkt")
        lab.page.goto(lab.address("lab/tree/student.ipynb"))
        lab.page.wait_for_selector(".jp-Notebook-ExecutionIndicator[data-status=idle]",
                                   timeout=120_000, state="attached")
        lab.page.wait_for_timeout(3000)
        made = nbformat.read(lab.folder / "student.ipynb", as_version=4)
        codes = [cell.source for cell in made.cells if cell.cell_type == "code"]
        number = next(k for k, code in enumerate(codes) if " unanswered)" in code)
        name = codes[number].split()[1]
        cell = lab.cell(number)
        cell.locator(".cm-content").click()
        lab.page.keyboard.press("Control+a")
        lab.page.keyboard.insert_text(f"(define {name} 'nonsense)\n(check {name})")
        lab.run_all()
        judged = lab.page.get_by_text(f"1. {name}: ").first
        judged.wait_for(timeout=120_000)
        said = judged.inner_text()
        self.assertRegex(said, "refuted|trivial|no answer could be had")
        if os.environ.get("MECHANICS_LAB_PICTURE"):
            lab.page.screenshot(path=os.environ["MECHANICS_LAB_PICTURE"])
        lab.page.keyboard.press("Control+s")
        for _ in range(100):
            if "nonsense" in (lab.folder / "student.ipynb").read_text():
                break
            lab.page.wait_for_timeout(200)
        graded = output("check", lab.folder / "student.ipynb")
        self.assertEqual(graded.splitlines()[0], said.splitlines()[0])


if __name__ == "__main__":
    unittest.main()
